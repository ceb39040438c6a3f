/* Bi-layer models: bytes there and back, every truncation, damage; parts; refused calls. */
#include "bilayers.h"
#include "refusals.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static weft_context *context;
static weft_model *models[BILAYER_KINDS];

static int begin(void **state)
{
    (void)state;
    context = new_context("scalar", 1);
    for (uint32_t kind = 0; kind < BILAYER_KINDS; ++kind) models[kind] = new_bilayer(context, kind);
    return 0;
}

static int end(void **state)
{
    (void)state;
    for (uint32_t kind = 0; kind < BILAYER_KINDS; ++kind) weft_model_free(models[kind]);
    weft_context_free(context);
    return 0;
}

/* Bytes, information, parts and pixels. */
static void saved_and_loaded(void **state)
{
    (void)state;
    for (uint32_t kind = 0; kind < BILAYER_KINDS; ++kind) {
        size_t size = 0, size_again = 0;
        weft_model *loaded = NULL;
        unsigned char *bytes = saved(models[kind], &size);
        assert_ok(weft_model_load(context, bytes, size, &loaded));
        unsigned char *again = saved(loaded, &size_again);
        assert_int_equal(size, size_again);
        assert_memory_equal(bytes, again, size);
        weft_model_info info = WEFT_MODEL_INFO_INIT, loaded_info = WEFT_MODEL_INFO_INIT;
        assert_ok(weft_model_get(models[kind], &info));
        assert_ok(weft_model_get(loaded, &loaded_info));
        assert_int_equal(info.method, WEFT_METHOD_BILAYER);
        assert_memory_equal(&info, &loaded_info, sizeof info);
        for (uint32_t i = 0; i < info.parts; ++i) {
            weft_image part = part_of(models[kind], i), other = part_of(loaded, i);
            assert_same_pixels(&part, &other, bilayer_kind(kind));
            free_image(&part);
            free_image(&other);
        }
        weft_texture *a = new_texture(context, models[kind], 0, 3, 0), *b = new_texture(context, loaded, 0, 3, 0);
        weft_image first = rendered(a, -5, 8, 0, 70, 60, info.channels),
                   second = rendered(b, -5, 8, 0, 70, 60, info.channels);
        assert_same_pixels(&first, &second, bilayer_kind(kind));
        free_image(&first);
        free_image(&second);
        weft_texture_free(a);
        weft_texture_free(b);
        weft_model_free(loaded);
        free(bytes);
        free(again);
    }
}

static void must_be_refused(const unsigned char *bytes, size_t size, size_t at)
{
    weft_model *model = UNTOUCHED;
    const weft_status status = weft_model_load(context, bytes, size, &model);
    if (status != WEFT_ERROR_FORMAT && status != WEFT_ERROR_UNSUPPORTED) print_error("at byte %zu\n", at);
    assert_true(status == WEFT_ERROR_FORMAT || status == WEFT_ERROR_UNSUPPORTED);
    assert_ptr_equal(model, UNTOUCHED);
}

/* Every length, and bits flipped all over. */
static void damaged(void **state)
{
    (void)state;
    for (uint32_t kind = 0; kind < 3; ++kind) {
        size_t size = 0;
        unsigned char *bytes = saved(models[kind], &size);
        for (size_t length = 0; length < size; length += length < 4096 ? 1 : scaled(13, 997)) {
            unsigned char *cut = malloc(length ? length : 1);
            memcpy(cut, bytes, length);
            must_be_refused(cut, length, length);
            free(cut);
        }
        must_be_refused(bytes, size - 1, size - 1);
        for (size_t bit = 0; bit < size * 8; bit += bit < 8192 ? 1 : scaled(1009, 50021)) {
            bytes[bit / 8] = (unsigned char)(bytes[bit / 8] ^ 1u << bit % 8);
            must_be_refused(bytes, size, bit / 8);
            bytes[bit / 8] = (unsigned char)(bytes[bit / 8] ^ 1u << bit % 8);
        }
        free(bytes);
    }
}

