/* Every exact device gives the bits of "scalar": for any model, window, level, place, period, batch and number of
 * threads. */
#include "support.h"
#include <stdlib.h>
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

static const weft_interpolation interpolations[] = {WEFT_INTERPOLATION_LINEAR, WEFT_INTERPOLATION_NEAREST,
                                                    WEFT_INTERPOLATION_CUBIC, WEFT_INTERPOLATION_QUINTIC};

/* A random model: linear RGB most often, as in life; every order and number of channels; now and then a picture. */
static weft_model *random_model(Random *random, uint32_t *channels)
{
    *channels = random_below(random, 2) ? 3 : 1 + random_below(random, 16);
    const uint32_t kind = random_below(random, 8);
    if (kind == 0)
        return new_picture(contexts[0], 1 + random_below(random, 70), 1 + random_below(random, 70), *channels,
                           random_bits(random));
    const uint32_t side = 8 + random_below(random, 57), support = 1 + random_below(random, side);
    return new_texton(contexts[0], side, *channels, support, interpolations[kind < 5 ? 0 : kind - 4],
                      random_bits(random));
}

static float random_impacts(Random *random)
{
    const float some[] = {1, 1.5f, 3, 10, 30, 30, 30, 100, 317.25f, 1000};
    return some[random_below(random, sizeof some / sizeof *some)];
}

static int64_t random_place(Random *random)
{
    const int64_t far = INT64_C(1) << 40, some[] = {0, -37, 977, -91, far, -far, far - 17, -far + 5};
    return some[random_below(random, 8)] + (int64_t)random_below(random, 100);
}

/* A period for each axis that the model can have; 0 often. */
static void random_period(Random *random, const weft_model *model, weft_texture_options *options)
{
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    assert_ok(weft_model_get(model, &info));
    const uint32_t some[] = {0, 0, 0, 1, 37, 64, 101, 1000, 1003, 1u << 24};
    options->period_x = some[random_below(random, 10)];
    options->period_y = random_below(random, 2) ? options->period_x : some[random_below(random, 10)];
    if (info.method != WEFT_METHOD_PICTURE) return;
    options->period_x = options->period_x ? info.width * (1 + random_below(random, 5)) : 0;
    options->period_y = options->period_y ? info.height * (1 + random_below(random, 5)) : 0;
}

typedef struct Case {
    weft_model *model;
    uint32_t channels;
    weft_texture *textures[MOST_DEVICES];
    weft_texture_options options;
} Case;

static Case open_case(Random *random)
{
    const weft_texture_options fresh = WEFT_TEXTURE_OPTIONS_INIT;
    Case c = {NULL, 0, {NULL}, fresh};
    c.model = random_model(random, &c.channels);
    c.options.impacts = random_impacts(random);
    c.options.seed = random_below(random, 4) ? random_bits(random) : random_below(random, 3);
    random_period(random, c.model, &c.options);
    for (uint32_t d = 0; d < device_count; ++d)
        assert_ok(weft_texture_create(contexts[d], c.model, &c.options, &c.textures[d]));
    return c;
}

static void close_case(Case *c)
{
    for (uint32_t d = 0; d < device_count; ++d) weft_texture_free(c->textures[d]);
    weft_model_free(c->model);
}

static void windows_of(const Case *c, Random *random, uint32_t number)
{
    const uint32_t sizes[][2] = {{1, 1}, {64, 64}, {37, 53}, {97, 21}, {1, 40}, {130, 1}, {16, 9}};
    const uint32_t pick = random_below(random, 7), costly = c->options.impacts > 90 || c->channels > 6;
    const uint32_t width = costly ? (sizes[pick][0] + 3) / 4 : sizes[pick][0],
                   height = costly ? (sizes[pick][1] + 3) / 4 : sizes[pick][1];
    const uint32_t level = random_below(random, 3)    ? 0
                           : random_below(random, 10) ? random_below(random, 8)
                                                      : random_below(random, 31);
    int64_t x = random_place(random), y = random_place(random);
    if (level > 18) x >>= 20, y >>= 20;
    weft_image expected = rendered(c->textures[0], x, y, level, width, height, c->channels);
    for (uint32_t d = 1; d < device_count; ++d) {
        weft_image image = rendered(c->textures[d], x, y, level, width, height, c->channels);
        if (!same_pixels(&image, &expected))
            print_error(
                "case %u: %u channels, impacts %g, period %u %u, seed %llu, window %ux%u at %lld %lld level %u\n",
                number, c->channels, (double)c->options.impacts, c->options.period_x, c->options.period_y,
                (unsigned long long)c->options.seed, width, height, (long long)x, (long long)y, level);
        assert_same_pixels(&image, &expected, devices[d]);
        free_image(&image);
    }
    free_image(&expected);
}

