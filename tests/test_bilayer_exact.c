/* Bi-layer textures: every exact device gives the bits of "scalar", in windows and at points, of every kind of model
 * and with every option; and so does any number of threads. */
#include "bilayers.h"
#include <string.h>

static char devices[MOST_DEVICES][64]; /* the exact ones; [0] is "scalar" */
static uint32_t device_count;
static weft_context *contexts[MOST_DEVICES];
static weft_model *models[BILAYER_KINDS];

static int begin(void **state)
{
    (void)state;
    device_count = usable_devices(devices, 1);
    assert_string_equal(devices[0], "scalar");
    for (uint32_t d = 0; d < device_count; ++d) contexts[d] = new_context(devices[d], 1 + d % 3);
    for (uint32_t kind = 0; kind < BILAYER_KINDS; ++kind) models[kind] = new_bilayer(contexts[0], kind);
    return 0;
}

static int end(void **state)
{
    (void)state;
    for (uint32_t kind = 0; kind < BILAYER_KINDS; ++kind) weft_model_free(models[kind]);
    for (uint32_t d = 0; d < device_count; ++d) weft_context_free(contexts[d]);
    return 0;
}

/* One model on every device. */
typedef struct Case {
    const char *name;
    uint32_t channels;
    weft_texture *textures[MOST_DEVICES];
} Case;

static Case open_case(uint32_t kind, const weft_texture_options *options)
{
    Case c = {bilayer_kind(kind), 0, {NULL}};
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    assert_ok(weft_model_get(models[kind], &info));
    c.channels = info.channels;
    for (uint32_t d = 0; d < device_count; ++d)
        assert_ok(weft_texture_create(contexts[d], models[kind], options, &c.textures[d]));
    return c;
}

static void close_case(Case *c)
{
    for (uint32_t d = 0; d < device_count; ++d) weft_texture_free(c->textures[d]);
}

static void check_window(const Case *c, int64_t x, int64_t y, uint32_t level, uint32_t width, uint32_t height)
{
    weft_image expected = rendered(c->textures[0], x, y, level, width, height, c->channels);
    for (uint32_t d = 1; d < device_count; ++d) {
        weft_image image = rendered(c->textures[d], x, y, level, width, height, c->channels);
        if (!same_pixels(&image, &expected))
            print_error("%s, window %ux%u at %lld %lld level %u\n", c->name, width, height, (long long)x, (long long)y,
                        level);
        assert_same_pixels(&image, &expected, devices[d]);
        free_image(&image);
    }
    free_image(&expected);
}

/* Points at pixel centres are the window's pixels, on every device. */
static void check_centres(const Case *c, int64_t x, int64_t y)
{
    enum { WIDTH = 19, HEIGHT = 5 };
    weft_image expected = rendered(c->textures[0], x, y, 0, WIDTH, HEIGHT, c->channels);
    weft_point points[WIDTH * HEIGHT];
    float out[WIDTH * HEIGHT * 4];
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
    enum { COUNT = 60 };
    weft_point points[COUNT];
    float expected[COUNT * 4], out[COUNT * 4];
    for (int i = 0; i < COUNT; ++i) {
        const double far = random_below(random, 3) ? 0 : 0x1p40;
        const float size = random_below(random, 2) ? 0 : (float)(random_unit(random) * 20);
        const weft_point point = {far + 200 * random_unit(random) - 100,
                                  -far + 200 * random_unit(random) - 100,
                                  {size * (float)random_unit(random), 0},
                                  {size * (float)(random_unit(random) - 0.5), size}};
        points[i] = point;
    }
    assert_ok(weft_texture_sample(c->textures[0], COUNT, points, expected));
    for (uint32_t d = 0; d < device_count; ++d) {
        memset(out, 0xff, sizeof out);
        assert_ok(weft_texture_sample(c->textures[d], COUNT, points, out));
        assert_memory_equal(out, expected, COUNT * c->channels * sizeof *out);
        for (int i = 0; i < COUNT; i += 7)
            assert_ok(weft_texture_sample(c->textures[d], 1, points + i, out + (size_t)i * c->channels));
        assert_memory_equal(out, expected, COUNT * c->channels * sizeof *out);
    }
}

static weft_texture_options options_of(uint32_t variant)
{
    weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    options.seed = variant;
    options.noise = variant % 2 ? WEFT_NOISE_TILE : WEFT_NOISE_DEFAULT;
    options.rotation = (weft_rotation)(variant % 3);
    options.scale_min = variant % 4 == 1 ? 0.5f : 0;
    options.turbulence = variant % 4 == 2 ? 6 : variant % 4 == 3 ? -1 : 0;
    return options;
}