/* With Wang tiles the structure keeps the photo's size, and P + N is the photo but for the rounding of one sum. */
static void layers_are_the_photo(void **state)
{
    (void)state;
    weft_image photo = new_discs(48, 48, 3, 7);
    weft_image structure = part_of(models[0], part_named(models[0], "structure")),
               noise = part_of(models[0], part_named(models[0], "noise"));
    for (size_t i = 0; i < 48 * 48 * 3; ++i) {
        const float sum = values(&structure)[i] + values(&noise)[i];
        assert_true(fabsf(sum - values(&photo)[i]) <= 6e-8f * (1 + fabsf(values(&structure)[i])));
    }
    free_image(&photo);
    free_image(&structure);
    free_image(&noise);
}

/* Masks are shares of one. */
static void masks_sum_to_one(void **state)
{
    (void)state;
    for (uint32_t kind = 0; kind < BILAYER_KINDS; ++kind) {
        weft_image sum = {NULL, 0, 0, 0, 0, 0};
        weft_model_info info = WEFT_MODEL_INFO_INIT;
        assert_ok(weft_model_get(models[kind], &info));
        for (uint32_t i = 0; i < info.parts; ++i) {
            weft_part_info part = WEFT_PART_INFO_INIT;
            assert_ok(weft_model_part(models[kind], i, &part));
            if (strncmp(part.name, "mask ", 5) != 0) continue;
            assert_true(part.low >= 0 && part.high <= 1);
            weft_image mask = part_of(models[kind], i);
            if (!sum.data) sum = new_image(mask.width, mask.height, 1, WEFT_FORMAT_F32);
            for (size_t p = 0; p < (size_t)mask.width * mask.height; ++p) values(&sum)[p] += values(&mask)[p];
            free_image(&mask);
        }
        const int bordered = bilayer_options(kind).border > 0; /* fewer where no noise is */
        for (size_t p = 0; p < (size_t)sum.width * sum.height; ++p) {
            if (fabsf(values(&sum)[p] - 1) >= 1e-5f && !(bordered && values(&sum)[p] >= 0 && values(&sum)[p] < 1))
                fail_msg("%s: %g at %zu of %u x %u", bilayer_kind(kind), (double)values(&sum)[p], p, sum.width,
                         sum.height);
        }
        free_image(&sum);
    }
}

static void refused_analysis(void **state)
{
    (void)state;
    const char *function = "weft_analyze_bilayer";
    weft_image photo = new_discs(40, 36, 3, 1);
    weft_model *model;
    const weft_status argument = WEFT_ERROR_ARGUMENT;
    REFUSED_HANDLE(weft_analyze_bilayer(NULL, &photo, NULL, NULL, NULL, &model), model, argument, function, "context");
    REFUSED_HANDLE(weft_analyze_bilayer(context, NULL, NULL, NULL, NULL, &model), model, argument, function, "photo");
    REFUSED(weft_analyze_bilayer(context, &photo, NULL, NULL, NULL, NULL), function, "model");
    for (int i = 0; i < 26; ++i) {
        weft_bilayer_options options = WEFT_BILAYER_OPTIONS_INIT;
        const char *word = "";
        switch (i) {
        case 0: options.size = 3, word = "size"; break;
        case 1: options.noises = 7, word = "noises"; break;
        case 2: options.window = 1, word = "window"; break;
        case 3: options.window = 32, word = "window"; break;
        case 4: options.mask_window = 5, word = "mask_window"; break;
        case 5: options.support = 7, word = "support"; break;
        case 6: options.support = 37, word = "support"; break; /* the photo's shorter side is 36 */
        case 7: options.support = 257, word = "support"; break;
        case 8: options.masks = -1, word = "masks"; break;
        case 9: options.masks = 3, word = "masks"; break;
        case 10: options.structure = -1, word = "structure"; break;
        case 11: options.structure = 5, word = "structure"; break;
        case 12: options.colours = 1, word = "colours"; break;
        case 13: options.colours = 17, word = "colours"; break;
        case 14: options.border = 65, word = "border"; break;
        case 15: options.equalize = 2, word = "equalize"; break;
        case 16: options.depth = 5, word = "depth"; break;
        case 17: options.filter_width = 1, word = "filter_width"; break;
        case 18: options.filter_width = 65, word = "filter_width"; break;
        case 19: options.filter_iterations = 33, word = "filter_iterations"; break;
        case 20: options.filter_sigma = -1, word = "filter_sigma"; break;
        case 21: options.filter_sigma = NAN, word = "filter_sigma"; break;
        case 22: options.filter_sigma = INFINITY, word = "filter_sigma"; break;
        case 23: options.noises = UINT32_MAX, word = "noises"; break;
        case 24: options.size = 5000, word = "size"; break;
        default: options.window = UINT32_MAX, word = "window"; break;
        }
        REFUSED_HANDLE(weft_analyze_bilayer(context, &photo, &options, NULL, NULL, &model), model, argument, function,
                       word);
    }
    free_image(&photo);
}

