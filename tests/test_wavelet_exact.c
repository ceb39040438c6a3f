/* Wavelet noise: every exact device gives the bits of "scalar", in windows, at points and in space. */
#include "wavelets.h"
#include <math.h>
#include <string.h>

static char devices[MOST_DEVICES][64]; /* the exact ones; [0] is "scalar" */
static uint32_t device_count;
static weft_context *contexts[MOST_DEVICES];

static int begin(void **state)
{
    (void)state;
    device_count = usable_devices(devices, 1);
    assert_true(device_count >= 1);
    assert_string_equal(devices[0], "scalar");
    for (uint32_t d = 0; d < device_count; ++d) {
        contexts[d] = new_context(devices[d], 1 + d % 3);
        print_message("           %s\n", devices[d]);
    }
    return 0;
}

static int end(void **state)
{
    (void)state;
    for (uint32_t d = 0; d < device_count; ++d) weft_context_free(contexts[d]);
    return 0;
}

/* One model on every device. */
typedef struct Case {
    weft_model *model;
    uint32_t channels;
    weft_texture *textures[MOST_DEVICES];
    weft_texture_options options;
} Case;

static Case open_case(weft_model *model, uint64_t seed, uint32_t period_x, uint32_t period_y)
{
    Case c = {model, 0, {NULL}, WEFT_TEXTURE_OPTIONS_INIT};
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    assert_ok(weft_model_get(model, &info));
    c.channels = info.channels;
    c.options.seed = seed;
    c.options.period_x = period_x;
    c.options.period_y = period_y;
    for (uint32_t d = 0; d < device_count; ++d) assert_ok(weft_texture_create(contexts[d], model, &c.options, &c.textures[d]));
    return c;
}

static void close_case(Case *c)
{
    for (uint32_t d = 0; d < device_count; ++d) weft_texture_free(c->textures[d]);
    weft_model_free(c->model);
}

static void check_window(const Case *c, int64_t x, int64_t y, uint32_t level, uint32_t width, uint32_t height)
{
    weft_image expected = rendered(c->textures[0], x, y, level, width, height, c->channels);
    for (uint32_t d = 1; d < device_count; ++d) {
        weft_image image = rendered(c->textures[d], x, y, level, width, height, c->channels);
        if (!same_pixels(&image, &expected))
            print_error("%u channels, period %u %u, window %ux%u at %lld %lld level %u\n", c->channels, c->options.period_x, c->options.period_y,
                        width, height, (long long)x, (long long)y, level);
        assert_same_pixels(&image, &expected, devices[d]);
        free_image(&image);
    }
    free_image(&expected);
}

static void check_window_by_points(const Case *c, int64_t x, int64_t y)
{
    enum { WIDTH = 21, HEIGHT = 6 };
    weft_image expected = rendered(c->textures[0], x, y, 0, WIDTH, HEIGHT, c->channels);
    weft_point points[WIDTH * HEIGHT];
    float out[WIDTH * HEIGHT * 16];
    for (int k = 0; k < WIDTH * HEIGHT; ++k) {
        const weft_point point = {(double)(x + k % WIDTH) + 0.5, (double)(y + k / WIDTH) + 0.5, {0, 0}, {0, 0}};
        points[k] = point;
    }
    for (uint32_t d = 0; d < device_count; ++d) {
        memset(out, 0xff, sizeof out);
        assert_ok(weft_texture_sample(c->textures[d], WIDTH * HEIGHT, points, out));
        assert_memory_equal(out, expected.data, image_bytes(&expected));
    }
    free_image(&expected);
}

static void check_points(const Case *c, Random *random)
{
    enum { COUNT = 150 };
    weft_point points[COUNT];
    float expected[COUNT * 16], out[COUNT * 16];
    for (int i = 0; i < COUNT; ++i) {
        const double far = random_below(random, 3) ? 0 : 0x1p40;
        const float size = random_below(random, 2) ? 0 : (float)(random_unit(random) * (random_below(random, 4) ? 4 : 300));
        const weft_point point = {far + 200 * random_unit(random) - 100,
                                  -far + 200 * random_unit(random) - 100,
                                  {size * (float)random_unit(random), size * (float)(random_unit(random) - 0.5)},
                                  {size * (float)(random_unit(random) - 0.5), size * (float)random_unit(random)}};
        points[i] = point;
    }
    assert_ok(weft_texture_sample(c->textures[0], COUNT, points, expected));
    for (uint32_t d = 0; d < device_count; ++d) {
        memset(out, 0xff, sizeof out);
        assert_ok(weft_texture_sample(c->textures[d], COUNT, points, out));
        assert_memory_equal(out, expected, COUNT * c->channels * sizeof *out);
        for (int i = 0; i < COUNT; i += 7) assert_ok(weft_texture_sample(c->textures[d], 1, points + i, out + (size_t)i * c->channels));
        assert_memory_equal(out, expected, COUNT * c->channels * sizeof *out);
    }
}

