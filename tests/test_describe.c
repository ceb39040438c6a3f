/* weft_describe on photographs made here, of which it is known what they are like and which method suits them. */
#include "support.h"
#include <math.h>
#include <string.h>

enum { SIDE = 192, AREA = SIDE * SIDE };

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

static weft_description described(const weft_image *photo)
{
    weft_description d = WEFT_DESCRIPTION_INIT;
    assert_ok(weft_describe(context, photo, NULL, NULL, &d));
    assert_int_equal(d.size, sizeof d);
    const size_t length = strlen(d.reasons);
    assert_true(length > 20 && length < sizeof d.reasons - 1 && d.reasons[length - 1] == '.');
    const float measures[] = {d.structure, d.structure_toned, d.histogram, d.anisotropy, d.unevenness};
    for (int i = 0; i < 5; ++i) assert_true(measures[i] >= 0 && measures[i] < 10);
    assert_true(d.anisotropy <= 1);
    return d;
}

/* A grey photo of one grain, every value v at column x and row y replaced by change(v, x, y). */
static weft_description described_after(Grain grain, float (*change)(float v, int x, int y))
{
    weft_image photo = new_grain(grain, SIDE, SIDE, 1, 3);
    for (int i = 0; i < AREA; ++i) values(&photo)[i] = change(values(&photo)[i], i % SIDE, i / SIDE);
    const weft_description d = described(&photo);
    free_image(&photo);
    return d;
}

/* Noise has neither structure nor periods, its values are normal, and it is even; streaks alone have a direction. */
static void gaussian_noise(void **state)
{
    (void)state;
    const Grain grains[] = {GRAIN_WHITE, GRAIN_SOFT, GRAIN_BAND, GRAIN_STREAKS};
    for (int i = 0; i < 4; ++i)
        for (uint32_t channels = 1; channels <= 3; channels += 2) {
            weft_image photo = new_grain(grains[i], SIDE, SIDE, channels, 20 + (uint64_t)i);
            const weft_description d = described(&photo);
            assert_int_equal(d.method, WEFT_METHOD_TEXTON);
            assert_true(d.structure < 0.05f && d.structure_toned < 0.05f && d.histogram < 0.03f && d.unevenness < 0.1f);
            if (grains[i] == GRAIN_STREAKS)
                assert_true(d.anisotropy > 0.3f);
            else
                assert_true(d.anisotropy < 0.05f);
            assert_true(d.period_x == 0 && d.period_y == 0);
            free_image(&photo);
        }
}

static float exponential(float v, int x, int y)
{
    (void)x, (void)y;
    return (float)exp(8 * ((double)v - 0.5));
}

/* Values that are not normal: a tone curve makes them so, which wavelet noise has, but directions it has not. */
static void toned_noise(void **state)
{
    (void)state;
    const weft_description soft = described_after(GRAIN_SOFT, exponential),
                           streaks = described_after(GRAIN_STREAKS, exponential);
    assert_int_equal(soft.method, WEFT_METHOD_WAVELET);
    assert_true(soft.histogram > 0.2f && soft.structure > 0.2f && soft.structure_toned < 0.05f &&
                soft.anisotropy < 0.05f);
    assert_true(streaks.method != WEFT_METHOD_WAVELET);
    assert_true(streaks.histogram > 0.2f && streaks.structure_toned < 0.05f && streaks.anisotropy > 0.3f);
}

static float contrast_grows(float v, int x, int y)
{
    (void)y;
    return 0.5f + (v - 0.5f) * (0.1f + 2.0f * (float)x / SIDE);
}

static float brightness_grows(float v, int x, int y)
{
    (void)x;
    return v + 2.0f * (float)y / SIDE;
}

static float only_brightness(float v, int x, int y)
{
    (void)v;
    return (float)(x + y) / (2 * SIDE);
}

