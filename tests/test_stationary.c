/* Stationary tiles: the same for any number of threads, periodic to the bit, made of the photo's colours, and of any
 * other map by the same correspondence. */
#include "executors.h"
#include "stained.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static weft_context *context;
static weft_image photo; /* 96 x 80, RGB */

static int begin(void **state)
{
    (void)state;
    context = new_context("scalar", 2);
    photo = new_stained(STAIN_BLOB, 96, 80, 1);
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_context_free(context);
    free_image(&photo);
    return 0;
}

static weft_model *analyzed(weft_context *with, const weft_image *image, const weft_stationary_options *options)
{
    weft_model *model = NULL;
    assert_ok(weft_analyze_stationary(with, image, options, NULL, NULL, &model));
    assert_non_null(model);
    return model;
}

static weft_stationary_options sized(uint32_t width, uint32_t height)
{
    weft_stationary_options options = WEFT_STATIONARY_OPTIONS_INIT;
    options.width = width;
    options.height = height;
    return options;
}

static void assert_same_models(const weft_model *a, const weft_model *b)
{
    size_t size = 0, other = 0;
    void *bytes = saved(a, &size), *others = saved(b, &other);
    assert_int_equal(size, other);
    assert_memory_equal(bytes, others, size);
    free(bytes);
    free(others);
}

/* Each measure, an odd size, a map of sigma: whatever is computed side by side. */
static void threads_change_nothing(void **state)
{
    (void)state;
    weft_image map = new_image(3, 2, 1, WEFT_FORMAT_F32);
    for (int i = 0; i < 6; ++i) values(&map)[i] = 0.2f + 0.15f * (float)i;
    for (int variant = 0; variant < 7; ++variant) {
        weft_stationary_options options = sized(64 + 7 * (uint32_t)(variant % 3), 64 + 5 * (uint32_t)(variant % 2));
        options.stationarity = variant < 5 ? variant : WEFT_STATIONARITY_HISTOGRAM;
        options.moments = variant == WEFT_STATIONARITY_MOMENTS ? 4 : 0;
        options.start = variant == 6 ? 8 : 0;
        options.sigma_map = variant == 5 ? &map : NULL;
        options.seed = (uint64_t)variant;
        weft_model *reference = NULL;
        for (uint32_t threads = 1; threads <= 4; ++threads) {
            weft_context_options own = WEFT_CONTEXT_OPTIONS_INIT;
            weft_context *other = NULL;
            own.threads = threads;
            own.executor = threads == 4 ? &reversed_executor : NULL;
            assert_ok(weft_context_create(&own, &other));
            weft_model *model = analyzed(other, &photo, &options);
            if (reference) {
                assert_same_models(reference, model);
                weft_model_free(model);
            } else {
                reference = model;
            }
            weft_context_free(other);
        }
        weft_model_free(reference);
    }
    free_image(&map);
}

static void formats_and_strides_change_nothing(void **state)
{
    (void)state;
    weft_image bytes = new_image(40, 33, 3, WEFT_FORMAT_U8), words = new_image(40, 33, 3, WEFT_FORMAT_U16),
               floats = new_image(40, 33, 3, WEFT_FORMAT_F32), flipped = bytes;
    Random random = {3};
    for (size_t i = 0; i < 40 * 33 * 3; ++i) {
        const uint8_t byte = (uint8_t)random_below(&random, 256);
        ((uint8_t *)bytes.data)[i] = byte;
        ((uint16_t *)words.data)[i] = (uint16_t)(byte * 257);
        values(&floats)[i] = (float)byte / 255;
    }
    const weft_stationary_options options = sized(64, 64);
    weft_model *a = analyzed(context, &bytes, &options), *b = analyzed(context, &words, &options),
               *c = analyzed(context, &floats, &options);
    assert_same_models(a, b);
    assert_same_models(a, c);
    flipped.data = (uint8_t *)bytes.data + 40 * 3 * 32;
    flipped.stride = -40 * 3;
    weft_model *d = analyzed(context, &flipped, &options);
    weft_image tile = part_of(a, 0), other = part_of(d, 0);
    assert_false(same_pixels(&tile, &other));
    free_image(&tile);
    free_image(&other);
    weft_model_free(a);
    weft_model_free(b);
    weft_model_free(c);
    weft_model_free(d);
    free_image(&bytes);
    free_image(&words);
    free_image(&floats);
}