static void points_of(const Case *c, Random *random, uint32_t number)
{
    enum { COUNT = 150 };
    weft_point points[COUNT];
    for (int i = 0; i < COUNT; ++i) {
        const double far = random_below(random, 3) ? 0 : 0x1p40;
        const float size =
            random_below(random, 2) ? 0 : (float)(random_unit(random) * (random_below(random, 4) ? 4 : 300));
        const weft_point point = {far + 200 * random_unit(random) - 100,
                                  -far + 200 * random_unit(random) - 100,
                                  {size * (float)random_unit(random), size * (float)(random_unit(random) - 0.5)},
                                  {size * (float)(random_unit(random) - 0.5), size * (float)random_unit(random)}};
        points[i] = point;
    }
    const size_t count = c->options.impacts > 90 ? COUNT / 5 : COUNT;
    float expected[COUNT * 16], out[COUNT * 16];
    assert_ok(weft_texture_sample(c->textures[0], count, points, expected));
    for (uint32_t d = 0; d < device_count; ++d) {
        memset(out, 0xff, sizeof out);
        assert_ok(weft_texture_sample(c->textures[d], count, points, out));
        if (memcmp(out, expected, count * c->channels * sizeof *out) != 0)
            print_error("case %u: points on %s\n", number, devices[d]);
        assert_memory_equal(out, expected, count * c->channels * sizeof *out);
        for (size_t from = 0, step = 1; from < count;
             from += step, step = 1 + random_below(random, 40)) { /* other batches */
            const size_t n = step < count - from ? step : count - from;
            assert_ok(weft_texture_sample(c->textures[d], n, points + from, out + from * c->channels));
        }
        assert_memory_equal(out, expected, count * c->channels * sizeof *out);
    }
}

static void random_cases(void **state)
{
    (void)state;
    Random random = {20170612};
    for (uint32_t i = 0; i < scaled(40, 10); ++i) {
        Case c = open_case(&random);
        for (int k = 0; k < 4; ++k) windows_of(&c, &random, i);
        points_of(&c, &random, i);
        close_case(&c);
    }
}

/* Every order of interpolation with every number of channels, one after another. */
static void every_order_and_number_of_channels(void **state)
{
    (void)state;
    const uint32_t numbers[] = {1, 3, 16, 2, 4, 5, 8, 11};
    for (uint32_t i = 0; i < scaled(8, 3); ++i)
        for (int order = 0; order < 4; ++order) {
            const uint32_t channels = numbers[i];
            weft_model *model = new_texton(contexts[0], 16, channels, 11, interpolations[order], channels);
            Case c = {model, channels, {NULL}, WEFT_TEXTURE_OPTIONS_INIT};
            c.options.impacts = 12;
            for (uint32_t d = 0; d < device_count; ++d)
                assert_ok(weft_texture_create(contexts[d], model, &c.options, &c.textures[d]));
            Random random = {channels * 10 + (uint32_t)order};
            windows_of(&c, &random, channels);
            points_of(&c, &random, channels);
            close_case(&c);
        }
}

/* At pixel centres, and without derivatives, a point is the pixel: at any distance, in any batch. */
static void points_are_pixels(void **state)
{
    (void)state;
    Random random = {5};
    for (uint32_t i = 0; i < scaled(16, 4); ++i) {
        Case c = open_case(&random);
        const int64_t x = random_place(&random), y = random_place(&random);
        weft_image pixels = rendered(c.textures[0], x, y, 0, 13, 7, c.channels);
        weft_point points[13 * 7];
        float out[13 * 7 * 16];
        for (int k = 0; k < 13 * 7; ++k) {
            const weft_point point = {(double)(x + k % 13) + 0.5, (double)(y + k / 13) + 0.5, {0, 0}, {0, 0}};
            points[k] = point;
        }
        for (uint32_t d = 0; d < device_count; ++d) {
            assert_ok(weft_texture_sample(c.textures[d], 13 * 7, points, out));
            assert_memory_equal(out, pixels.data, image_bytes(&pixels));
        }
        free_image(&pixels);
        close_case(&c);
    }
}

