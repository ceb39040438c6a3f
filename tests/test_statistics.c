/* Rendered noise has the statistics that its model promises, within the confidence interval of the sample.
 *
 * Each estimate is made on `windows` independent windows (seeds); their spread gives the standard error, and Student's
 * t the distance to the expected value that chance explains. All seeds are fixed: the test gives the same answer
 * always. */
#include "covariance.h"
#include "estimate.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SIDE 96
#define CHANNELS 3

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

enum { windows = 60 };

/* A texton of an exemplar with streaks, and what it promises. */
typedef struct Promise {
    weft_model *model;
    weft_model_info info;
    weft_image texton;
} Promise;

static Promise make_promise(uint32_t support, weft_interpolation interpolation)
{
    const weft_model_info fresh = WEFT_MODEL_INFO_INIT;
    Promise promise = {NULL, fresh, {NULL, 0, 0, 0, 0, 0}};
    weft_image photo = new_grain(GRAIN_STREAKS, 64, 64, CHANNELS, 11);
    weft_texton_options options = WEFT_TEXTON_OPTIONS_INIT;
    options.support = support;
    options.interpolation = interpolation;
    assert_ok(weft_analyze_texton(context, &photo, &options, NULL, NULL, &promise.model));
    assert_ok(weft_model_get(promise.model, &promise.info));
    promise.texton = part_of(promise.model, 0);
    free_image(&photo);
    return promise;
}

static void free_promise(Promise *promise)
{
    weft_model_free(promise->model);
    free_image(&promise->texton);
}

static const int lags[][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 1}, {-3, 1}, {5, 0}, {0, 4}, {9, -7}, {15, 0}};
#define LAGS 9

static double covariance_in(const weft_image *image, const float *mean, uint32_t a, uint32_t b, int dx, int dy)
{
    double sum = 0;
    uint32_t pairs = 0;
    for (int y = dy < 0 ? -dy : 0; y < SIDE && y + dy < SIDE; ++y)
        for (int x = dx < 0 ? -dx : 0; x < SIDE && x + dx < SIDE; ++x, ++pairs)
            sum += ((double)value_at(image, (uint32_t)x, (uint32_t)y, a) - (double)mean[a]) *
                   ((double)value_at(image, (uint32_t)(x + dx), (uint32_t)(y + dy), b) - (double)mean[b]);
    return sum / pairs;
}

static void check_moments(const Promise *promise, float impacts)
{
    Estimate mean[CHANNELS], covariance[LAGS][CHANNELS][CHANNELS];
    memset(mean, 0, sizeof mean);
    memset(covariance, 0, sizeof covariance);
    for (uint32_t i = 0; i < windows; ++i) {
        weft_texture *texture = new_texture(context, promise->model, impacts, 100 + i, 0);
        weft_image image = rendered(texture, 1000 * (int64_t)i, -77, 0, SIDE, SIDE, CHANNELS);
        for (uint32_t a = 0; a < CHANNELS; ++a) {
            double sum = 0;
            for (uint32_t k = 0; k < SIDE * SIDE; ++k) sum += (double)values(&image)[k * CHANNELS + a];
            add(&mean[a], sum / (SIDE * SIDE));
            for (int l = 0; l < LAGS; ++l)
                for (uint32_t b = 0; b < CHANNELS; ++b)
                    add(&covariance[l][a][b], covariance_in(&image, promise->info.mean, a, b, lags[l][0], lags[l][1]));
        }
        free_image(&image);
        weft_texture_free(texture);
    }
    for (uint32_t a = 0; a < CHANNELS; ++a) {
        const double deviation = (double)promise->info.deviation[a], variance = deviation * deviation;
        assert_expected(&mean[a], (double)promise->info.mean[a], 0.1 * deviation, "mean of channel", (int)a);
        assert_expected(&covariance[0][a][a], variance, 0.2 * variance, "variance of channel", (int)a);
        for (int l = 0; l < LAGS; ++l)
            for (uint32_t b = 0; b < CHANNELS; ++b)
                assert_expected(
                    &covariance[l][a][b],
                    noise_covariance(&promise->texton, promise->info.interpolation, a, b, lags[l][0], lags[l][1]),
                    0.2 * variance, "covariance at lag", l);
    }
}

