/* The analysis against Algorithm 1 in plain loops: model error, covariance, mean; all sizes, degenerate exemplars. */
#include "covariance.h"
#include "reference.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static weft_context *context;

static int begin(void **state)
{
    (void)state;
    context = new_context("scalar", 0);
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_context_free(context);
    return 0;
}

typedef struct Learnt {
    weft_model *model;
    weft_model_info info;
    weft_image texton;
} Learnt;

static Learnt learn(const weft_image *photo, uint32_t support, uint32_t iterations, weft_interpolation interpolation,
                    weft_projection projection, uint64_t seed)
{
    const weft_model_info fresh = WEFT_MODEL_INFO_INIT;
    Learnt learnt = {NULL, fresh, {NULL, 0, 0, 0, 0, 0}};
    weft_texton_options options = WEFT_TEXTON_OPTIONS_INIT;
    options.support = support;
    options.iterations = iterations;
    options.interpolation = interpolation;
    options.projection = projection;
    options.seed = seed;
    assert_ok(weft_analyze_texton(context, photo, &options, NULL, NULL, &learnt.model));
    assert_ok(weft_model_get(learnt.model, &learnt.info));
    learnt.texton = part_of(learnt.model, 0);
    return learnt;
}

static void forget(Learnt *learnt)
{
    weft_model_free(learnt->model);
    free_image(&learnt->texton);
}

static void assert_close(double value, double expected, double tolerance, const char *what)
{
    if (fabs(value - expected) <= tolerance) return;
    print_error("%s: %.9g, expected %.9g within %g\n", what, value, expected, tolerance);
    fail();
}

static const Grain grains[] = {GRAIN_SOFT, GRAIN_STREAKS, GRAIN_BAND, GRAIN_WHITE};
static const weft_interpolation interpolations[] = {WEFT_INTERPOLATION_LINEAR, WEFT_INTERPOLATION_NEAREST,
                                                    WEFT_INTERPOLATION_CUBIC, WEFT_INTERPOLATION_QUINTIC};

/* The error that is reported is that of the coefficients that are handed out, by the formula; mean and deviation
 * likewise. */
static void what_is_reported(void **state)
{
    (void)state;
    const uint32_t sizes[][2] = {{32, 32}, {37, 29}, {24, 40}};
    for (uint32_t i = 0; i < 12; ++i) {
        const uint32_t channels = 1 + i % 3;
        const weft_interpolation interpolation = interpolations[i % 4];
        weft_image photo = new_grain(grains[i % 4], sizes[i % 3][0], sizes[i % 3][1], channels, i);
        Learnt learnt = learn(&photo, 11, i % 2 ? 0 : 5, interpolation,
                              i % 5 == 0 ? WEFT_PROJECTION_PLAIN : WEFT_PROJECTION_DEFAULT, i);
        Reference reference;
        reference_open(&reference, &photo, interpolation);
        const double error = reference_error(&reference, &learnt.texton);
        assert_close((double)learnt.info.model_error, error, 1e-4 * error + 1e-5, "model error");
        for (uint32_t a = 0; a < channels; ++a) {
            assert_close((double)learnt.info.mean[a], reference.mean[a], 1e-6, "mean");
            assert_close((double)learnt.info.deviation[a],
                         sqrt(noise_covariance(&learnt.texton, interpolation, a, a, 0, 0)), 1e-6, "deviation");
        }
        reference_close(&reference);
        forget(&learnt);
        free_image(&photo);
    }
}