/* Written anew only when a release changes tiles on purpose. */
static void a_seed_gives_the_same_tile_everywhere(void **state)
{
    (void)state;
    static const uint64_t expected[4] = {UINT64_C(0x782944cc07d88def), UINT64_C(0xa33aea0c57482274),
                                         UINT64_C(0xe639fc9bc058db31), UINT64_C(0xb26efb5bb8d19328)};
    int wrong = 0;
    weft_image grain = new_stained(STAIN_BLOTCHES, 96, 80, 7), bytes = new_image(96, 80, 3, WEFT_FORMAT_U8);
    for (size_t i = 0; i < 96 * 80 * 3; ++i) ((uint8_t *)bytes.data)[i] = (uint8_t)(values(&grain)[i] * 255);
    for (int i = 0; i < 4; ++i) {
        weft_stationary_options options = sized(80, 72);
        size_t size = 0;
        options.stationarity = 1 + i;
        options.moments = 4;
        options.seed = 1;
        weft_model *model = analyzed(context, &bytes, &options);
        void *file = saved(model, &size);
        const uint64_t sum = checksum(file, size);
        if (sum != expected[i]) print_error("measure %d: %016llx\n", i + 1, (unsigned long long)sum);
        wrong += sum != expected[i];
        free(file);
        weft_model_free(model);
    }
    assert_int_equal(wrong, 0);
    free_image(&grain);
    free_image(&bytes);
}

static void seeds_give_other_tiles(void **state)
{
    (void)state;
    weft_stationary_options options = sized(64, 64);
    weft_model *first = analyzed(context, &photo, &options), *same = analyzed(context, &photo, &options);
    assert_same_models(first, same);
    options.seed = 1;
    weft_model *other = analyzed(context, &photo, &options);
    weft_image tile = part_of(first, 0), changed = part_of(other, 0);
    assert_false(same_pixels(&tile, &changed));
    free_image(&tile);
    free_image(&changed);
    weft_model_free(first);
    weft_model_free(same);
    weft_model_free(other);
}

/* What weft.h and the file's format say: the mean of what the middles of the patches of all pixels near by have there.
 */
static weft_image assembled(const weft_image *map, const weft_image *correspondence, uint32_t patch)
{
    const int width = (int)correspondence->width, height = (int)correspondence->height;
    const int voting = patch < 7 ? (int)patch : 7, reach = voting / 2;
    weft_image tile = new_image(correspondence->width, correspondence->height, map->channels, WEFT_FORMAT_F32);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (uint32_t c = 0; c < map->channels; ++c) {
                double sum = 0;
                for (int dy = -reach; dy <= reach; ++dy)
                    for (int dx = -reach; dx <= reach; ++dx) {
                        const uint32_t near_x = (uint32_t)(x - dx + width) % correspondence->width,
                                       near_y = (uint32_t)(y - dy + height) % correspondence->height;
                        const int from_x = (int)value_at(correspondence, near_x, near_y, 0) + dx,
                                  from_y = (int)value_at(correspondence, near_x, near_y, 1) + dy;
                        assert_in_range(from_x, 0, map->width - 1);
                        assert_in_range(from_y, 0, map->height - 1);
                        sum += (double)value_at(map, (uint32_t)from_x, (uint32_t)from_y, c);
                    }
                values(&tile)[((size_t)y * tile.width + (size_t)x) * map->channels + c] =
                    (float)(sum / (voting * voting));
            }
    return tile;
}

static void check_information(const weft_model *model, uint32_t channels)
{
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    weft_part_info part = WEFT_PART_INFO_INIT;
    assert_ok(weft_model_get(model, &info));
    assert_int_equal(info.method, WEFT_METHOD_STATIONARY);
    assert_int_equal(info.channels, channels);
    assert_int_equal(info.parts, 2);
    assert_int_equal(info.width, 64);
    assert_int_equal(info.height, 75);
    assert_int_equal(info.photo_width, 70);
    assert_int_equal(info.photo_height, 64);
    assert_true(info.model_error == -1);
    assert_ok(weft_model_part(model, 0, &part));
    assert_string_equal(part.name, "tile");
    assert_int_equal(part.channels, channels);
    assert_ok(weft_model_part(model, 1, &part));
    assert_string_equal(part.name, "correspondence");
    assert_int_equal(part.channels, 2);
    assert_int_equal(part.width, 64);
    assert_int_equal(part.height, 75);
    assert_true(part.low >= 3 && part.high <= 66);
}