static int64_t random_place(Random *random)
{
    const int64_t far = INT64_C(1) << 40, some[] = {0, -37, 977, -91, far, -far, far - 17, -far + 5};
    return some[random_below(random, 8)] + (int64_t)random_below(random, 100);
}

static weft_model *random_model(Random *random)
{
    const uint32_t channels = random_below(random, 8) ? 1 + random_below(random, 4) : 1 + random_below(random, 16), bands = 1 + random_below(random, 16);
    const uint32_t knots = random_below(random, 2) ? 0 : 2 + random_below(random, 31);
    const weft_wavelet wavelet = random_wavelet(channels, bands, knots, random_bits(random));
    return new_wavelet(contexts[0], &wavelet);
}

static void windows_and_points(void **state)
{
    (void)state;
    Random random = {2010};
    const uint32_t sizes[][2] = {{1, 1}, {64, 64}, {37, 53}, {97, 21}, {1, 40}, {130, 1}, {16, 9}};
    const uint32_t periods[] = {0, 0, 1, 37, 64, 256, 1000, 1003, 1u << 24};
    for (uint32_t i = 0; i < scaled(10, 3); ++i) {
        const uint32_t period_x = periods[random_below(&random, 9)], period_y = random_below(&random, 2) ? period_x : periods[random_below(&random, 9)];
        Case c = open_case(random_model(&random), random_bits(&random), period_x, period_y);
        for (uint32_t k = 0; k < 4; ++k) {
            const uint32_t *size = sizes[random_below(&random, 7)], level = k == 0 ? 0 : random_below(&random, k == 3 ? 31 : 8);
            int64_t x = random_place(&random), y = random_place(&random);
            if (level > 18) x >>= 20, y >>= 20;
            check_window(&c, x, y, level, size[0], size[1]);
        }
        check_window_by_points(&c, random_place(&random), random_place(&random));
        check_points(&c, &random);
        close_case(&c);
    }
}

/* Larger than what any device makes at once, with one thread and with several. */
static void large_windows(void **state)
{
    (void)state;
    const uint32_t width = scaled(1100, 530), height = scaled(131, 127);
    for (uint32_t i = 0; i < 3; ++i) {
        const weft_wavelet wavelet = random_wavelet(1 + i, 9 - 4 * i, i * 9, i);
        Case c = open_case(new_wavelet(contexts[0], &wavelet), i, 0, i == 2 ? 74 : 0);
        const int64_t x = i == 1 ? -(INT64_C(1) << 40) - 77 : -301, y = i == 1 ? (INT64_C(1) << 40) + 1 : -64;
        weft_image expected = rendered(c.textures[0], x, y, i, width, height, c.channels);
        for (uint32_t d = 0; d < device_count; ++d)
            for (uint32_t threads = 1; threads <= 5; threads += 2) {
                weft_context *there = new_context(devices[d], threads);
                weft_texture *texture = NULL;
                assert_ok(weft_texture_create(there, c.model, &c.options, &texture));
                weft_image image = rendered(texture, x, y, i, width, height, c.channels);
                assert_same_pixels(&image, &expected, devices[d]);
                free_image(&image);
                weft_texture_free(texture);
                weft_context_free(there);
            }
        free_image(&expected);
        close_case(&c);
    }
}

