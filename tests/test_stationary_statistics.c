/* What stationarization promises, on synthetic photographs that are not stationary, against the same synthesis without
 * it; and that a seed gives the same tile on every machine. */
#include "stained.h"
#include <math.h>
#include <stdlib.h>

static weft_context *context;

static int begin(void **state)
{
    (void)state;
    context = new_context(NULL, 2);
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_context_free(context);
    return 0;
}

typedef struct Result {
    float stationarity, texture;
    double sharpness, histogram; /* against the photo */
} Result;

static Result made_with(const weft_image *photo, const weft_stationary_options *options)
{
    weft_model *model = NULL;
    Result result;
    assert_ok(weft_analyze_stationary(context, photo, options, NULL, NULL, &model));
    weft_image tile = part_of(model, 0), lab = new_lab(&tile), photo_lab = new_lab(photo);
    assert_ok(weft_stationarity_cost(context, &tile, NULL, NULL, NULL, NULL, &result.stationarity));
    assert_ok(weft_texture_cost(context, photo, &tile, NULL, NULL, NULL, &result.texture));
    result.sharpness = sharpness(&lab) / sharpness(&photo_lab);
    result.histogram = histogram_difference(&photo_lab, &lab);
    free_image(&photo_lab);
    free_image(&lab);
    free_image(&tile);
    weft_model_free(model);
    return result;
}

static Result made(const weft_image *photo, weft_stationarity measure, uint64_t seed)
{
    weft_stationary_options options = WEFT_STATIONARY_OPTIONS_INIT;
    options.width = options.height = 192;
    options.stationarity = measure;
    options.seed = seed;
    return made_with(photo, &options);
}

static int ascending(const void *left, const void *right)
{
    const double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

static double median(double *list, size_t count)
{
    qsort(list, count, sizeof *list, ascending);
    return list[count / 2];
}

enum { PHOTOS = 3, SEEDS = 2 };

/* Costs ask for even grey mush: sharpness and histogram do not let them have it. */
static void tiles_are_more_stationary_than_without(void **state)
{
    (void)state;
    static const Stain stains[PHOTOS] = {STAIN_BLOB, STAIN_LIGHT, STAIN_BLOTCHES};
    double stationarity[PHOTOS * SEEDS], texture[PHOTOS * SEEDS];
    size_t count = 0;
    for (uint32_t i = 0; i < scaled(PHOTOS, 1); ++i) {
        weft_image photo = new_stained(stains[i], 256, 224, 10 + i);
        for (uint64_t seed = 0; seed < scaled(SEEDS, 1); ++seed) {
            const Result plain = made(&photo, WEFT_STATIONARITY_NONE, seed),
                         even = made(&photo, WEFT_STATIONARITY_HISTOGRAM, seed);
            print_message(
                "photo %u, seed %u: stationarity %.2f of %.2f, texture %.2f of %.2f, sharpness %.2f, histogram %.2f\n",
                i, (unsigned)seed, (double)even.stationarity, (double)plain.stationarity, (double)even.texture,
                (double)plain.texture, even.sharpness, even.histogram);
            stationarity[count] = (double)(even.stationarity / plain.stationarity);
            texture[count++] = (double)(even.texture / plain.texture);
            assert_true(stationarity[count - 1] <= 0.65);
            assert_true(even.sharpness >= 0.75);
            assert_true(even.histogram <= 4.5);
        }
        free_image(&photo);
    }
    assert_true(median(stationarity, count) <= 0.4);
    assert_true(median(texture, count) <= 2);
}

/* The smaller the neighbourhoods that shall be alike, the more are. */
static void sigma_sets_how_stationary(void **state)
{
    (void)state;
    weft_image photo = new_stained(STAIN_BLOTCHES, 160, 160, 5);
    const float sigmas[] = {0.05f, 0.12f, 0.3f};
    float costs[3] = {0, 0, 0};
    for (int i = 0; i < 3; ++i)
        for (uint64_t seed = 0; seed < SEEDS; ++seed) {
            weft_stationary_options options = WEFT_STATIONARY_OPTIONS_INIT;
            options.sigma = sigmas[i];
            options.seed = seed;
            costs[i] += made_with(&photo, &options).stationarity;
        }
    assert_true(costs[0] < costs[1] && costs[1] < costs[2]);
    free_image(&photo);
}

/* White to the left, black to the right: the right is evener. */
static void a_map_sets_it_from_place_to_place(void **state)
{
    (void)state;
    weft_image photo = new_stained(STAIN_BLOTCHES, 160, 160, 6), map = new_image(2, 1, 1, WEFT_FORMAT_F32);
    weft_image costs = new_image(16, 16, 1, WEFT_FORMAT_F32);
    values(&map)[0] = 1;
    double left = 0, right = 0;
    for (uint64_t seed = 0; seed < SEEDS; ++seed) {
        weft_stationary_options options = WEFT_STATIONARY_OPTIONS_INIT;
        weft_model *model = NULL;
        float cost;
        options.sigma = 0.3f;
        options.sigma_map = &map;
        options.seed = seed;
        assert_ok(weft_analyze_stationary(context, &photo, &options, NULL, NULL, &model));
        weft_image tile = part_of(model, 0);
        assert_ok(weft_stationarity_cost(context, &tile, NULL, NULL, NULL, &costs, &cost));
        for (uint32_t y = 0; y < 16; ++y)
            for (uint32_t x = 0; x < 4; ++x) {
                left += (double)value_at(&costs, 2 + x, y, 0);
                right += (double)value_at(&costs, 10 + x, y, 0);
            }
        free_image(&tile);
        weft_model_free(model);
    }
    print_message("left %.1f, right %.1f\n", left, right);
    assert_true(right < left);
    free_image(&costs);
    free_image(&map);
    free_image(&photo);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tiles_are_more_stationary_than_without),
        cmocka_unit_test(sigma_sets_how_stationary),
        cmocka_unit_test(a_map_sets_it_from_place_to_place),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