/* A window is the same whole, in pieces, and as part of a larger one; far out as well. */
static void windows_agree_where_they_overlap(void **state)
{
    (void)state;
    Random random = {6};
    for (uint32_t i = 0; i < scaled(12, 3); ++i) {
        Case c = open_case(&random);
        const int64_t x = random_place(&random), y = random_place(&random);
        const uint32_t level = random_below(&random, 4), width = 150, height = 90, channels = c.channels;
        for (uint32_t d = 0; d < device_count; ++d) {
            weft_image whole = rendered(c.textures[d], x, y, level, width, height, channels);
            for (int k = 0; k < 4; ++k) {
                const uint32_t left = random_below(&random, width), top = random_below(&random, height);
                const uint32_t w = 1 + random_below(&random, width - left), h = 1 + random_below(&random, height - top);
                weft_image piece = rendered(c.textures[d], x + left, y + top, level, w, h, channels);
                for (uint32_t row = 0; row < h; ++row)
                    assert_memory_equal(values(&piece) + (size_t)row * w * channels,
                                        values(&whole) + ((size_t)(top + row) * width + left) * channels,
                                        (size_t)w * channels * sizeof(float));
                free_image(&piece);
            }
            free_image(&whole);
        }
        close_case(&c);
    }
}

/* With a period the pixels repeat bit for bit, also at the levels whose pixels divide it. */
static void periods_wrap(void **state)
{
    (void)state;
    const uint32_t periods[][2] = {{64, 64}, {37, 101}, {1000, 8}, {1, 1}, {96, 1u << 24}};
    for (uint32_t i = 0; i < 5; ++i)
        for (int order = 0; order < 4; ++order) {
            weft_model *model = new_texton(contexts[0], 24, 2, 20, interpolations[order], i);
            weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
            options.period_x = periods[i][0];
            options.period_y = periods[i][1];
            options.impacts = 20;
            for (uint32_t d = 0; d < device_count; d += scaled(1, device_count)) {
                weft_texture *texture = NULL;
                assert_ok(weft_texture_create(contexts[d], model, &options, &texture));
                for (uint32_t level = 0; level < 3; ++level) {
                    if (options.period_x % (1u << level) || options.period_y % (1u << level)) continue;
                    const int64_t px = options.period_x >> level, py = options.period_y >> level;
                    weft_image here = rendered(texture, -3, 11, level, 70, 40, 2);
                    const int64_t times[] = {1, -1, 7, -(INT64_C(1) << 30)};
                    for (int k = 0; k < 4; ++k) {
                        weft_image there =
                            rendered(texture, -3 + times[k] * px, 11 + times[3 - k] * py, level, 70, 40, 2);
                        assert_same_pixels(&here, &there, "a period further");
                        free_image(&there);
                    }
                    free_image(&here);
                }
                weft_texture_free(texture);
            }
            weft_model_free(model);
        }
}

/* A picture is its own pixels, again and again. */
static void a_picture_is_itself(void **state)
{
    (void)state;
    weft_image picture = new_grain(GRAIN_WHITE, 23, 17, 3, 8);
    weft_model *model = NULL;
    assert_ok(weft_analyze_picture(contexts[0], &picture, &model));
    for (uint32_t d = 0; d < device_count; ++d) {
        weft_texture *texture = NULL;
        assert_ok(weft_texture_create(contexts[d], model, NULL, &texture));
        weft_image image = rendered(texture, -23 * 5 - 4, 17 * 3 + 2, 0, 60, 50, 3);
        for (uint32_t y = 0; y < 50; ++y)
            for (uint32_t x = 0; x < 60; ++x)
                for (uint32_t c = 0; c < 3; ++c)
                    assert_true(value_at(&image, x, y, c) == value_at(&picture, (x + 19) % 23, (y + 2) % 17, c));
        free_image(&image);
        weft_texture_free(texture);
    }
    weft_model_free(model);
    free_image(&picture);
}

