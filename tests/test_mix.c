/* Mixing: textons on the transport path and the map that chooses among them; morphing of wavelet noise. */
#include "covariance.h"
#include "estimate.h"
#include "refusals.h"
#include "wavelets.h"
#include <stdlib.h>
#include <string.h>

#define CHANNELS 2
#define STEPS 5

static weft_context *context;
static weft_model *ends[2], *mixed;

static weft_model *texton_of(Grain grain, float brighter, uint32_t channels)
{
    weft_image photo = new_grain(grain, 48, 48, channels, 9);
    weft_texton_options options = WEFT_TEXTON_OPTIONS_INIT;
    weft_model *model = NULL;
    options.support = 16;
    for (size_t i = 0; i < (size_t)48 * 48 * channels; ++i) values(&photo)[i] += brighter;
    assert_ok(weft_analyze_texton(context, &photo, &options, NULL, NULL, &model));
    free_image(&photo);
    return model;
}

static int begin(void **state)
{
    (void)state;
    context = new_context(NULL, 0);
    ends[0] = texton_of(GRAIN_STREAKS, 0, CHANNELS);
    ends[1] = texton_of(GRAIN_SOFT, 0.25f, CHANNELS);
    assert_ok(weft_model_mix(context, ends[0], ends[1], 0, STEPS, &mixed));
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

static weft_texture *new_mixed(weft_context *where, const weft_image *map, float scale, uint64_t seed, uint32_t period)
{
    weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    weft_texture *texture = NULL;
    options.mix = map;
    options.mix_scale = scale;
    options.seed = seed;
    options.period_x = options.period_y = period;
    assert_ok(weft_texture_create(where, mixed, &options, &texture));
    return texture;
}

/* The same step everywhere. */
static weft_texture *new_step(uint32_t step, uint64_t seed)
{
    weft_image map = new_image(1, 1, 1, WEFT_FORMAT_F32);
    values(&map)[0] = (float)step / (STEPS - 1);
    weft_texture *texture = new_mixed(context, &map, 0, seed, 0);
    free_image(&map);
    return texture;
}

static void steps_are_parts(void **state)
{
    (void)state;
    weft_model_info info = WEFT_MODEL_INFO_INIT, first = WEFT_MODEL_INFO_INIT;
    assert_ok(weft_model_get(mixed, &info));
    assert_ok(weft_model_get(ends[0], &first));
    assert_int_equal(info.method, WEFT_METHOD_TEXTON);
    assert_int_equal(info.parts, STEPS);
    assert_int_equal(info.channels, CHANNELS);
    assert_memory_equal(info.mean, first.mean, sizeof info.mean);
    for (uint32_t k = 0; k < STEPS; ++k) {
        char name[32] = "texton 0";
        weft_part_info part = WEFT_PART_INFO_INIT;
        name[7] = (char)('0' + k);
        assert_ok(weft_model_part(mixed, k, &part));
        assert_string_equal(part.name, name);
        assert_int_equal(part.channels, CHANNELS);
        assert_true(part.width == info.width && part.height == info.height);
    }
    size_t size = 0, size_again = 0;
    void *bytes = saved(mixed, &size);
    weft_model *again = NULL;
    assert_ok(weft_model_load(context, bytes, size, &again));
    void *bytes_again = saved(again, &size_again);
    assert_int_equal(size, size_again);
    assert_memory_equal(bytes, bytes_again, size);
    free(bytes);
    free(bytes_again);
    weft_model_free(again);
}

static const int lags[][2] = {{0, 0}, {1, 0}, {0, 1}, {3, -2}, {6, 0}, {0, 5}};
#define LAGS 6

/* The ends of the path are the two models: the noise's deviation and covariance, as far as a fitted texton can have it. */
static void ends_are_the_models(void **state)
{
    (void)state;
    for (int e = 0; e < 2; ++e) {
        weft_image texton = part_of(ends[e], 0), step = part_of(mixed, e == 0 ? 0 : STEPS - 1);
        for (uint32_t a = 0; a < CHANNELS; ++a) {
            const double variance = noise_covariance(&texton, WEFT_INTERPOLATION_LINEAR, a, a, 0, 0);
            for (uint32_t b = 0; b < CHANNELS; ++b)
                for (int l = 0; l < LAGS; ++l) {
                    const double wanted = noise_covariance(&texton, WEFT_INTERPOLATION_LINEAR, a, b, lags[l][0], lags[l][1]);
                    const double got = noise_covariance(&step, WEFT_INTERPOLATION_LINEAR, a, b, lags[l][0], lags[l][1]);
                    if (!(fabs(got - wanted) <= 0.05 * variance)) print_error("end %d, lag %d: %g, should be %g of %g\n", e, l, got, wanted, variance);
                    assert_true(fabs(got - wanted) <= 0.05 * variance);
                }
        }
        free_image(&texton);
        free_image(&step);
    }
}

/* The step's own covariance and, of the colour, the mean that lies as far between the ends' means. */
static void mean_and_covariance_of_steps(void **state)
{
    (void)state;
    enum { SIDE = 80 };
    weft_model_info first = WEFT_MODEL_INFO_INIT, last = WEFT_MODEL_INFO_INIT;
    assert_ok(weft_model_get(ends[0], &first));
    assert_ok(weft_model_get(ends[1], &last));
    for (uint32_t k = 0; k < STEPS; ++k) {
        Estimate mean[CHANNELS] = {{0, 0, 0}}, covariance[LAGS][CHANNELS][CHANNELS];
        double expected[CHANNELS];
        memset(covariance, 0, sizeof covariance);
        for (int c = 0; c < CHANNELS; ++c) expected[c] = (double)first.mean[c] + k * ((double)last.mean[c] - (double)first.mean[c]) / (STEPS - 1);
        for (uint32_t i = 0; i < scaled(40, 24); ++i) {
            weft_texture *texture = new_step(k, 70 + i);
            weft_image image = rendered(texture, -1000 * (int64_t)i, 5, 0, SIDE, SIDE, CHANNELS);
            for (uint32_t a = 0; a < CHANNELS; ++a) {
                double sum = 0;
                for (uint32_t n = 0; n < SIDE * SIDE; ++n) sum += (double)values(&image)[n * CHANNELS + a];
                add(&mean[a], sum / (SIDE * SIDE));
                for (uint32_t b = 0; b < CHANNELS; ++b)
                    for (int l = 0; l < LAGS; ++l) {
                        double product = 0;
                        uint32_t pairs = 0;
                        for (int y = 2; y < SIDE - 5; ++y)
                            for (int x = 0; x < SIDE - 6; ++x, ++pairs)
                                product += ((double)value_at(&image, (uint32_t)x, (uint32_t)y, a) - expected[a]) *
                                           ((double)value_at(&image, (uint32_t)(x + lags[l][0]), (uint32_t)(y + lags[l][1]), b) - expected[b]);
                        add(&covariance[l][a][b], product / pairs);
                    }
            }
            free_image(&image);
            weft_texture_free(texture);
        }
        weft_image texton = part_of(mixed, k);
        for (uint32_t a = 0; a < CHANNELS; ++a) {
            const double variance = noise_covariance(&texton, WEFT_INTERPOLATION_LINEAR, a, a, 0, 0);
            assert_expected(&mean[a], expected[a], 0.2 * sqrt(variance), "mean of step", (int)k);
            for (uint32_t b = 0; b < CHANNELS; ++b)
                for (int l = 0; l < LAGS; ++l)
                    assert_expected(&covariance[l][a][b], noise_covariance(&texton, WEFT_INTERPOLATION_LINEAR, a, b, lags[l][0], lags[l][1]),
                                    0.3 * variance, "covariance of step", (int)k);
        }
        free_image(&texton);
    }
}

/* A map of all steps and of what is between and beyond them; windows and points, near and far, with and without a period. */
/* Points with footprints of all sizes, between the levels. */
static void fill_points(weft_point *points, uint32_t count, int64_t x, int64_t y, uint64_t seed)
{
    Random random = {seed};
    for (uint32_t i = 0; i < count; ++i) {
        const double size = random_unit(&random) * (i % 4 ? 4 : 60);
        const weft_point point = {(double)x + 90 * random_unit(&random),
                                  (double)y + 90 * random_unit(&random),
                                  {(float)(size * random_unit(&random)), (float)(size * random_unit(&random))},
                                  {(float)(-size * random_unit(&random)), (float)(size * random_unit(&random))}};
        points[i] = point;
    }
}

static void devices_agree_on(const char *name, weft_texture *texture, int64_t x, int64_t y, weft_texture *expected)
{
    enum { COUNT = 120 };
    weft_point points[COUNT];
    float out[2][COUNT * CHANNELS];
    for (uint32_t level = 0; level < 6; ++level) {
        weft_image image = rendered(texture, x >> level, y >> level, level, 71, 17, CHANNELS);
        weft_image scalar = rendered(expected, x >> level, y >> level, level, 71, 17, CHANNELS);
        assert_same_pixels(&image, &scalar, name);
        free_image(&image);
        free_image(&scalar);
    }
    fill_points(points, COUNT, x, y, 4);
    assert_ok(weft_texture_sample(texture, COUNT, points, out[0]));
    assert_ok(weft_texture_sample(expected, COUNT, points, out[1]));
    assert_memory_equal(out[0], out[1], sizeof out[0]);
}

/* Also of other orders of interpolation, and filtered. */
static void devices_agree_when_filtered(void **state)
{
    (void)state;
    const weft_interpolation orders[] = {WEFT_INTERPOLATION_LINEAR, WEFT_INTERPOLATION_NEAREST, WEFT_INTERPOLATION_CUBIC,
                                         WEFT_INTERPOLATION_QUINTIC};
    char names[MOST_DEVICES][64];
    const uint32_t count = usable_devices(names, 1);
    weft_image map = new_image(5, 6, 1, WEFT_FORMAT_F32);
    for (int i = 0; i < 30; ++i) values(&map)[i] = (float)(i * 7 % 30) / 29;
    for (int i = 0; i < 4; ++i) {
        weft_model *models[3] = {new_texton(context, 16, CHANNELS, 11, orders[i], 1),
                                 new_texton(context, 16, CHANNELS, 11, orders[i], 2), NULL};
        assert_ok(weft_model_mix(context, models[0], models[1], 0, 3, &models[2]));
        weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
        options.mix = &map;
        options.mix_scale = 5;
        options.seed = (uint64_t)i;
        options.impacts = 9;
        options.period_x = i % 2 ? 200 : 0;
        weft_texture *expected = NULL;
        const int64_t far = i < 2 ? -(INT64_C(1) << 40) : 0;
        for (uint32_t d = 0; d < count; ++d) {
            weft_context *there = new_context(names[d], 1 + d % 3);
            weft_texture *texture = NULL;
            assert_ok(weft_texture_create(there, models[2], &options, &texture));
            if (d == 0) assert_ok(weft_texture_create(context, models[2], &options, &expected));
            devices_agree_on(names[d], texture, far - 5, 9 - far, expected);
            weft_texture_free(texture);
            weft_context_free(there);
        }
        weft_texture_free(expected);
        for (int k = 0; k < 3; ++k) weft_model_free(models[k]);
    }
    free_image(&map);
}

static void devices_agree(void **state)
{
    (void)state;
    enum { WIDTH = 33, HEIGHT = 9 };
    char names[MOST_DEVICES][64];
    const uint32_t count = usable_devices(names, 1);
    const int64_t places[][2] = {{0, 0}, {-21, 13}, {INT64_C(1) << 40, -(INT64_C(1) << 40) + 3}};
    weft_image map = new_image(7, 5, 1, WEFT_FORMAT_F32);
    for (int i = 0; i < 35; ++i) values(&map)[i] = (float)i / 34;
    for (int i = 0; i < 6; ++i) {
        const uint32_t period = i < 3 ? 0 : 8 * 35;
        const int64_t x = places[i % 3][0], y = places[i % 3][1];
        weft_image expected[2], points_expected = new_image(WIDTH, HEIGHT, CHANNELS, WEFT_FORMAT_F32);
        weft_point points[WIDTH * HEIGHT];
        for (int k = 0; k < WIDTH * HEIGHT; ++k) {
            const weft_point point = {(double)(x + k % WIDTH) + 0.5, (double)(y + k / WIDTH) + 0.5, {0, 0}, {0, 0}};
            points[k] = point;
        }
        for (uint32_t d = 0; d < count; ++d) {
            weft_context *there = new_context(names[d], 1);
            weft_texture *texture = new_mixed(there, &map, 8, (uint64_t)i, period);
            for (uint32_t level = 0; level < 2; ++level) {
                weft_image image = rendered(texture, x >> level, y >> level, level, WIDTH, HEIGHT, CHANNELS);
                if (d == 0) expected[level] = image;
                assert_same_pixels(&image, &expected[level], names[d]);
                if (d > 0) free_image(&image);
            }
            assert_ok(weft_texture_sample(texture, WIDTH * HEIGHT, points, values(&points_expected)));
            assert_same_pixels(&points_expected, &expected[0], names[d]);
            if (period) {
                weft_image away = rendered(texture, x + period, y - 3 * (int64_t)period, 0, WIDTH, HEIGHT, CHANNELS);
                assert_same_pixels(&away, &expected[0], "a period away");
                free_image(&away);
            }
            weft_texture_free(texture);
            weft_context_free(there);
        }
        free_image(&expected[0]);
        free_image(&expected[1]);
        free_image(&points_expected);
    }
    free_image(&map);
}

static void wrong_mixes(void **state)
{
    (void)state;
    const char *function = "weft_model_mix";
    const weft_status argument = WEFT_ERROR_ARGUMENT;
    const weft_wavelet parameters = random_wavelet(CHANNELS, 3, 4, 1), other_channels = random_wavelet(3, 3, 4, 1);
    weft_model *grey = texton_of(GRAIN_SOFT, 0, 1), *noise = new_wavelet(context, &parameters), *colour = new_wavelet(context, &other_channels);
    weft_model *picture = new_picture(context, 8, 8, CHANNELS, 1), *out;
    const uint32_t steps[] = {0, 1, 256, UINT32_MAX};
    const float ts[] = {-0.01f, 1.01f, NAN, INFINITY};
    for (int i = 0; i < 4; ++i) {
        REFUSED_HANDLE(weft_model_mix(context, ends[0], ends[1], 0, steps[i], &out), out, argument, function, "steps");
        REFUSED_HANDLE(weft_model_mix(context, noise, noise, ts[i], 0, &out), out, argument, function, "t is");
    }
    REFUSED_HANDLE(weft_model_mix(context, ends[0], grey, 0, 3, &out), out, argument, function, "channels");
    REFUSED_HANDLE(weft_model_mix(context, noise, colour, 0.5f, 0, &out), out, argument, function, "channels");
    REFUSED_HANDLE(weft_model_mix(context, ends[0], noise, 0, 3, &out), out, argument, function, "method");
    REFUSED_HANDLE(weft_model_mix(context, NULL, ends[1], 0, 3, &out), out, argument, function, "a is NULL");
    REFUSED_HANDLE(weft_model_mix(context, ends[0], NULL, 0, 3, &out), out, argument, function, "b is NULL");
    REFUSED_HANDLE(weft_model_mix(NULL, ends[0], ends[1], 0, 3, &out), out, argument, function, "context");
    REFUSED(weft_model_mix(context, ends[0], ends[1], 0, 3, NULL), function, "model");
    REFUSED_HANDLE(weft_model_mix(context, picture, picture, 0, 3, &out), out, WEFT_ERROR_UNSUPPORTED, function, "picture");
    REFUSED_HANDLE(weft_model_mix(context, mixed, ends[0], 0, 3, &out), out, WEFT_ERROR_UNSUPPORTED, function, "mixed");
    weft_model_free(grey);
    weft_model_free(noise);
    weft_model_free(colour);
    weft_model_free(picture);
}

static void wrong_maps(void **state)
{
    (void)state;
    const weft_texture_options fresh = WEFT_TEXTURE_OPTIONS_INIT;
    weft_image map = new_image(4, 4, 1, WEFT_FORMAT_F32), colour = new_image(4, 4, 3, WEFT_FORMAT_F32);
    weft_texture *texture;
    for (int i = 0; i < 9; ++i) {
        weft_texture_options options = fresh;
        weft_image broken = map;
        const weft_model *model = mixed;
        const char *word = "mix_scale";
        options.mix = &map;
        switch (i) {
        case 0: options.mix_scale = 0.5f; break;
        case 1: options.mix_scale = 1.5f; break;
        case 2: options.mix_scale = 65537; break;
        case 3: options.mix_scale = -1; break;
        case 4: options.mix_scale = NAN; break;
        case 5: options.mix = &colour, word = "channels"; break;
        case 6: broken.data = NULL, options.mix = &broken, word = "data"; break;
        case 7: model = ends[0], word = "mixed"; break;
        default: values(&map)[5] = NAN, word = "mix"; break;
        }
        REFUSED_HANDLE(weft_texture_create(context, model, &options, &texture), texture, WEFT_ERROR_ARGUMENT, "weft_texture_create", word);
    }
    free_image(&map);
    free_image(&colour);
}

/* The pixels of the ends, bit for bit; in between every weight and the mean lie between the ends', in order. */
static void wavelets_morph(void **state)
{
    (void)state;
    weft_wavelet a = random_wavelet(3, 6, 8, 1), b = random_wavelet(3, 4, 5, 2);
    for (int aligned = 0; aligned < 2; ++aligned) {
        if (aligned) memcpy(b.axes, a.axes, sizeof b.axes);
        weft_model *models[2] = {new_wavelet(context, &a), new_wavelet(context, &b)};
        for (int e = 0; e < 2; ++e) {
            weft_model *at_end = NULL;
            assert_ok(weft_model_mix(context, models[0], models[1], (float)e, 0, &at_end));
            weft_texture *one = new_texture(context, models[e], 0, 4, 0), *two = new_texture(context, at_end, 0, 4, 0);
            weft_image expected = rendered(one, -5, 9, 0, 60, 40, 3), image = rendered(two, -5, 9, 0, 60, 40, 3);
            assert_same_pixels(&image, &expected, e ? "t = 1" : "t = 0");
            free_image(&expected);
            free_image(&image);
            weft_texture_free(one);
            weft_texture_free(two);
            weft_model_free(at_end);
        }
        for (int i = 1; aligned && i < 8; ++i) {
            weft_model *between = NULL;
            weft_wavelet w = WEFT_WAVELET_INIT;
            const float t = (float)i / 8;
            assert_ok(weft_model_mix(context, models[0], models[1], t, 0, &between));
            assert_ok(weft_model_get_wavelet(between, &w));
            assert_int_equal(w.bands, 6);
            for (int p = 0; p < 3; ++p) {
                assert_true(fabs((double)(w.mean[p] - (a.mean[p] + t * (b.mean[p] - a.mean[p])))) < 1e-6);
                for (int k = 0; k < 6; ++k)
                    assert_true(fabs((double)(w.weight[k][p] - (a.weight[k][p] + t * (b.weight[k][p] - a.weight[k][p])))) < 1e-6);
            }
            weft_model_free(between);
        }
        weft_model_free(models[0]);
        weft_model_free(models[1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_are_parts), cmocka_unit_test(ends_are_the_models), cmocka_unit_test(mean_and_covariance_of_steps),
        cmocka_unit_test(devices_agree), cmocka_unit_test(devices_agree_when_filtered),   cmocka_unit_test(wrong_mixes),         cmocka_unit_test(wrong_maps),
        cmocka_unit_test(wavelets_morph),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