static void assert_near(const weft_image *a, const weft_image *b)
{
    for (size_t k = 0; k < (size_t)a->width * a->height * a->channels; ++k)
        assert_true(fabsf(values(a)[k] - values(b)[k]) < 1e-6f);
}

/* A map of 16 bits, in its own format and exactly. */
static void check_other_map(const weft_model *model, const weft_image *correspondence, uint32_t patch)
{
    weft_image map = new_image(70, 64, 2, WEFT_FORMAT_U16), wide = new_image(70, 64, 2, WEFT_FORMAT_F32),
               rounded = new_image(64, 75, 2, WEFT_FORMAT_U16), exact = new_image(64, 75, 2, WEFT_FORMAT_F32);
    Random random = {9};
    for (size_t k = 0; k < 70 * 64 * 2; ++k) {
        const uint16_t word = (uint16_t)random_bits(&random);
        ((uint16_t *)map.data)[k] = word;
        values(&wide)[k] = (float)word / 65535;
    }
    assert_ok(weft_model_apply(model, &map, &rounded));
    assert_ok(weft_model_apply(model, &map, &exact));
    weft_image direct = assembled(&wide, correspondence, patch);
    assert_near(&direct, &exact);
    for (size_t k = 0; k < 64 * 75 * 2; ++k)
        assert_true(fabs(((uint16_t *)rounded.data)[k] - (double)values(&exact)[k] * 65535) <
                    0.51); /* float has 24 bits */
    free_image(&direct);
    free_image(&wide);
    free_image(&exact);
    free_image(&rounded);
    free_image(&map);
}

static void maps_are_put_together_as_the_photo_was(void **state)
{
    (void)state;
    const uint32_t channels[] = {1, 2, 3, 4, 7};
    for (int i = 0; i < 5; ++i) {
        weft_image maps = new_stained_maps(70, 64, channels[i], (uint64_t)i);
        weft_stationary_options options = sized(64, 75);
        options.patch = i % 2 ? 7 : 11;
        weft_model *model = analyzed(context, &maps, &options);
        check_information(model, channels[i]);
        weft_image tile = part_of(model, 0), correspondence = part_of(model, 1),
                   applied = new_image(64, 75, channels[i], WEFT_FORMAT_F32);
        assert_ok(weft_model_apply(model, &maps, &applied));
        assert_same_pixels(&tile, &applied, "the photo put together again");
        weft_image direct = assembled(&maps, &correspondence, options.patch);
        assert_near(&direct, &tile);
        check_other_map(model, &correspondence, options.patch);
        free_image(&direct);
        free_image(&applied);
        free_image(&correspondence);
        free_image(&tile);
        free_image(&maps);
        weft_model_free(model);
    }
}

static void colours_are_within_the_photos(void **state)
{
    (void)state;
    weft_image maps = new_stained_maps(60, 50, 5, 4);
    for (int i = 0; i < 60 * 50 * 5; ++i) values(&maps)[i] = 3 * values(&maps)[i] - 1; /* not all within 0..1 */
    const weft_stationary_options options = sized(70, 64);
    weft_model *model = analyzed(context, &maps, &options);
    weft_image tile = part_of(model, 0);
    for (uint32_t c = 0; c < 5; ++c) {
        float low = values(&maps)[c], high = low;
        for (size_t i = 0; i < 60 * 50; ++i) {
            const float value = values(&maps)[5 * i + c];
            low = value < low ? value : low;
            high = value > high ? value : high;
        }
        for (size_t i = 0; i < 70 * 64; ++i)
            assert_true(values(&tile)[5 * i + c] >= low && values(&tile)[5 * i + c] <= high);
    }
    free_image(&tile);
    weft_model_free(model);
    free_image(&maps);
}

static weft_image window_of(const weft_texture *texture, int64_t x, int64_t y)
{
    return rendered(texture, x, y, 0, 72, 65, 3);
}