static void windows_and_points(void **state)
{
    (void)state;
    const int64_t far = INT64_C(1) << 40;
    Random random = {2017};
    for (uint32_t kind = 0; kind < BILAYER_KINDS; ++kind)
        for (uint32_t variant = kind; variant < kind + scaled(2, 1); ++variant) {
            const weft_texture_options options = options_of(variant);
            Case c = open_case(kind, &options);
            check_window(&c, -37, 91, 0, 67, 41);
            check_window(&c, far - 11, -far + 3, 0, 33, 17);
            check_window(&c, -9, 5, 1, 40, 21);
            check_window(&c, 3, -6, 2 + variant % 6, 21, 18);
            check_window(&c, 1, -2, 30, 3, 2);
            check_centres(&c, variant % 2 ? far : -20, 13);
            check_points(&c, &random);
            close_case(&c);
        }
}

/* The same pixels as from one window, whatever the threads, in windows cut anywhere. */
static void threads_and_cuts(void **state)
{
    (void)state;
    enum { WIDTH = 150, HEIGHT = 131 };
    for (uint32_t kind = 0; kind < BILAYER_KINDS; kind += 2) {
        const weft_texture_options options = options_of(kind);
        Case c = open_case(kind, &options);
        weft_image whole = rendered(c.textures[0], -70, -60, 0, WIDTH, HEIGHT, c.channels);
        weft_image cut = rendered(c.textures[0], -70 + 31, -60 + 77, 0, 45, 23, c.channels);
        for (uint32_t y = 0; y < 23; ++y)
            assert_memory_equal(values(&cut) + (size_t)y * 45 * c.channels,
                                values(&whole) + ((size_t)(y + 77) * WIDTH + 31) * c.channels,
                                45 * c.channels * sizeof(float));
        free_image(&cut);
        for (uint32_t d = 0; d < device_count; ++d)
            for (uint32_t threads = d % 3 + 1; threads <= 3; threads += 2) { /* a context takes a while on some */
                weft_context *there = new_context(devices[d], threads);
                weft_texture *texture = NULL;
                assert_ok(weft_texture_create(there, models[kind], &options, &texture));
                weft_image image = rendered(texture, -70, -60, 0, WIDTH, HEIGHT, c.channels);
                assert_same_pixels(&image, &whole, devices[d]);
                free_image(&image);
                weft_texture_free(texture);
                weft_context_free(there);
            }
        free_image(&whole);
        close_case(&c);
    }
}

/* A texture with a period repeats exactly after it, and not before. */
static void periods(void **state)
{
    (void)state;
    for (uint32_t kind = 0; kind < BILAYER_KINDS; ++kind)
        for (uint32_t variant = kind; variant < kind + scaled(2, 1); ++variant) {
            weft_texture_options options = options_of(variant);
            options.period_x = 192;
            options.period_y = variant % 2 ? 192 : 0;
            Case c = open_case(kind, &options);
            weft_image here = rendered(c.textures[0], -40, 9, 0, 60, 40, c.channels),
                       next = rendered(c.textures[0], -40 + 192, 9 + 5 * (int64_t)options.period_y, 0, 60, 40,
                                       c.channels);
            assert_same_pixels(&here, &next, bilayer_kind(kind));
            check_window(&c, 170, -20, 0, 40, 30);
            check_window(&c, 170, -20, 3, 16, 12);
            free_image(&here);
            free_image(&next);
            close_case(&c);
        }
}

/* Seeds and options change what is seen. */
static void options_matter(void **state)
{
    (void)state;
    weft_texture_options plain = WEFT_TEXTURE_OPTIONS_INIT;
    Case c = open_case(1, &plain);
    weft_image expected = rendered(c.textures[0], 0, 0, 0, 96, 96, c.channels);
    for (int i = 0; i < 3; ++i) {
        weft_texture_options options = plain;
        if (i == 0) options.seed = 9;
        if (i == 1) options.turbulence = 9;
        if (i == 2) options.noise = WEFT_NOISE_TILE;
        Case other = open_case(1, &options);
        weft_image image = rendered(other.textures[0], 0, 0, 0, 96, 96, c.channels);
        assert_false(same_pixels(&image, &expected));
        free_image(&image);
        close_case(&other);
    }
    free_image(&expected);
    close_case(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(windows_and_points), cmocka_unit_test(threads_and_cuts),
                                       cmocka_unit_test(periods), cmocka_unit_test(options_matter)};
    return cmocka_run_group_tests(tests, begin, end);
}