static void overlapping_windows_agree(void **state)
{
    (void)state;
    Random random = {7};
    for (uint32_t i = 0; i < scaled(4, 2); ++i) {
        Case c = open_case(random_model(&random), i, 0, 0);
        const uint32_t level = random_below(&random, 5);
        const int64_t x = random_place(&random), y = random_place(&random);
        weft_image whole = rendered(c.textures[device_count - 1], x, y, level, 90, 41, c.channels);
        for (int k = 0; k < 4; ++k) {
            const uint32_t left = random_below(&random, 60), top = random_below(&random, 30);
            weft_image part = rendered(c.textures[(uint32_t)k % device_count], x + left, y + top, level, 30, 11, c.channels);
            for (uint32_t row = 0; row < 11; ++row)
                assert_memory_equal(values(&part) + (size_t)row * 30 * c.channels, values(&whole) + ((top + row) * (size_t)90 + left) * c.channels,
                                    30 * c.channels * sizeof(float));
            free_image(&part);
        }
        free_image(&whole);
        close_case(&c);
    }
}

/* A period is exact at level 0, and as long as it is whole in pixels of the level. */
static void periods_wrap(void **state)
{
    (void)state;
    const uint32_t periods[][2] = {{64, 64}, {37, 101}, {1000, 1000}, {256, 37}, {96, 1000}};
    const weft_wavelet wavelet = random_wavelet(3, 8, 6, 5);
    for (size_t i = 0; i < sizeof periods / sizeof *periods; ++i) {
        Case c = open_case(new_wavelet(contexts[0], &wavelet), i, periods[i][0], periods[i][1]);
        for (uint32_t level = 0; level < 3 && periods[i][0] % (1u << level) == 0 && periods[i][1] % (1u << level) == 0; ++level) {
            const int64_t step_x = periods[i][0] >> level, step_y = periods[i][1] >> level;
            weft_image one = rendered(c.textures[0], -5, 3, level, 48, 20, 3);
            for (uint32_t d = 0; d < device_count; ++d) {
                weft_image right = rendered(c.textures[d], -5 + step_x, 3, level, 48, 20, 3);
                weft_image far = rendered(c.textures[d], -5 - 1000003 * step_x, 3 + 17 * step_y, level, 48, 20, 3);
                assert_same_pixels(&right, &one, "a period to the right");
                assert_same_pixels(&far, &one, "many periods away");
                free_image(&right);
                free_image(&far);
            }
            free_image(&one);
        }
        close_case(&c);
    }
}

static void seeds_matter(void **state)
{
    (void)state;
    const weft_wavelet wavelet = random_wavelet(1, 4, 0, 5);
    Case a = open_case(new_wavelet(contexts[0], &wavelet), 1, 0, 0), b = open_case(new_wavelet(contexts[0], &wavelet), 2, 0, 0);
    weft_image one = rendered(a.textures[0], 0, 0, 0, 32, 32, 1), two = rendered(b.textures[0], 0, 0, 0, 32, 32, 1);
    assert_false(same_pixels(&one, &two));
    free_image(&one);
    free_image(&two);
    close_case(&a);
    close_case(&b);
}

static void solid_points(void **state)
{
    (void)state;
    enum { COUNT = 200 };
    Random random = {3};
    for (uint32_t i = 0; i < scaled(4, 2); ++i) {
        Case c = open_case(random_model(&random), random_bits(&random), 0, 0);
        weft_solid_point points[COUNT];
        float expected[COUNT * 16], out[COUNT * 16];
        for (int k = 0; k < COUNT; ++k) {
            const double far = random_below(&random, 3) ? 0 : 0x1p40;
            const float footprint = random_below(&random, 2) ? 0 : (float)(random_unit(&random) * (random_below(&random, 3) ? 3 : 200));
            const weft_solid_point point = {{far + 99 * random_unit(&random), -far + 99 * random_unit(&random), 300 * random_unit(&random) - 100},
                                            footprint, 0};
            points[k] = point;
        }
        assert_ok(weft_texture_sample_solid(c.textures[0], COUNT, points, expected));
        for (uint32_t d = 0; d < device_count; ++d) {
            memset(out, 0xff, sizeof out);
            assert_ok(weft_texture_sample_solid(c.textures[d], COUNT, points, out));
            assert_memory_equal(out, expected, COUNT * c.channels * sizeof *out);
            for (int k = 0; k < COUNT; k += 9) assert_ok(weft_texture_sample_solid(c.textures[d], 1, points + k, out + (size_t)k * c.channels));
            assert_memory_equal(out, expected, COUNT * c.channels * sizeof *out);
        }
        close_case(&c);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(windows_and_points), cmocka_unit_test(overlapping_windows_agree),
        cmocka_unit_test(periods_wrap),       cmocka_unit_test(seeds_matter),
        cmocka_unit_test(solid_points),       cmocka_unit_test(large_windows),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
