/* Wrote the files of this folder: `generate_golden FOLDER models` the models, `generate_golden FOLDER checksums`
 * golden.txt.
 *
 * Models come from synthetic exemplars by analysis, whose last bits depend on the machine; they were written once and
 * are kept. The checksums follow from the models alone and are written anew only when a release changes pixels on
 * purpose. */
#include "bilayers.h"
#include "golden.h"
#include "stained.h"
#include <string.h>

static void write_model(weft_model *model, const char *folder, const char *name)
{
    char path[1024];
    size_t size = 0;
    void *bytes = saved(model, &size);
    snprintf(path, sizeof path, "%s/%s.weft", folder, name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
    free(bytes);
    weft_model_free(model);
}

static weft_model *analyzed(weft_context *context, Grain grain, uint32_t channels, uint32_t support,
                            weft_interpolation interpolation)
{
    weft_image photo = new_grain(grain, 64, 64, channels, 20170612 + support);
    weft_texton_options options = WEFT_TEXTON_OPTIONS_INIT;
    weft_model *model = NULL;
    options.support = support;
    options.interpolation = interpolation;
    assert_ok(weft_analyze_texton(context, &photo, &options, NULL, NULL, &model));
    free_image(&photo);
    return model;
}

static weft_model *layered(weft_context *context, uint32_t channels, weft_structure structure)
{
    weft_image photo = new_discs(32, 32, channels, 4);
    weft_bilayer_options options = WEFT_BILAYER_OPTIONS_INIT;
    weft_model *model = NULL;
    options.noises = 2;
    options.window = options.mask_window = 2;
    options.support = 8;
    options.colours = 2;
    options.structure = structure;
    assert_ok(weft_analyze_bilayer(context, &photo, &options, NULL, NULL, &model));
    free_image(&photo);
    return model;
}

static void write_models(const char *folder)
{
    weft_context *context = new_context("scalar", 1);
    write_model(analyzed(context, GRAIN_STREAKS, 3, 24, WEFT_INTERPOLATION_LINEAR), folder, "linear_rgb");
    write_model(analyzed(context, GRAIN_SOFT, 1, 16, WEFT_INTERPOLATION_NEAREST), folder, "nearest_grey");
    write_model(analyzed(context, GRAIN_BAND, 3, 13, WEFT_INTERPOLATION_CUBIC), folder, "cubic_rgb");
    write_model(analyzed(context, GRAIN_SOFT, 1, 20, WEFT_INTERPOLATION_QUINTIC), folder, "quintic_grey");
    write_model(analyzed(context, GRAIN_SOFT, 16, 8, WEFT_INTERPOLATION_LINEAR), folder, "linear_16");
    write_model(new_picture(context, 24, 18, 3, 1), folder, "picture_rgb");
    write_model(new_picture(context, 7, 9, 5, 2), folder, "picture_5");
    write_model(new_tile(context, 72, 64, 3, 3), folder, "tile_rgb");
    write_model(layered(context, 1, WEFT_STRUCTURE_WANG), folder, "bilayer_wang");
    write_model(layered(context, 3, WEFT_STRUCTURE_EXCHANGE), folder, "bilayer_exchange");
    weft_context_free(context);
}

static void write_checksums(const char *folder)
{
    char path[1024];
    weft_context *context = new_context("scalar", 1);
    snprintf(path, sizeof path, "%s/golden.txt", folder);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    for (size_t m = 0; m < GOLDEN_MODELS; ++m) {
        weft_model *model = golden_model(context, folder, golden_models[m]);
        for (size_t v = 0; v < GOLDEN_VIEWS; ++v)
            fprintf(file, "%s %zu %016llx\n", golden_models[m], v,
                    (unsigned long long)golden_checksum(context, model, &golden_views[v]));
        weft_model_free(model);
    }
    assert_int_equal(fclose(file), 0);
    weft_context_free(context);
}

static const char *folder_argument, *what_argument;

static void write_all(void **state)
{
    (void)state;
    if (strcmp(what_argument, "models") == 0)
        write_models(folder_argument);
    else if (strcmp(what_argument, "checksums") == 0)
        write_checksums(folder_argument);
    else
        fail();
}

int main(int argc, char **argv)
{
    if (argc != 3) return 2;
    folder_argument = argv[1];
    what_argument = argv[2];
    const struct CMUnitTest tests[] = {cmocka_unit_test(write_all)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
