/* What the paper of wavelet noise by example promises: variances, spectra of bands, recovered weights, prefiltering. */
#include "estimate.h"
#include "wavelets.h"
#include <stdlib.h>

static weft_context *context;

static int begin(void **state)
{
    (void)state;
    context = new_context(NULL, 0);
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_context_free(context);
    return 0;
}

/* One channel, one band of that weight, mean 0.5. */
static weft_texture *new_band(uint32_t band, float weight, uint64_t seed)
{
    weft_wavelet wavelet = plain_wavelet(1, band + 1);
    wavelet.weight[band][0] = weight;
    weft_model *model = new_wavelet(context, &wavelet);
    weft_texture *texture = new_texture(context, model, 0, seed, 0);
    weft_model_free(model);
    return texture;
}

/* Over the centres of pixels, whatever the place: weight^2. */
static void variance_at_pixel_centres(void **state)
{
    (void)state;
    enum { SIDE = 160 };
    for (uint32_t band = 0; band < 4; ++band) {
        Estimate mean = {0, 0, 0}, variance = {0, 0, 0};
        for (uint32_t i = 0; i < 24; ++i) {
            weft_texture *texture = new_band(band, 0.2f, i);
            weft_image image = rendered(texture, 1000 * (int64_t)i, -7, 0, SIDE, SIDE, 1);
            double sum = 0, squares = 0;
            for (size_t k = 0; k < SIDE * SIDE; ++k) {
                const double value = (double)values(&image)[k] - 0.5;
                sum += value;
                squares += value * value;
            }
            add(&mean, sum / (SIDE * SIDE));
            add(&variance, squares / (SIDE * SIDE));
            free_image(&image);
            weft_texture_free(texture);
        }
        assert_expected(&mean, 0, 0.02, "mean of band", (int)band);
        assert_expected(&variance, 0.04, 0.01, "variance of band", (int)band);
    }
}

/* In space: over all positions. */
static void variance_in_space(void **state)
{
    (void)state;
    enum { COUNT = 3000 };
    static weft_solid_point points[COUNT];
    static float out[COUNT];
    for (uint32_t band = 0; band < 3; ++band) {
        Random random = {band};
        Estimate mean = {0, 0, 0}, variance = {0, 0, 0};
        for (uint32_t i = 0; i < 24; ++i) {
            weft_texture *texture = new_band(band, 0.2f, i);
            for (int k = 0; k < COUNT; ++k)
                for (int axis = 0; axis < 3; ++axis) points[k].position[axis] = 2000 * random_unit(&random) - 1000;
            assert_ok(weft_texture_sample_solid(texture, COUNT, points, out));
            double sum = 0, squares = 0;
            for (int k = 0; k < COUNT; ++k) {
                sum += (double)out[k] - 0.5;
                squares += ((double)out[k] - 0.5) * ((double)out[k] - 0.5);
            }
            add(&mean, sum / COUNT);
            add(&variance, squares / COUNT);
            weft_texture_free(texture);
        }
        assert_expected(&mean, 0, 0.02, "mean in space of band", (int)band);
        assert_expected(&variance, 0.04, 0.01, "variance in space of band", (int)band);
    }
}

/* Figure 3 of the paper: a band's power lies in its octave, max(|fx|, |fy|) within 2^-(b+2)..2^-(b+1), and its
 * neighbours. */
