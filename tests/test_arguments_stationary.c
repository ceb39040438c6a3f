/* Stationary tiles and their costs with every wrong argument: the status, a sentence with function and argument,
 * untouched outputs. */
#include "refusals.h"
#include "stained.h"
#include <math.h>
#include <string.h>

static weft_context *context;
static weft_image photo; /* 32 x 24, RGB, F32 */
static weft_model *model, *picture;

static int begin(void **state)
{
    (void)state;
    context = new_context("scalar", 1);
    photo = new_stained(STAIN_BLOB, 32, 24, 3);
    model = new_tile(context, 64, 65, 3, 1);
    picture = new_picture(context, 24, 20, 3, 1);
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_model_free(model);
    weft_model_free(picture);
    weft_context_free(context);
    free_image(&photo);
    return 0;
}

#define ANALYZE "weft_analyze_stationary"

static void refused_photo(const weft_image *image, const char *word)
{
    weft_model *made;
    REFUSED_HANDLE(weft_analyze_stationary(context, image, NULL, NULL, NULL, &made), made, WEFT_ERROR_ARGUMENT, ANALYZE,
                   word);
}

static void photos(void **state)
{
    (void)state;
    weft_model *made;
    Bad_view bad[MOST_BAD_VIEWS];
    const uint32_t count = bad_views(&photo, bad);
    for (uint32_t i = 0; i < count; ++i) refused_photo(&bad[i].image, bad[i].word);
    REFUSED_HANDLE(weft_analyze_stationary(NULL, &photo, NULL, NULL, NULL, &made), made, WEFT_ERROR_ARGUMENT, ANALYZE,
                   "context");
    refused_photo(NULL, "photo");
    REFUSED(weft_analyze_stationary(context, &photo, NULL, NULL, NULL, NULL), ANALYZE, "model");

    weft_image narrow = photo, flat = photo;
    narrow.width = 10;
    narrow.stride = 32 * 12;
    flat.height = 10;
    refused_photo(&narrow, "patch");
    refused_photo(&flat, "patch");
    weft_image wide = new_image(8193, 11, 1, WEFT_FORMAT_U8), tall = new_image(11, 8193, 1, WEFT_FORMAT_U8);
    refused_photo(&wide, "8193");
    refused_photo(&tall, "8193");
    free_image(&wide);
    free_image(&tall);
    for (uint32_t channels = 1; channels <= 4; ++channels) {
        weft_image constant = new_image(32, 24, channels, WEFT_FORMAT_U8);
        fill_bytes(&constant, 90);
        refused_photo(&constant, "photo");
        free_image(&constant);
    }
    const float not_finite[] = {NAN, INFINITY, -INFINITY};
    for (uint32_t i = 0; i < 9; ++i) {
        weft_image image = new_stained(STAIN_BLOB, 32, 24, 3);
        const size_t places[] = {0, 32 * 24 * 3 / 2, 32 * 24 * 3 - 1};
        values(&image)[places[i / 3]] = not_finite[i % 3];
        refused_photo(&image, "photo");
        free_image(&image);
    }
}

static void options_of_tiles(void **state)
{
    (void)state;
    weft_model *made;
    Bad_view bad[MOST_BAD_VIEWS];
    const uint32_t count = bad_views(&photo, bad);
    const weft_stationary_options fresh = WEFT_STATIONARY_OPTIONS_INIT;
    for (int i = 0; i < 21; ++i) {
        weft_stationary_options options = fresh;
        const char *word = "";
        switch (i) {
        case 0: options.size = 0, word = "size"; break;
        case 1: options.size = 3, word = "size"; break;
        case 2: options.width = 63, word = "width"; break;
        case 3: options.width = 2049, word = "width"; break;
        case 4: options.height = 63, word = "height"; break;
        case 5: options.height = UINT32_MAX, word = "height"; break;
        case 6: options.stationarity = -1, word = "stationarity"; break;
        case 7: options.stationarity = 5, word = "stationarity"; break;
        case 8: options.moments = 5, word = "moments"; break;
        case 9: options.moments = UINT32_MAX, word = "moments"; break;
        case 10: options.sigma = -0.1f, word = "sigma"; break;
        case 11: options.sigma = 0.019f, word = "sigma"; break;
        case 12: options.sigma = 1.01f, word = "sigma"; break;
        case 13: options.sigma = NAN, word = "sigma"; break;
        case 14: options.patch = 1, word = "patch"; break;
        case 15: options.patch = 12, word = "patch"; break;
        case 16: options.patch = 33, word = "patch"; break;
        case 17: options.patch = 25, word = "patch"; break; /* the photo is 24 high */
        case 18: options.start = 1, word = "start"; break;
        case 19: options.start = 17, word = "start"; break;
        default: options.sigma_map = &photo, word = "sigma_map"; break; /* of 3 channels */
        }
        REFUSED_HANDLE(weft_analyze_stationary(context, &photo, &options, NULL, NULL, &made), made, WEFT_ERROR_ARGUMENT,
                       ANALYZE, word);
    }
    for (uint32_t i = 0; i < count; ++i) {
        weft_stationary_options options = fresh;
        options.sigma_map = &bad[i].image;
        REFUSED_HANDLE(weft_analyze_stationary(context, &photo, &options, NULL, NULL, &made), made, WEFT_ERROR_ARGUMENT,
                       ANALYZE, bad[i].word);
    }
    const float wrong[] = {-0.01f, 1.01f, NAN, INFINITY};
    for (int i = 0; i < 4; ++i) {
        weft_image map = new_image(2, 2, 1, WEFT_FORMAT_F32);
        weft_stationary_options options = fresh;
        values(&map)[i] = wrong[i];
        options.sigma_map = &map;
        REFUSED_HANDLE(weft_analyze_stationary(context, &photo, &options, NULL, NULL, &made), made, WEFT_ERROR_ARGUMENT,
                       ANALYZE, "sigma_map");
        free_image(&map);
    }
}