/* The noise has the exemplar's covariance between channels, whatever the support took away: paper, section 4.3. */
static void covariance_is_the_exemplars(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 32; ++i) {
        const uint32_t channels = 1 + i / 4 % 4, supports[] = {16, 5, 32, 31};
        const weft_interpolation interpolation = interpolations[i % 4];
        weft_image photo = new_grain(grains[i % 3], 32, 36, channels, i);
        Learnt learnt = learn(&photo, supports[i / 8], 4, interpolation, WEFT_PROJECTION_DEFAULT, i);
        Reference reference;
        reference_open(&reference, &photo, interpolation);
        for (uint32_t a = 0; a < channels; ++a)
            for (uint32_t b = 0; b < channels; ++b)
                assert_close(noise_covariance(&learnt.texton, interpolation, a, b, 0, 0), reference.covariance[a][b],
                             2e-4 * sqrt(reference.covariance[a][a] * reference.covariance[b][b]),
                             "covariance of channels");
        reference_close(&reference);
        forget(&learnt);
        free_image(&photo);
    }
}

/* The default is not worse than 50 plain iterations: ours by option, and the reference's own from another white noise.
 */
static void not_worse_than_fifty_plain_iterations(void **state)
{
    (void)state;
    double ratios = 0;
    uint32_t count = 0;
    for (uint32_t i = 0; i < 12; ++i) {
        const uint32_t side = 40, support = i % 3 == 0 ? 20 : i % 3 == 1 ? 12 : 30, channels = i % 2 ? 3 : 1;
        weft_image photo = new_grain(grains[i % 4], side, side, channels, 50 + i);
        Learnt ours = learn(&photo, support, 0, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_DEFAULT, 1);
        Learnt plain = learn(&photo, support, 50, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_PLAIN, 1);
        if (ours.info.model_error > plain.info.model_error)
            print_error("grain %u, support %u, %u channels: default %g, plain %g\n", i % 4, support, channels,
                        (double)ours.info.model_error, (double)plain.info.model_error);
        assert_true(ours.info.model_error <= plain.info.model_error);
        if (channels == 1) { /* the plain option is the algorithm: on average over starts the same error */
            Reference reference;
            reference_open(&reference, &photo, WEFT_INTERPOLATION_LINEAR);
            double sum = 0, reference_sum = 0;
            for (uint64_t seed = 0; seed < 4; ++seed) {
                Learnt start = learn(&photo, support, 50, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_PLAIN, seed);
                weft_image projections = reference_projections(&reference, support, 50, seed);
                sum += (double)start.info.model_error;
                reference_sum += reference_error(&reference, &projections);
                free_image(&projections);
                forget(&start);
            }
            ratios += sum / reference_sum;
            ++count;
            reference_close(&reference);
        }
        forget(&plain);
        forget(&ours);
        free_image(&photo);
    }
    if (getenv("WEFT_TEST_FIGURES")) print_message("plain option over reference: %.4f\n", ratios / count);
    assert_close(ratios / count, 1, 0.03, "plain iterations over the reference's");
}

/* More iterations do not make it worse, a larger support neither (of the same exemplar, by more than the start's
 * chance). */
static void more_is_not_worse(void **state)
{
    (void)state;
    weft_image photo = new_grain(GRAIN_SOFT, 48, 48, 3, 9);
    const weft_projection projections[] = {WEFT_PROJECTION_PLAIN, WEFT_PROJECTION_MOMENTUM};
    for (int p = 0; p < 2; ++p) {
        float last = 10;
        for (uint32_t iterations = 1; iterations <= 256; iterations *= 4) {
            Learnt learnt = learn(&photo, 20, iterations, WEFT_INTERPOLATION_LINEAR, projections[p], 1);
            assert_true(learnt.info.model_error <= last * 1.001f);
            last = learnt.info.model_error;
            forget(&learnt);
        }
    }
    float last = 10;
    for (uint32_t support = 3; support <= 48; support *= 2) {
        Learnt learnt = learn(&photo, support, 0, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_DEFAULT, 1);
        assert_true(learnt.info.model_error <= last);
        last = learnt.info.model_error;
        forget(&learnt);
    }
    free_image(&photo);
}