/* The seed chooses the realisation; nothing else is left of it. */
static void seeds_matter(void **state)
{
    (void)state;
    weft_model *model = new_texton(contexts[0], 16, 1, 8, WEFT_INTERPOLATION_LINEAR, 1);
    const uint64_t seeds[] = {0, 1, 2, UINT64_C(1) << 32, UINT64_C(1) << 63, UINT64_MAX};
    weft_image images[6];
    for (int i = 0; i < 6; ++i) {
        weft_texture *texture = new_texture(contexts[0], model, 0, seeds[i], 0);
        images[i] = rendered(texture, 0, 0, 0, 32, 32, 1);
        for (int k = 0; k < i; ++k) assert_false(same_pixels(&images[i], &images[k]));
        weft_texture_free(texture);
    }
    for (int i = 0; i < 6; ++i) free_image(&images[i]);
    weft_model_free(model);
}

/* Integer formats are the floats, rounded to nearest and clamped; strides may have gaps or run upwards. */
static void formats_and_strides(void **state)
{
    (void)state;
    static const char strong[] =
        "TEXTON\n1\n1\n0.5 0.6 0.7\n2 2\n0.5 -0.2 0.1\n-0.3 0.2 0.4\n0.2 0.3 -0.4\n0.1 0.3 0.1\nvalues beyond 0..1\n";
    weft_model *model = NULL;
    assert_ok(weft_model_load_texton(contexts[0], strong, sizeof strong - 1, &model));
    weft_texture *texture = new_texture(contexts[0], model, 30, 3, 0);
    weft_image floats = rendered(texture, 5, 6, 0, 90, 41, 3);
    uint32_t clamped = 0;
    for (int f = 0; f < 3; ++f) {
        const weft_format format = f == 0 ? WEFT_FORMAT_U8 : f == 1 ? WEFT_FORMAT_U16 : WEFT_FORMAT_F32;
        const size_t value_size = f == 0 ? 1 : f == 1 ? 2 : 4, row = 90 * 3 * value_size, gap = 3 * value_size;
        unsigned char *memory = malloc((row + gap) * 41);
        memset(memory, 0xa5, (row + gap) * 41);
        const weft_image upwards = {memory + (row + gap) * 40, -(int64_t)(row + gap), 90, 41, 3, format};
        assert_ok(weft_texture_render(texture, 5, 6, 0, NULL, NULL, &upwards));
        for (uint32_t y = 0; y < 41; ++y) {
            const unsigned char *line = memory + (row + gap) * (40 - y);
            for (size_t k = 0; k < gap; ++k) assert_int_equal(line[row + k], 0xa5);
            for (uint32_t i = 0; i < 90 * 3; ++i) {
                const float value = values(&floats)[y * 270 + i], most = f == 0 ? 255.0f : 65535.0f;
                const double wanted = (double)value <= 0   ? 0
                                      : (double)value >= 1 ? (double)most
                                                           : (double)value * (double)most;
                uint16_t word;
                memcpy(&word, line + 2 * i, f == 1 ? sizeof word : 0);
                const double got = f == 0 ? line[i] : f == 1 ? word : 0;
                const double rounding = (double)most * 0x1p-24; /* of the product in binary32 */
                if (f < 2)
                    assert_true(got - wanted <= 0.5 + rounding && wanted - got <= 0.5 + rounding);
                else
                    assert_memory_equal(line + 4 * i, &value, 4);
                clamped += (double)value < 0 || (double)value > 1;
            }
        }
        free(memory);
    }
    assert_true(clamped > 0);
    free_image(&floats);
    weft_texture_free(texture);
    weft_model_free(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_cases),      cmocka_unit_test(every_order_and_number_of_channels),
        cmocka_unit_test(points_are_pixels), cmocka_unit_test(windows_agree_where_they_overlap),
        cmocka_unit_test(periods_wrap),      cmocka_unit_test(a_picture_is_itself),
        cmocka_unit_test(seeds_matter),      cmocka_unit_test(formats_and_strides),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