static void bands_keep_to_their_octaves(void **state)
{
    (void)state;
    enum { SIDE = 512 };
    for (uint32_t band = 0; band < 5; ++band) {
        weft_texture *texture = new_band(band, 0.2f, 77 + band);
        weft_image image = rendered(texture, 0, 0, 0, SIDE, SIDE, 1),
                   spectrum = new_image(SIDE, SIDE, 1, WEFT_FORMAT_F32);
        assert_ok(weft_power_spectrum(context, &image, &spectrum));
        const double low = ldexp(SIDE, -(int)band - 3), high = ldexp(SIDE, -(int)band);
        double all = 0, inside = 0, own = 0;
        for (int y = 0; y < SIDE; ++y)
            for (int x = 0; x < SIDE; ++x) {
                const double power = (double)value_at(&spectrum, (uint32_t)x, (uint32_t)y, 0);
                const int fx = abs(x - SIDE / 2), fy = abs(y - SIDE / 2), f = fx > fy ? fx : fy;
                all += power;
                if (f >= low && f <= high) inside += power;
                if (f >= 2 * low && f <= high / 2) own += power;
            }
        if (!(all - inside < 0.02 * all))
            print_error("band %u: %g of the power is elsewhere\n", band, 1 - inside / all);
        assert_true(all - inside < 0.02 * all);
        assert_true(own > 0.5 * all);
        free_image(&spectrum);
        free_image(&image);
        weft_texture_free(texture);
    }
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Figure 5 of the paper, for the bands whose octave holds 1000 frequencies or more: 3/4 side^2 / 4^b. */
static void weights_are_recovered(void **state)
{
    (void)state;
    enum { DRAWS = 20, BANDS = 6 };
    const uint32_t side = scaled(512, 256), bands = scaled(4, 3);
    static double error[BANDS][DRAWS];
    Random random = {2009};
    weft_wavelet_options options = WEFT_WAVELET_OPTIONS_INIT;
    options.gaussian = 1;
    options.bands = BANDS;
    for (uint32_t i = 0; i < DRAWS; ++i) {
        weft_wavelet wavelet = plain_wavelet(1, BANDS), learnt = WEFT_WAVELET_INIT;
        for (uint32_t b = 0; b < BANDS; ++b) wavelet.weight[b][0] = (float)(0.1 * random_unit(&random));
        weft_model *model = new_wavelet(context, &wavelet), *again = NULL;
        weft_texture *texture = new_texture(context, model, 0, i, 0);
        weft_image image = rendered(texture, 0, 0, 0, side, side, 1);
        assert_ok(weft_analyze_wavelet(context, &image, &options, NULL, NULL, &again));
        assert_ok(weft_model_get_wavelet(again, &learnt));
        assert_int_equal(learnt.bands, BANDS);
        for (uint32_t b = 0; b < BANDS; ++b)
            error[b][i] = fabs((double)learnt.weight[b][0] / (double)wavelet.weight[b][0] - 1);
        free_image(&image);
        weft_texture_free(texture);
        weft_model_free(again);
        weft_model_free(model);
    }
    for (uint32_t b = 0; b < bands; ++b) {
        assert_true(0.75 * side * side / (1u << (2 * b)) >= 1000);
        qsort(error[b], DRAWS, sizeof **error, ascending);
        const double median = (error[b][DRAWS / 2 - 1] + error[b][DRAWS / 2]) / 2;
        if (!(median < 0.05)) print_error("band %u: median relative error %g\n", b, median);
        assert_true(median < 0.05);
    }
}

/* Root mean squares, around the ideal of 16 x 16 samples of each pixel, of the filtered and of the bare sample. */
static void filtering_errors(const weft_texture *texture, float size, double *filtered, double *bare)
{
    enum { PIXELS = 600, EDGE = 16 };
    static weft_point points[EDGE * EDGE + 2];
    static float out[EDGE * EDGE + 2];
    Random random = {4};
    *filtered = *bare = 0;
    for (int i = 0; i < PIXELS; ++i) {
        const double x = 3000 * random_unit(&random), y = 3000 * random_unit(&random);
        for (int k = 0; k < EDGE * EDGE + 2; ++k) {
            const int inner = k < EDGE * EDGE;
            const weft_point point = {x + (inner ? (double)size * ((k % EDGE + 0.5) / EDGE - 0.5) : 0),
                                      y + (inner ? (double)size * ((k / EDGE + 0.5) / EDGE - 0.5) : 0),
                                      {k == EDGE * EDGE ? size : 0, 0},
                                      {0, k == EDGE * EDGE ? size : 0}};
            points[k] = point;
        }
        assert_ok(weft_texture_sample(texture, EDGE * EDGE + 2, points, out));
        double mean = 0;
        for (int k = 0; k < EDGE * EDGE; ++k) mean += (double)out[k] / (EDGE * EDGE);
        *filtered += ((double)out[EDGE * EDGE] - mean) * ((double)out[EDGE * EDGE] - mean) / PIXELS;
        *bare += ((double)out[EDGE * EDGE + 1] - mean) * ((double)out[EDGE * EDGE + 1] - mean) / PIXELS;
    }
    *filtered = sqrt(*filtered);
    *bare = sqrt(*bare);
}

/* Bands fade as whole octaves and a box does not, so there is an error: below a quarter of the noise's own deviation,
 * and below two thirds of what a bare sample is off. */
static void filtering_against_supersampling(void **state)
{
    (void)state;
    weft_wavelet wavelet = plain_wavelet(1, 6);
    for (uint32_t b = 0; b < 6; ++b) wavelet.weight[b][0] = 0.05f;
    weft_model *model = new_wavelet(context, &wavelet);
    weft_texture *texture = new_texture(context, model, 0, 3, 0);
    const double deviation = 0.05 * sqrt(6);
    const float sizes[] = {1.5f, 2, 3, 4, 6, 8, 16};
    for (int i = 0; i < 7; ++i) {
        double filtered, bare;
        filtering_errors(texture, sizes[i], &filtered, &bare);
        if (!(filtered < deviation / 4 && filtered < bare * 2 / 3))
            print_error("footprint %g: off by %g filtered, %g bare, of %g\n", (double)sizes[i], filtered, bare,
                        deviation);
        assert_true(filtered < deviation / 4);
        assert_true(filtered < bare * 2 / 3);
    }
    weft_texture_free(texture);
    weft_model_free(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(variance_at_pixel_centres),       cmocka_unit_test(variance_in_space),
        cmocka_unit_test(bands_keep_to_their_octaves),     cmocka_unit_test(weights_are_recovered),
        cmocka_unit_test(filtering_against_supersampling),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
