/* Mixing, every one of 21 steps: the noise's covariance is the transport barycentre's, computed here from the two ends
 * alone, and nothing jumps where a map goes from one step to the next. */
#include "covariance.h"
#include "estimate.h"
#include <complex.h>
#include <stdlib.h>
#include <string.h>

#define STEPS 21
#define CHANNELS 2
#define GRID 96 /* of frequencies */

static weft_context *context;
static weft_model *ends[2], *mixed;
static weft_model_info info[2];

static weft_model *texton_of(Grain grain, float mean, float contrast)
{
    weft_image photo = new_grain(grain, 48, 48, CHANNELS, 9);
    weft_texton_options options = WEFT_TEXTON_OPTIONS_INIT;
    weft_model *model = NULL;
    options.support = 16;
    for (size_t i = 0; i < (size_t)48 * 48 * CHANNELS; ++i)
        values(&photo)[i] = mean + contrast * (values(&photo)[i] - 0.5f);
    assert_ok(weft_analyze_texton(context, &photo, &options, NULL, NULL, &model));
    free_image(&photo);
    return model;
}

static int begin(void **state)
{
    const weft_model_info fresh = WEFT_MODEL_INFO_INIT;
    (void)state;
    context = new_context(NULL, 0);
    ends[0] = texton_of(GRAIN_STREAKS, 0.4f, 1);
    ends[1] = texton_of(GRAIN_SOFT, 0.7f, 0.6f);
    assert_ok(weft_model_mix(context, ends[0], ends[1], 0, STEPS, &mixed));
    for (int e = 0; e < 2; ++e) {
        info[e] = fresh;
        assert_ok(weft_model_get(ends[e], &info[e]));
    }
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_model_free(mixed);
    weft_model_free(ends[1]);
    weft_model_free(ends[0]);
    weft_context_free(context);
    return 0;
}

/* A texture of the mixed model that `map` steers. */
static weft_texture *new_mixed(const weft_image *map, float scale, uint64_t seed)
{
    weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    weft_texture *texture = NULL;
    options.mix = map;
    options.mix_scale = scale;
    options.seed = seed;
    assert_ok(weft_texture_create(context, mixed, &options, &texture));
    return texture;
}

static double complex wave(int k)
{
    const double angle = 2 * 3.14159265358979323846 * (k % GRID) / GRID;
    return cexp(angle * (double complex)I);
}

/* The texton's transform, all channels of a frequency together. */
typedef struct Spectrum {
    double complex at[GRID][GRID][CHANNELS];
} Spectrum;

static void transform(const weft_model *model, Spectrum *spectrum)
{
    static double complex rows[GRID][GRID];
    weft_image texton = part_of(model, 0);
    memset(spectrum, 0, sizeof *spectrum);
    for (uint32_t c = 0; c < CHANNELS; ++c) {
        memset(rows, 0, sizeof rows);
        for (int y = 0; y < (int)texton.height; ++y)
            for (int k = 0; k < GRID; ++k)
                for (int x = 0; x < (int)texton.width; ++x)
                    rows[y][k] += (double)value_at(&texton, (uint32_t)x, (uint32_t)y, c) * conj(wave(k * x));
        for (int l = 0; l < GRID; ++l)
            for (int k = 0; k < GRID; ++k)
                for (int y = 0; y < (int)texton.height; ++y) spectrum->at[l][k][c] += rows[y][k] * conj(wave(l * y));
    }
    free_image(&texton);
}

/* Xia et al. 2014, equation 10 for spot noise: u is turned by the phase of <u, v> in every frequency, so that the
 * straight line from u to v is the path of optimal transport. */
static void align(Spectrum *u, const Spectrum *v)
{
    for (int l = 0; l < GRID; ++l)
        for (int k = 0; k < GRID; ++k) {
            double complex product = 0;
            for (int c = 0; c < CHANNELS; ++c) product += conj(u->at[l][k][c]) * v->at[l][k][c];
            const double complex turn = cabs(product) > 1e-30 ? product / cabs(product) : 1;
            for (int c = 0; c < CHANNELS; ++c) u->at[l][k][c] *= turn;
        }
}

/* Spectrum of the B-spline's autocorrelation at integer lags. */
static double spline_power(int k)
{
    const double middle = spline_autocorrelation(WEFT_INTERPOLATION_LINEAR, 0);
    return middle + 2 * spline_autocorrelation(WEFT_INTERPOLATION_LINEAR, 1) * creal(wave(k));
}

/* Covariance at a lag of the noise whose texton is (1 - rho) u + rho v. */
static double barycentre(const Spectrum *u, const Spectrum *v, double rho, uint32_t a, uint32_t b, int dx, int dy)
{
    double sum = 0;
    for (int l = 0; l < GRID; ++l)
        for (int k = 0; k < GRID; ++k) {
            const double complex first = (1 - rho) * u->at[l][k][a] + rho * v->at[l][k][a];
            const double complex second = (1 - rho) * u->at[l][k][b] + rho * v->at[l][k][b];
            const double complex shift = wave((k * dx + l * dy) % GRID + GRID);
            sum += creal(conj(first) * second * shift) * spline_power(k) * spline_power(l);
        }
    return sum / ((double)GRID * GRID);
}

enum { LAGS = 5, SIDE = 80 };
static const int lags[LAGS][2] = {{0, 0}, {1, 0}, {0, 1}, {2, -2}, {5, 1}};

typedef struct Measured {
    Estimate mean[CHANNELS], covariance[LAGS][CHANNELS][CHANNELS];
} Measured;