static void refused_textures(void **state)
{
    (void)state;
    const char *function = "weft_texture_create";
    weft_texture *texture;
    for (int i = 0; i < 10; ++i) {
        weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
        const char *word = "";
        switch (i) {
        case 0: options.rotation = -1, word = "rotation"; break;
        case 1: options.rotation = 3, word = "rotation"; break;
        case 2: options.scale_min = 0.49f, word = "scale_min"; break;
        case 3: options.scale_min = 1.01f, word = "scale_min"; break;
        case 4: options.scale_min = NAN, word = "scale_min"; break;
        case 5: options.turbulence = 64.5f, word = "turbulence"; break;
        case 6: options.turbulence = NAN, word = "turbulence"; break;
        case 7: options.turbulence = -INFINITY, word = "turbulence"; break;
        case 8: options.noise = -1, word = "noise"; break;
        default: options.noise = 3, word = "noise"; break;
        }
        REFUSED_HANDLE(weft_texture_create(context, models[0], &options, &texture), texture, WEFT_ERROR_ARGUMENT,
                       function, word);
    }
    weft_texture_options later = WEFT_TEXTURE_OPTIONS_INIT; /* a later libweft's */
    later.zero = 1;
    REFUSED_HANDLE(weft_texture_create(context, models[0], &later, &texture), texture, WEFT_ERROR_UNSUPPORTED, function,
                   "zero");
}

/* What is of bi-layer models alone is refused for others, and so is what these do not have. */
static void other_methods(void **state)
{
    (void)state;
    weft_model *texton = new_texton(context, 16, 1, 4, WEFT_INTERPOLATION_LINEAR, 3),
               *picture = new_picture(context, 8, 8, 3, 1);
    weft_texture *texture;
    for (int i = 0; i < 8; ++i) {
        weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
        if (i % 4 == 0) options.rotation = WEFT_ROTATION_ALL;
        if (i % 4 == 1) options.scale_min = 0.7f;
        if (i % 4 == 2) options.turbulence = -1;
        if (i % 4 == 3) options.noise = WEFT_NOISE_TILE;
        REFUSED_HANDLE(weft_texture_create(context, i < 4 ? texton : picture, &options, &texture), texture,
                       WEFT_ERROR_ARGUMENT, "weft_texture_create", "one layer");
    }
    weft_model *mixed;
    size_t length = 0;
    weft_wavelet wavelet = WEFT_WAVELET_INIT;
    REFUSED_HANDLE(weft_model_mix(context, models[0], models[0], 0, 3, &mixed), mixed, WEFT_ERROR_UNSUPPORTED,
                   "weft_model_mix", "");
    assert_refused(weft_model_save_texton(models[0], NULL, 0, &length), WEFT_ERROR_UNSUPPORTED,
                   "weft_model_save_texton", "");
    assert_refused(weft_model_get_wavelet(models[0], &wavelet), WEFT_ERROR_UNSUPPORTED, "weft_model_get_wavelet", "");
    texture = new_texture(context, models[0], 0, 1, 0);
    const weft_surface_point on = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const weft_solid_point in = {{0, 0, 0}, 1, 0};
    float out[3];
    assert_refused(weft_texture_sample_surface(texture, 1, &on, out), WEFT_ERROR_UNSUPPORTED,
                   "weft_texture_sample_surface", "");
    assert_refused(weft_texture_sample_solid(texture, 1, &in, out), WEFT_ERROR_UNSUPPORTED, "weft_texture_sample_solid",
                   "");
    weft_texture_free(texture);
    weft_model_free(texton);
    weft_model_free(picture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(saved_and_loaded), cmocka_unit_test(damaged),          cmocka_unit_test(layers_are_the_photo),
        cmocka_unit_test(masks_sum_to_one), cmocka_unit_test(refused_analysis), cmocka_unit_test(refused_textures),
        cmocka_unit_test(other_methods),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