static void mean_and_covariance(void **state)
{
    (void)state;
    const weft_interpolation interpolations[] = {WEFT_INTERPOLATION_LINEAR, WEFT_INTERPOLATION_NEAREST,
                                                 WEFT_INTERPOLATION_CUBIC, WEFT_INTERPOLATION_QUINTIC};
    for (int i = 0; i < 4; ++i) {
        Promise promise = make_promise(16, interpolations[i]);
        const float impacts[] = {30, 10, 100};
        for (int k = 0; k < (i == 0 ? 3 : 1); ++k) check_moments(&promise, impacts[k]);
        free_promise(&promise);
    }
}

/* Periodogram of Hann-windowed 16 x 16 segments at half overlap, with a plain DFT; its sum over frequencies is the
 * variance. */
#define SEGMENT 16
static double hann(int i) { return 0.5 - 0.5 * cos(2 * 3.14159265358979323846 * (i + 0.5) / SEGMENT); }

static void add_periodogram(const weft_image *image, double mean, uint32_t c, uint32_t left, uint32_t top,
                            double *power)
{
    double rows_re[SEGMENT][SEGMENT], rows_im[SEGMENT][SEGMENT], cosine[SEGMENT], sine[SEGMENT], window[SEGMENT],
        energy = 0;
    for (int i = 0; i < SEGMENT; ++i) {
        cosine[i] = cos(2 * 3.14159265358979323846 * i / SEGMENT);
        sine[i] = sin(2 * 3.14159265358979323846 * i / SEGMENT);
        window[i] = hann(i);
        energy += window[i] * window[i];
    }
    for (int y = 0; y < SEGMENT; ++y)
        for (int u = 0; u < SEGMENT; ++u) {
            double re = 0, im = 0;
            for (int x = 0; x < SEGMENT; ++x) {
                const double value =
                    window[x] * window[y] * ((double)value_at(image, left + (uint32_t)x, top + (uint32_t)y, c) - mean);
                re += value * cosine[u * x % SEGMENT];
                im -= value * sine[u * x % SEGMENT];
            }
            rows_re[y][u] = re;
            rows_im[y][u] = im;
        }
    for (int v = 0; v < SEGMENT; ++v)
        for (int u = 0; u < SEGMENT; ++u) {
            double re = 0, im = 0;
            for (int y = 0; y < SEGMENT; ++y) {
                re += rows_re[y][u] * cosine[v * y % SEGMENT] + rows_im[y][u] * sine[v * y % SEGMENT];
                im += rows_im[y][u] * cosine[v * y % SEGMENT] - rows_re[y][u] * sine[v * y % SEGMENT];
            }
            power[v * SEGMENT + u] += (re * re + im * im) / (SEGMENT * SEGMENT * energy * energy);
        }
}

/* The same of the promised covariance: what the periodogram of an endless sample tends to. */
static void expected_periodogram(const Promise *promise, uint32_t c, double *power)
{
    double overlap[SEGMENT], energy = 0;
    for (int k = 0; k < SEGMENT; ++k) {
        overlap[k] = 0;
        for (int i = 0; i + k < SEGMENT; ++i) overlap[k] += hann(i) * hann(i + k);
        if (k == 0) energy = overlap[0];
    }
    memset(power, 0, sizeof *power * SEGMENT * SEGMENT);
    for (int dy = 1 - SEGMENT; dy < SEGMENT; ++dy)
        for (int dx = 1 - SEGMENT; dx < SEGMENT; ++dx) {
            const double covariance = noise_covariance(&promise->texton, promise->info.interpolation, c, c, dx, dy) *
                                      overlap[abs(dx)] * overlap[abs(dy)];
            for (int v = 0; v < SEGMENT; ++v)
                for (int u = 0; u < SEGMENT; ++u)
                    power[v * SEGMENT + u] += covariance *
                                              cos(2 * 3.14159265358979323846 * (u * dx + v * dy) / SEGMENT) /
                                              (SEGMENT * SEGMENT * energy * energy);
        }
}