/* Adds what a window of the texture says, about the mean that is promised. */
static void measure(const weft_image *image, const double *expected, Measured *measured)
{
    for (uint32_t a = 0; a < CHANNELS; ++a) {
        double sum = 0;
        for (uint32_t i = 0; i < SIDE * SIDE; ++i) sum += (double)values(image)[i * CHANNELS + a];
        add(&measured->mean[a], sum / (SIDE * SIDE));
        for (uint32_t b = 0; b < CHANNELS; ++b)
            for (int l = 0; l < LAGS; ++l) {
                double product = 0;
                for (int y = 2; y < SIDE - 1; ++y)
                    for (int x = 0; x < SIDE - 5; ++x)
                        product += ((double)value_at(image, (uint32_t)x, (uint32_t)y, a) - expected[a]) *
                                   ((double)value_at(image, (uint32_t)(x + lags[l][0]), (uint32_t)(y + lags[l][1]), b) -
                                    expected[b]);
                add(&measured->covariance[l][a][b], product / ((SIDE - 3) * (SIDE - 5)));
            }
    }
}

static void every_step_is_the_barycentre(void **state)
{
    (void)state;
    static Spectrum u, v;
    transform(ends[0], &u);
    transform(ends[1], &v);
    align(&u, &v);
    for (int k = 0; k < STEPS; ++k) {
        const double rho = (double)k / (STEPS - 1);
        float step = (float)rho;
        const weft_image map = {&step, 0, 1, 1, 1, WEFT_FORMAT_F32};
        double expected[CHANNELS];
        Measured measured;
        memset(&measured, 0, sizeof measured);
        for (int c = 0; c < CHANNELS; ++c)
            expected[c] = (1 - rho) * (double)info[0].mean[c] + rho * (double)info[1].mean[c];
        for (uint32_t i = 0; i < scaled(60, 24); ++i) {
            weft_texture *texture = new_mixed(&map, 0, 70 + i);
            weft_image image = rendered(texture, -1000 * (int64_t)i, 5, 0, SIDE, SIDE, CHANNELS);
            measure(&image, expected, &measured);
            free_image(&image);
            weft_texture_free(texture);
        }
        for (uint32_t a = 0; a < CHANNELS; ++a) {
            const double variance = barycentre(&u, &v, rho, a, a, 0, 0);
            assert_expected(&measured.mean[a], expected[a], 0.25 * sqrt(variance), "mean of step", k);
            for (uint32_t b = 0; b < CHANNELS; ++b)
                for (int l = 0; l < LAGS; ++l)
                    assert_expected(&measured.covariance[l][a][b],
                                    barycentre(&u, &v, rho, a, b, lags[l][0], lags[l][1]), 0.3 * variance,
                                    "covariance of step", k);
        }
    }
}

/* Least and greatest mean square difference of horizontal neighbours over all steps, as the model's textons promise it.
 */
static void promised_differences(double *least, double *greatest)
{
    *least = 1e30;
    *greatest = 0;
    for (uint32_t k = 0; k < STEPS; ++k) {
        weft_image texton = part_of(mixed, k);
        const double difference = 2 * (noise_covariance(&texton, WEFT_INTERPOLATION_LINEAR, 0, 0, 0, 0) -
                                       noise_covariance(&texton, WEFT_INTERPOLATION_LINEAR, 0, 0, 1, 0));
        *least = fmin(*least, difference);
        *greatest = fmax(*greatest, difference);
        free_image(&texton);
    }
}

/* A map that goes up the steps and down again: neighbours across its borders differ no more than within a step, but for
 * the mean's own step. */
static void nothing_jumps(void **state)
{
    (void)state;
    enum { TEXELS = 2 * STEPS - 2, SCALE = 8, WIDTH = TEXELS * SCALE, HEIGHT = 96 };
    static Estimate difference[WIDTH];
    float ramp[TEXELS];
    const weft_image map = {ramp, 0, TEXELS, 1, 1, WEFT_FORMAT_F32};
    for (int i = 0; i < TEXELS; ++i) ramp[i] = (float)(i < STEPS ? i : TEXELS - i) / (STEPS - 1);
    memset(difference, 0, sizeof difference);
    for (uint32_t i = 0; i < scaled(60, 24); ++i) {
        weft_texture *texture = new_mixed(&map, SCALE, 300 + i);
        weft_image image = rendered(texture, 0, 40, 0, WIDTH + 1, HEIGHT, CHANNELS);
        for (uint32_t x = 0; x < WIDTH; ++x) {
            double sum = 0;
            for (uint32_t y = 0; y < HEIGHT; ++y) {
                const double step = (double)value_at(&image, x + 1, y, 0) - (double)value_at(&image, x, y, 0);
                sum += step * step;
            }
            add(&difference[x], sum / HEIGHT);
        }
        free_image(&image);
        weft_texture_free(texture);
    }
    double least, greatest;
    promised_differences(&least, &greatest);
    const double mean_step = ((double)info[1].mean[0] - (double)info[0].mean[0]) / (STEPS - 1);
    for (int x = 0; x < WIDTH; ++x) {
        const double mean = mean_of(&difference[x]), half = half_of(&difference[x]);
        const int fine = mean + half >= least && mean - half <= greatest + mean_step * mean_step;
        if (!fine) print_error("column %d: %g +- %g, steps have %g to %g\n", x, mean, half, least, greatest);
        assert_true(fine && half < greatest);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_step_is_the_barycentre),
        cmocka_unit_test(nothing_jumps),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