static void check_period(weft_context *with, const weft_model *model, const weft_image *tile)
{
    weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    weft_texture *texture = NULL;
    options.period_x = 144;
    options.period_y = 65;
    assert_ok(weft_texture_create(with, model, &options, &texture));
    weft_image window = window_of(texture, 144, 65);
    assert_same_pixels(tile, &window, "the texture with a period");
    free_image(&window);
    weft_texture_free(texture);
    options.period_x = 100;
    assert_refused(weft_texture_create(with, model, &options, &texture), WEFT_ERROR_ARGUMENT, "weft_texture_create",
                   "period_x");
}

/* Coarse windows and points with footprints, one after another. */
static uint64_t filtered_checksum(const weft_texture *texture)
{
    weft_point points[50];
    float samples[3 * 50];
    uint64_t sum = 0;
    for (uint32_t level = 1; level <= 9; level += 4) {
        weft_image window = rendered(texture, -7, 3, level, 40, 30, 3);
        sum = 31 * sum + checksum(window.data, image_bytes(&window));
        free_image(&window);
    }
    for (int i = 0; i < 50; ++i) {
        const weft_point point = {13.7 * i - 200, 5.3 * i, {0.3f * (float)i, 0.1f}, {0.2f, 0.05f * (float)i}};
        points[i] = point;
    }
    assert_ok(weft_texture_sample(texture, 50, points, samples));
    return 31 * sum + checksum(samples, sizeof samples);
}

static void tiles_repeat_exactly_on_every_device(void **state)
{
    (void)state;
    char names[MOST_DEVICES][64];
    const uint32_t count = usable_devices(names, 1);
    const weft_stationary_options options = sized(72, 65);
    weft_model *model = analyzed(context, &photo, &options);
    weft_image tile = part_of(model, 0);
    uint64_t expected = 0;
    for (uint32_t d = 0; d < count; ++d) {
        weft_context *with = new_context(names[d], 2);
        weft_texture *texture = new_texture(with, model, 0, 0, 0);
        weft_image window = window_of(texture, 0, 0);
        assert_same_pixels(&tile, &window, names[d]);
        free_image(&window);
        window = window_of(texture, 72 * INT64_C(1000000007), -65 * INT64_C(123456789));
        assert_same_pixels(&tile, &window, names[d]);
        free_image(&window);
        if (d == 0) expected = filtered_checksum(texture);
        assert_int_equal(expected, filtered_checksum(texture));
        check_period(with, model, &tile);
        weft_texture_free(texture);
        weft_context_free(with);
    }
    free_image(&tile);
    weft_model_free(model);
}

typedef struct Steps {
    uint32_t calls, level, iteration;
    int wrong;
} Steps;

static void on_step(void *user, const weft_stationary_step *step)
{
    Steps *steps = user;
    const int next = step->level == steps->level ? step->iteration == steps->iteration + 1
                                                 : step->level == steps->level + 1 && step->iteration == 0;
    if (steps->calls > 0 ? !next : step->level != 0 || step->iteration != 0) steps->wrong = 1;
    if (step->size != sizeof *step || step->level >= step->levels || step->iteration >= step->iterations)
        steps->wrong = 2;
    if (step->width > 80 || step->height > 64 || !(step->texture_cost >= 0)) steps->wrong = 3;
    if (!(step->stationarity_cost >= 0) && step->stationarity_cost != -1) steps->wrong = 4;
    if (step->level + 1 == step->levels && (step->width != 80 || step->height != 64)) steps->wrong = 5;
    steps->level = step->level;
    steps->iteration = step->iteration;
    ++steps->calls;
}

static void every_iteration_is_reported(void **state)
{
    (void)state;
    Steps steps = {0, 0, 0, 0};
    weft_stationary_options options = sized(80, 64);
    options.report = on_step;
    options.report_user = &steps;
    weft_model *model = analyzed(context, &photo, &options);
    assert_int_equal(steps.wrong, 0);
    assert_true(steps.calls > 10);
    weft_model_free(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(formats_and_strides_change_nothing),
        cmocka_unit_test(seeds_give_other_tiles),
        cmocka_unit_test(a_seed_gives_the_same_tile_everywhere),
        cmocka_unit_test(maps_are_put_together_as_the_photo_was),
        cmocka_unit_test(colours_are_within_the_photos),
        cmocka_unit_test(tiles_repeat_exactly_on_every_device),
        cmocka_unit_test(every_iteration_is_reported),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