static void spectrum(void **state)
{
    (void)state;
    Promise promise = make_promise(16, WEFT_INTERPOLATION_LINEAR);
    double expected[CHANNELS][SEGMENT * SEGMENT], most = 0;
    for (uint32_t c = 0; c < CHANNELS; ++c) expected_periodogram(&promise, c, expected[c]);
    for (int k = 0; k < SEGMENT * SEGMENT; ++k) most = expected[0][k] > most ? expected[0][k] : most;
    const float impacts[] = {10, 30, 100};
    for (int i = 0; i < 3; ++i) {
        static Estimate estimate[CHANNELS][SEGMENT * SEGMENT];
        memset(estimate, 0, sizeof estimate);
        for (uint32_t w = 0; w < windows; ++w) {
            weft_texture *texture = new_texture(context, promise.model, impacts[i], 5000 + w, 0);
            weft_image image = rendered(texture, 0, 0, 0, SIDE, SIDE, CHANNELS);
            for (uint32_t c = 0; c < CHANNELS; ++c) {
                double power[SEGMENT * SEGMENT] = {0};
                uint32_t segments = 0;
                for (uint32_t y = 0; y + SEGMENT <= SIDE; y += SEGMENT / 2)
                    for (uint32_t x = 0; x + SEGMENT <= SIDE; x += SEGMENT / 2, ++segments)
                        add_periodogram(&image, (double)promise.info.mean[c], c, x, y, power);
                for (int k = 0; k < SEGMENT * SEGMENT; ++k) add(&estimate[c][k], power[k] / segments);
            }
            free_image(&image);
            weft_texture_free(texture);
        }
        for (uint32_t c = 0; c < CHANNELS; ++c)
            for (int k = 0; k < SEGMENT * SEGMENT; ++k)
                assert_expected(&estimate[c][k], expected[c][k], 0.3 * most, "power of frequency", k);
    }
    free_promise(&promise);
}

/* The test can fail: noise of 30 impacts is not what a texton 10 % stronger promises. */
static void a_wrong_promise_is_noticed(void **state)
{
    (void)state;
    Promise promise = make_promise(16, WEFT_INTERPOLATION_LINEAR);
    Estimate variance = {0, 0, 0};
    for (uint32_t i = 0; i < windows; ++i) {
        weft_texture *texture = new_texture(context, promise.model, 30, 100 + i, 0);
        weft_image image = rendered(texture, 0, 0, 0, SIDE, SIDE, CHANNELS);
        add(&variance, covariance_in(&image, promise.info.mean, 0, 0, 0, 0));
        free_image(&image);
        weft_texture_free(texture);
    }
    const double promised = (double)promise.info.deviation[0] * (double)promise.info.deviation[0];
    assert_true(fabs(mean_of(&variance) - 1.21 * promised) > half_of(&variance));
    free_promise(&promise);
}

/* Two realisations know nothing of each other, nor do places further apart than a texton. */
static void realisations_are_independent(void **state)
{
    (void)state;
    Promise promise = make_promise(16, WEFT_INTERPOLATION_LINEAR);
    Estimate seeds = {0, 0, 0}, places = {0, 0, 0};
    for (uint32_t i = 0; i < windows; ++i) {
        weft_texture *one = new_texture(context, promise.model, 30, 2 * i, 0),
                     *two = new_texture(context, promise.model, 30, 2 * i + 1, 0);
        weft_image a = rendered(one, 0, 0, 0, SIDE, SIDE, CHANNELS), b = rendered(two, 0, 0, 0, SIDE, SIDE, CHANNELS);
        weft_image c = rendered(one, SIDE + 20, 0, 0, SIDE, SIDE, CHANNELS);
        double ab = 0, ac = 0;
        for (size_t k = 0; k < SIDE * SIDE; ++k) {
            const double mean = (double)promise.info.mean[0], value = (double)values(&a)[k * CHANNELS] - mean;
            ab += value * ((double)values(&b)[k * CHANNELS] - mean);
            ac += value * ((double)values(&c)[k * CHANNELS] - mean);
        }
        add(&seeds, ab / (SIDE * SIDE));
        add(&places, ac / (SIDE * SIDE));
        free_image(&a);
        free_image(&b);
        free_image(&c);
        weft_texture_free(one);
        weft_texture_free(two);
    }
    const double variance = (double)promise.info.deviation[0] * (double)promise.info.deviation[0];
    assert_expected(&seeds, 0, 0.1 * variance, "covariance of seeds", 0);
    assert_expected(&places, 0, 0.1 * variance, "covariance of places", 0);
    free_promise(&promise);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mean_and_covariance),
        cmocka_unit_test(spectrum),
        cmocka_unit_test(a_wrong_promise_is_noticed),
        cmocka_unit_test(realisations_are_independent),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