static void applying(void **state)
{
    (void)state;
    const char *function = "weft_model_apply";
    weft_image map = new_stained_maps(24, 20, 3, 1), tile = new_image(64, 65, 3, WEFT_FORMAT_F32), other;
    Bad_view bad[MOST_BAD_VIEWS];
    const uint32_t count = bad_views(&photo, bad);
    fill_bytes(&tile, 0xa5);
    REFUSED(weft_model_apply(NULL, &map, &tile), function, "model");
    REFUSED(weft_model_apply(model, NULL, &tile), function, "map");
    REFUSED(weft_model_apply(model, &map, NULL), function, "tile");
    for (uint32_t i = 0; i < count; ++i) {
        REFUSED(weft_model_apply(model, &bad[i].image, &tile), function, bad[i].word);
        REFUSED(weft_model_apply(model, &map, &bad[i].image), function, bad[i].word);
    }
    REFUSED(weft_model_apply(model, &photo, &tile), function, "32 x 24");
    for (int i = 0; i < 4; ++i) {
        other = tile;
        const char *word = "tile";
        switch (i) {
        case 0: other.width = 63; break;
        case 1: other.height = 64; break;
        case 2: other.channels = 2, word = "channels"; break;
        default: other.channels = 4, other.format = WEFT_FORMAT_U8, word = "channels"; break;
        }
        REFUSED(weft_model_apply(model, &map, &other), function, word);
    }
    values(&map)[100] = NAN;
    REFUSED(weft_model_apply(model, &map, &tile), function, "map");
    values(&map)[100] = 0;
    assert_refused(weft_model_apply(picture, &map, &tile), WEFT_ERROR_UNSUPPORTED, function, "tile");
    assert_true(all_bytes(&tile, 0xa5));
    free_image(&map);
    free_image(&tile);
}

static void cost_of_stationarity(void **state)
{
    (void)state;
    const char *function = "weft_stationarity_cost";
    const weft_stationarity_options fresh = WEFT_STATIONARITY_OPTIONS_INIT;
    weft_image map = new_image(8, 8, 1, WEFT_FORMAT_F32), small = photo;
    Bad_view bad[MOST_BAD_VIEWS];
    const uint32_t count = bad_views(&photo, bad);
    float cost = 7;
    fill_bytes(&map, 0xa5);
    REFUSED(weft_stationarity_cost(NULL, &photo, NULL, NULL, NULL, &map, &cost), function, "context");
    REFUSED(weft_stationarity_cost(context, NULL, NULL, NULL, NULL, &map, &cost), function, "image");
    REFUSED(weft_stationarity_cost(context, &photo, NULL, NULL, NULL, &map, NULL), function, "cost");
    for (uint32_t i = 0; i < count; ++i) {
        REFUSED(weft_stationarity_cost(context, &bad[i].image, NULL, NULL, NULL, &map, &cost), function, bad[i].word);
        REFUSED(weft_stationarity_cost(context, &photo, NULL, NULL, NULL, &bad[i].image, &cost), function, bad[i].word);
    }
    small.height = 7;
    REFUSED(weft_stationarity_cost(context, &small, NULL, NULL, NULL, &map, &cost), function, "32 x 7");
    for (int i = 0; i < 12; ++i) {
        weft_stationarity_options options = fresh;
        weft_image wrong = map;
        const char *word = "map";
        switch (i) {
        case 0: options.size = 2, word = "size"; break;
        case 1: options.stationarity = -1, word = "stationarity"; break;
        case 2: options.stationarity = WEFT_STATIONARITY_NONE, word = "stationarity"; break;
        case 3: options.sigma = 0.01f, word = "sigma"; break;
        case 4: options.sigma = 2, word = "sigma"; break;
        case 5: options.sigma = NAN, word = "sigma"; break;
        case 6: options.moments = 5, word = "moments"; break;
        case 7: wrong.width = 33; break;
        case 8: wrong.height = 25; break;
        case 9: wrong.format = WEFT_FORMAT_U8, word = "format"; break;
        case 10: wrong.channels = 2, word = "channels"; break;
        default: wrong.stride = 4, word = "stride"; break;
        }
        REFUSED(weft_stationarity_cost(context, &photo, &options, NULL, NULL, &wrong, &cost), function, word);
    }
    assert_true(all_bytes(&map, 0xa5) && cost == 7);
    free_image(&map);
}