static void assert_sane(const Learnt *learnt)
{
    for (size_t i = 0; i < image_bytes(&learnt->texton) / sizeof(float); ++i)
        assert_true(isfinite(values(&learnt->texton)[i]));
    for (uint32_t c = 0; c < learnt->info.channels; ++c)
        assert_true(isfinite(learnt->info.mean[c]) && isfinite(learnt->info.deviation[c]) &&
                    learnt->info.deviation[c] >= 0);
    assert_true(isfinite(learnt->info.model_error));
    weft_texture *texture = new_texture(context, learnt->model, 0, 0, 0);
    weft_image image = rendered(texture, 0, 0, 0, 20, 10, learnt->info.channels);
    for (size_t i = 0; i < image_bytes(&image) / sizeof(float); ++i) assert_true(isfinite(values(&image)[i]));
    free_image(&image);
    weft_texture_free(texture);
}

static void any_size_and_number_of_channels(void **state)
{
    (void)state;
    const uint32_t sizes[][2] = {{8, 8},   {8, 9},    {11, 13}, {31, 37}, {127, 8},
                                 {8, 127}, {97, 101}, {64, 48}, {121, 25}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        const uint32_t width = sizes[i][0], height = sizes[i][1], shorter = width < height ? width : height;
        const uint32_t supports[] = {1, 2, shorter / 2, shorter - 1, shorter, 0};
        for (int k = 0; k < 6; ++k) {
            const uint32_t channels = 1 + (uint32_t)(i + (size_t)k * 3) % 16;
            weft_image photo = new_grain(grains[i % 4], width, height, channels, i);
            Learnt learnt = learn(&photo, supports[k], 3, interpolations[k % 4], WEFT_PROJECTION_DEFAULT, i);
            assert_sane(&learnt);
            assert_int_equal(learnt.info.width, supports[k] ? supports[k] : shorter < 64 ? shorter : 64);
            assert_int_equal(learnt.info.height, learnt.info.width);
            assert_int_equal(learnt.info.channels, channels);
            assert_int_equal(learnt.info.interpolation, interpolations[k % 4]);
            assert_int_equal(learnt.info.method, WEFT_METHOD_TEXTON);
            for (uint32_t c = 0; c < channels; ++c) assert_close((double)learnt.info.mean[c], 0.5, 1e-5, "mean");
            forget(&learnt);
            free_image(&photo);
        }
    }
}

/* Grey stored as RGB: a covariance of rank 1. The channels stay the same, and the same as the single channel's
 * deviation. */
static void grey_stored_as_colour(void **state)
{
    (void)state;
    weft_image grey = new_grain(GRAIN_SOFT, 40, 33, 1, 4), colour = new_image(40, 33, 3, WEFT_FORMAT_F32);
    for (uint32_t i = 0; i < 40 * 33 * 3; ++i) values(&colour)[i] = values(&grey)[i / 3];
    Learnt one = learn(&grey, 12, 20, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_DEFAULT, 1);
    Learnt three = learn(&colour, 12, 20, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_DEFAULT, 1);
    assert_sane(&three);
    double largest = 0;
    for (uint32_t i = 0; i < 12 * 12; ++i) largest = fmax(largest, fabs((double)values(&three.texton)[3 * i]));
    for (uint32_t i = 0; i < 12 * 12; ++i)
        for (uint32_t c = 1; c < 3; ++c)
            assert_close((double)values(&three.texton)[3 * i + c], (double)values(&three.texton)[3 * i], 1e-4 * largest,
                         "coefficient");
    for (uint32_t c = 0; c < 3; ++c)
        assert_close((double)three.info.deviation[c], (double)one.info.deviation[0], 1e-4, "deviation");
    forget(&one);
    forget(&three);
    free_image(&grey);
    free_image(&colour);
}

/* A channel that is constant stays constant; an image that is constant gives a texture of that colour. */
static void constant_channels(void **state)
{
    (void)state;
    for (uint32_t constant = 1; constant <= 3; ++constant) {
        weft_image photo = new_grain(GRAIN_SOFT, 30, 30, 3, 4);
        for (uint32_t i = 0; i < 30 * 30; ++i)
            for (uint32_t c = 0; c < constant; ++c) values(&photo)[3 * i + c] = 0.25f * (float)(c + 1);
        Learnt learnt = learn(&photo, 10, 20, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_DEFAULT, 1);
        assert_sane(&learnt);
        for (uint32_t c = 0; c < constant; ++c) {
            assert_close((double)learnt.info.mean[c], 0.25 * (c + 1), 1e-6, "mean");
            assert_close((double)learnt.info.deviation[c], 0, 1e-6, "deviation");
        }
        for (uint32_t c = constant; c < 3; ++c) assert_true(learnt.info.deviation[c] > 0.05f);
        forget(&learnt);
        free_image(&photo);
    }
}