/* A gradient, of contrast or of brightness, is not stationary, and repeats nothing. */
static void gradients_are_uneven(void **state)
{
    (void)state;
    const weft_description contrast = described_after(GRAIN_SOFT, contrast_grows),
                           light = described_after(GRAIN_SOFT, brightness_grows);
    assert_true(contrast.unevenness > 0.4f && light.unevenness > 0.4f);
    assert_true(contrast.period_x == 0 && contrast.period_y == 0 && light.period_x == 0 && light.period_y == 0);
    assert_true(described_after(GRAIN_SOFT, only_brightness).unevenness > 0.2f);
}

enum { TILE_X = 24, TILE_Y = 16, JOINT = 3 };

static float tiles(float v, int x, int y)
{
    return 0.2f * v + (x % TILE_X < JOINT || y % TILE_Y < JOINT ? 0.2f : 0.7f);
}

static float stripes(float v, int x, int y)
{
    (void)y;
    return 0.2f * v + (x % 20 < 7 ? 0.2f : 0.7f);
}

/* A pattern: its periods to the pixel, also under noise, and structure that no noise has. */
static void patterns_have_periods(void **state)
{
    (void)state;
    const weft_description tiled = described_after(GRAIN_WHITE, tiles), striped = described_after(GRAIN_SOFT, stripes);
    assert_int_equal(tiled.period_x, TILE_X);
    assert_int_equal(tiled.period_y, TILE_Y);
    assert_true(tiled.structure > 0.16f);
    assert_int_equal(striped.period_x, 20);
    assert_true(striped.anisotropy > 0.5f);
}

static float nothing(float v, int x, int y)
{
    (void)v, (void)x, (void)y;
    return 0.25f;
}

static void one_colour(void **state)
{
    (void)state;
    const weft_description d = described_after(GRAIN_WHITE, nothing);
    assert_true(d.structure == 0 && d.histogram == 0 && d.anisotropy == 0 && d.unevenness == 0);
    assert_true(d.period_x == 0 && d.period_y == 0);
}

/* The answer is one, whatever the number of threads; and what the pixels are multiplied by does not change it much. */
static void the_same_again(void **state)
{
    (void)state;
    weft_image photo = new_grain(GRAIN_SOFT, 97, 131, 3, 8), bytes = new_image(97, 131, 3, WEFT_FORMAT_U8);
    const weft_description first = described(&photo);
    for (uint32_t threads = 1; threads <= 3; ++threads) {
        weft_context *other = new_context("scalar", threads);
        weft_description again = WEFT_DESCRIPTION_INIT;
        assert_ok(weft_describe(other, &photo, NULL, NULL, &again));
        assert_memory_equal(&again, &first, sizeof first);
        weft_context_free(other);
    }
    for (size_t i = 0; i < (size_t)97 * 131 * 3; ++i)
        ((uint8_t *)bytes.data)[i] = (uint8_t)lrintf(255 * fminf(fmaxf(values(&photo)[i], 0), 1));
    const weft_description rounded = described(&bytes);
    assert_int_equal(rounded.method, first.method);
    assert_true(fabsf(rounded.structure - first.structure) < 0.01f &&
                fabsf(rounded.histogram - first.histogram) < 0.01f);
    free_image(&bytes);
    free_image(&photo);
}

/* Nothing larger or smaller than it can be: the least photo, and one that is longer than what is looked at. */
static void sizes(void **state)
{
    (void)state;
    const uint32_t edges[][2] = {{16, 16}, {16, 700}, {700, 17}};
    for (int i = 0; i < 3; ++i) {
        weft_image photo = new_grain(GRAIN_SOFT, edges[i][0], edges[i][1], 16, 5);
        described(&photo);
        free_image(&photo);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gaussian_noise),
        cmocka_unit_test(toned_noise),
        cmocka_unit_test(gradients_are_uneven),
        cmocka_unit_test(patterns_have_periods),
        cmocka_unit_test(one_colour),
        cmocka_unit_test(the_same_again),
        cmocka_unit_test(sizes),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