static void cost_of_texture(void **state)
{
    (void)state;
    const char *function = "weft_texture_cost";
    const weft_texture_cost_options fresh = WEFT_TEXTURE_COST_OPTIONS_INIT;
    weft_image grey = new_image(32, 32, 1, WEFT_FORMAT_F32), small = photo;
    Bad_view bad[MOST_BAD_VIEWS];
    const uint32_t count = bad_views(&photo, bad);
    float cost = 7;
    REFUSED(weft_texture_cost(NULL, &photo, &photo, NULL, NULL, NULL, &cost), function, "context");
    REFUSED(weft_texture_cost(context, NULL, &photo, NULL, NULL, NULL, &cost), function, "exemplar");
    REFUSED(weft_texture_cost(context, &photo, NULL, NULL, NULL, NULL, &cost), function, "output");
    REFUSED(weft_texture_cost(context, &photo, &photo, NULL, NULL, NULL, NULL), function, "cost");
    REFUSED(weft_texture_cost(context, &photo, &grey, NULL, NULL, NULL, &cost), function, "channels");
    for (uint32_t i = 0; i < count; ++i) {
        REFUSED(weft_texture_cost(context, &bad[i].image, &photo, NULL, NULL, NULL, &cost), function, bad[i].word);
        REFUSED(weft_texture_cost(context, &photo, &bad[i].image, NULL, NULL, NULL, &cost), function, bad[i].word);
    }
    small.height = 10;
    REFUSED(weft_texture_cost(context, &small, &photo, NULL, NULL, NULL, &cost), function, "exemplar");
    REFUSED(weft_texture_cost(context, &photo, &small, NULL, NULL, NULL, &cost), function, "output");
    for (int i = 0; i < 4; ++i) {
        weft_texture_cost_options options = fresh;
        const char *word = "";
        switch (i) {
        case 0: options.size = 3, word = "size"; break;
        case 1: options.patch = 32, word = "patch"; break;
        case 2: options.patch = 25, word = "patch"; break; /* the photo is 24 high */
        default: options.samples = (1u << 20) + 1, word = "samples"; break;
        }
        REFUSED(weft_texture_cost(context, &photo, &photo, &options, NULL, NULL, &cost), function, word);
    }
    weft_texture_cost_options later = fresh;
    later.zero = 1;
    assert_refused(weft_texture_cost(context, &photo, &photo, &later, NULL, NULL, &cost), WEFT_ERROR_UNSUPPORTED,
                   function, "zero");
    assert_true(cost == 7);
    free_image(&grey);
}

/* What other functions say to a model of this method. */
static void other_functions(void **state)
{
    (void)state;
    weft_model *made;
    weft_wavelet wavelet = WEFT_WAVELET_INIT;
    weft_texture *texture = NULL;
    size_t length = 0;
    const weft_surface_point on_surface = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const weft_solid_point in_solid = {{0, 0, 0}, 1, 0};
    float out[3];
    REFUSED_HANDLE(weft_model_mix(context, model, model, 0.5f, 2, &made), made, WEFT_ERROR_UNSUPPORTED,
                   "weft_model_mix", "tiles");
    assert_refused(weft_model_get_wavelet(model, &wavelet), WEFT_ERROR_UNSUPPORTED, "weft_model_get_wavelet",
                   "wavelet");
    assert_refused(weft_model_save_texton(model, NULL, 0, &length), WEFT_ERROR_UNSUPPORTED, "weft_model_save_texton",
                   "");
    weft_part_info part = WEFT_PART_INFO_INIT;
    REFUSED(weft_model_part(model, 2, &part), "weft_model_part", "index");
    assert_ok(weft_texture_create(context, model, NULL, &texture));
    assert_refused(weft_texture_sample_surface(texture, 1, &on_surface, out), WEFT_ERROR_UNSUPPORTED,
                   "weft_texture_sample_surface", "");
    assert_refused(weft_texture_sample_solid(texture, 1, &in_solid, out), WEFT_ERROR_UNSUPPORTED,
                   "weft_texture_sample_solid", "");
    weft_texture_free(texture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(photos),   cmocka_unit_test(options_of_tiles), cmocka_unit_test(cost_of_stationarity),
        cmocka_unit_test(applying), cmocka_unit_test(cost_of_texture),  cmocka_unit_test(other_functions),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