/* The same pixels in another format are the same exemplar. */
static void formats(void **state)
{
    (void)state;
    weft_image bytes = new_image(24, 24, 3, WEFT_FORMAT_U8), words = new_image(24, 24, 3, WEFT_FORMAT_U16),
               floats = new_image(24, 24, 3, WEFT_FORMAT_F32);
    Random random = {8};
    for (uint32_t i = 0; i < 24 * 24 * 3; ++i) {
        const uint8_t byte = (uint8_t)random_below(&random, 256);
        ((uint8_t *)bytes.data)[i] = byte;
        ((uint16_t *)words.data)[i] = (uint16_t)(byte * 257);
        values(&floats)[i] = (float)byte / 255.0f;
    }
    Learnt a = learn(&bytes, 8, 5, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_DEFAULT, 1);
    Learnt b = learn(&words, 8, 5, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_DEFAULT, 1);
    Learnt c = learn(&floats, 8, 5, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_DEFAULT, 1);
    assert_same_pixels(&a.texton, &b.texton, "U8 and U16");
    assert_same_pixels(&a.texton, &c.texton, "U8 and F32");
    forget(&a);
    forget(&b);
    forget(&c);

    unsigned char *upside_down = malloc(24 * (24 * 3 + 5)); /* rows from the last to the first, with gaps */
    for (uint32_t y = 0; y < 24; ++y)
        memcpy(upside_down + (size_t)(23 - y) * (24 * 3 + 5), (uint8_t *)bytes.data + (size_t)y * 24 * 3, 24 * 3);
    const weft_image view = {upside_down + 23 * (24 * 3 + 5), -(24 * 3 + 5), 24, 24, 3, WEFT_FORMAT_U8};
    a = learn(&view, 8, 5, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_DEFAULT, 1);
    b = learn(&bytes, 8, 5, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_DEFAULT, 1);
    assert_same_pixels(&a.texton, &b.texton, "a view with gaps, bottom up");
    forget(&a);
    forget(&b);
    free(upside_down);
    free_image(&bytes);
    free_image(&words);
    free_image(&floats);
}

static void seeds(void **state)
{
    (void)state;
    weft_image photo = new_grain(GRAIN_SOFT, 24, 24, 1, 4);
    const uint64_t different[] = {0, 1, UINT64_C(1) << 32, UINT64_C(1) << 63};
    Learnt learnt[4];
    for (int i = 0; i < 4; ++i) {
        learnt[i] = learn(&photo, 8, 5, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_DEFAULT, different[i]);
        Learnt again = learn(&photo, 8, 5, WEFT_INTERPOLATION_LINEAR, WEFT_PROJECTION_DEFAULT, different[i]);
        assert_same_pixels(&learnt[i].texton, &again.texton, "the same seed");
        forget(&again);
        for (int k = 0; k < i; ++k) assert_false(same_pixels(&learnt[i].texton, &learnt[k].texton));
    }
    for (int i = 0; i < 4; ++i) forget(&learnt[i]);
    free_image(&photo);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_reported),
        cmocka_unit_test(covariance_is_the_exemplars),
        cmocka_unit_test(not_worse_than_fifty_plain_iterations),
        cmocka_unit_test(more_is_not_worse),
        cmocka_unit_test(any_size_and_number_of_channels),
        cmocka_unit_test(grey_stored_as_colour),
        cmocka_unit_test(constant_channels),
        cmocka_unit_test(formats),
        cmocka_unit_test(seeds),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
