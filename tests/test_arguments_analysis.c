/* Analysis, measures and comparison with every wrong argument: the status, a sentence with function and argument,
 * untouched outputs. */
#include "refusals.h"
#include <math.h>
#include <string.h>

static weft_context *context;
static weft_image photo; /* 32 x 24, RGB, F32 */

static int begin(void **state)
{
    (void)state;
    context = new_context("scalar", 1);
    photo = new_grain(GRAIN_SOFT, 32, 24, 3, 3);
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_context_free(context);
    free_image(&photo);
    return 0;
}

static void input_images(void **state)
{
    (void)state;
    Bad_view bad[MOST_BAD_VIEWS];
    const uint32_t count = bad_views(&photo, bad);
    weft_image out = new_image(8, 8, 3, WEFT_FORMAT_F32);
    uint64_t counts[3 * 4];
    weft_comparison comparison = WEFT_COMPARISON_INIT;
    const weft_comparison before = comparison;
    weft_description description = WEFT_DESCRIPTION_INIT;
    const weft_description no_description = description;
    weft_model *model;
    fill_bytes(&out, 0xa5);
    memset(counts, 0xa5, sizeof counts);
    for (uint32_t i = 0; i < count; ++i) {
        const weft_image *image = &bad[i].image;
        const char *word = bad[i].word;
        REFUSED_HANDLE(weft_analyze_texton(context, image, NULL, NULL, NULL, &model), model, WEFT_ERROR_ARGUMENT,
                       "weft_analyze_texton", word);
        REFUSED_HANDLE(weft_analyze_wavelet(context, image, NULL, NULL, NULL, &model), model, WEFT_ERROR_ARGUMENT,
                       "weft_analyze_wavelet", word);
        REFUSED_HANDLE(weft_analyze_picture(context, image, &model), model, WEFT_ERROR_ARGUMENT, "weft_analyze_picture",
                       word);
        REFUSED(weft_describe(context, image, NULL, NULL, &description), "weft_describe", word);
        REFUSED(weft_power_spectrum(context, image, &out), "weft_power_spectrum", word);
        REFUSED(weft_autocovariance(context, image, &out), "weft_autocovariance", word);
        REFUSED(weft_histogram(context, image, 0, 1, 4, counts), "weft_histogram", word);
        REFUSED(weft_compare(context, image, &photo, NULL, NULL, NULL, &comparison), "weft_compare", word);
        REFUSED(weft_compare(context, &photo, image, NULL, NULL, NULL, &comparison), "weft_compare", word);
    }
    assert_true(all_bytes(&out, 0xa5));
    for (size_t i = 0; i < sizeof counts; ++i) assert_int_equal(((unsigned char *)counts)[i], 0xa5);
    assert_memory_equal(&comparison, &before, sizeof before);
    assert_memory_equal(&description, &no_description, sizeof no_description);
    free_image(&out);
}

static void pixels_that_are_not_finite(void **state)
{
    (void)state;
    const float not_finite[] = {NAN, INFINITY, -INFINITY};
    weft_image out = new_image(8, 8, 3, WEFT_FORMAT_F32);
    uint64_t counts[3 * 4];
    weft_comparison comparison = WEFT_COMPARISON_INIT;
    weft_description description = WEFT_DESCRIPTION_INIT;
    weft_model *model;
    fill_bytes(&out, 0xa5);
    memset(counts, 0xa5, sizeof counts);
    for (uint32_t i = 0; i < 9; ++i) {
        weft_image image = new_grain(GRAIN_SOFT, 32, 24, 3, 3);
        const size_t places[] = {0, 32 * 24 * 3 / 2, 32 * 24 * 3 - 1};
        values(&image)[places[i / 3]] = not_finite[i % 3];
        REFUSED_HANDLE(weft_analyze_texton(context, &image, NULL, NULL, NULL, &model), model, WEFT_ERROR_ARGUMENT,
                       "weft_analyze_texton", "photo");
        REFUSED_HANDLE(weft_analyze_wavelet(context, &image, NULL, NULL, NULL, &model), model, WEFT_ERROR_ARGUMENT,
                       "weft_analyze_wavelet", "photo");
        REFUSED_HANDLE(weft_analyze_picture(context, &image, &model), model, WEFT_ERROR_ARGUMENT,
                       "weft_analyze_picture", "picture");
        REFUSED(weft_describe(context, &image, NULL, NULL, &description), "weft_describe", "photo");
        REFUSED(weft_power_spectrum(context, &image, &out), "weft_power_spectrum", "image");
        REFUSED(weft_autocovariance(context, &image, &out), "weft_autocovariance", "image");
        REFUSED(weft_histogram(context, &image, 0, 1, 4, counts), "weft_histogram", "image");
        REFUSED(weft_compare(context, &image, &photo, NULL, NULL, NULL, &comparison), "weft_compare", "exemplar");
        REFUSED(weft_compare(context, &photo, &image, NULL, NULL, NULL, &comparison), "weft_compare", "output");
        free_image(&image);
    }
    assert_true(all_bytes(&out, 0xa5));
    for (size_t i = 0; i < sizeof counts; ++i) assert_int_equal(((unsigned char *)counts)[i], 0xa5);
    free_image(&out);
}

static void analysis(void **state)
{
    (void)state;
    weft_model *model;
    const char *function = "weft_analyze_texton";
    const weft_status argument = WEFT_ERROR_ARGUMENT;
    REFUSED_HANDLE(weft_analyze_texton(NULL, &photo, NULL, NULL, NULL, &model), model, argument, function, "context");
    REFUSED_HANDLE(weft_analyze_texton(context, NULL, NULL, NULL, NULL, &model), model, argument, function, "photo");
    REFUSED(weft_analyze_texton(context, &photo, NULL, NULL, NULL, NULL), function, "model");
    REFUSED_HANDLE(weft_analyze_picture(NULL, &photo, &model), model, argument, "weft_analyze_picture", "context");
    REFUSED_HANDLE(weft_analyze_picture(context, NULL, &model), model, argument, "weft_analyze_picture", "picture");
    REFUSED(weft_analyze_picture(context, &photo, NULL), "weft_analyze_picture", "model");

    const weft_texton_options fresh = WEFT_TEXTON_OPTIONS_INIT;
    for (int i = 0; i < 11; ++i) {
        weft_texton_options options = fresh;
        const char *word = "";
        switch (i) {
        case 0: options.size = 0, word = "size"; break;
        case 1: options.size = 3, word = "size"; break;
        case 2: options.support = 25, word = "support"; break; /* the photo's shorter side is 24 */
        case 3: options.support = UINT32_MAX, word = "support"; break;
        case 4: options.iterations = UINT32_MAX, word = "iterations"; break;
        case 5: options.interpolation = -1, word = "interpolation"; break;
        case 6: options.interpolation = 3, word = "interpolation"; break;
        case 7: options.interpolation = 5, word = "interpolation"; break;
        case 8: options.interpolation = 7, word = "interpolation"; break;
        case 9: options.projection = -1, word = "projection"; break;
        default: options.projection = 3, word = "projection"; break;
        }
        REFUSED_HANDLE(weft_analyze_texton(context, &photo, &options, NULL, NULL, &model), model, argument, function,
                       word);
    }

    weft_texton_options later = fresh; /* a field without meaning so far: a later libweft's */
    later.zero = 1;
    REFUSED_HANDLE(weft_analyze_texton(context, &photo, &later, NULL, NULL, &model), model, WEFT_ERROR_UNSUPPORTED,
                   function, "zero");

    weft_image narrow = new_grain(GRAIN_SOFT, 7, 16, 1, 4), flat = new_grain(GRAIN_SOFT, 16, 7, 1, 4);
    REFUSED_HANDLE(weft_analyze_texton(context, &narrow, NULL, NULL, NULL, &model), model, argument, function,
                   "7 x 16");
    REFUSED_HANDLE(weft_analyze_texton(context, &flat, NULL, NULL, NULL, &model), model, argument, function, "16 x 7");
    free_image(&narrow);
    free_image(&flat);
    weft_image wide = new_image(16385, 8, 1, WEFT_FORMAT_U8), tall = new_image(8, 16385, 1, WEFT_FORMAT_U8);
    REFUSED_HANDLE(weft_analyze_picture(context, &wide, &model), model, argument, "weft_analyze_picture", "16385");
    REFUSED_HANDLE(weft_analyze_picture(context, &tall, &model), model, argument, "weft_analyze_picture", "16385");
    wide.width = tall.height = 8193;
    REFUSED_HANDLE(weft_analyze_texton(context, &wide, NULL, NULL, NULL, &model), model, argument, function, "8193");
    REFUSED_HANDLE(weft_analyze_texton(context, &tall, NULL, NULL, NULL, &model), model, argument, function, "8193");
    free_image(&wide);
    free_image(&tall);
}

static void measures(void **state)
{
    (void)state;
    typedef weft_status (*Measure)(weft_context *, const weft_image *, const weft_image *);
    const Measure measure[] = {weft_power_spectrum, weft_autocovariance};
    const char *const function[] = {"weft_power_spectrum", "weft_autocovariance"}, *const result[] = {"spectrum",
                                                                                                      "autocovariance"};
    weft_image out = new_image(32, 24, 3, WEFT_FORMAT_F32);
    fill_bytes(&out, 0xa5);
    for (int m = 0; m < 2; ++m) {
        REFUSED(measure[m](NULL, &photo, &out), function[m], "context");
        REFUSED(measure[m](context, NULL, &out), function[m], "image");
        REFUSED(measure[m](context, &photo, NULL), function[m], result[m]);
        for (int i = 0; i < 6; ++i) {
            weft_image wrong = out;
            const char *word = "";
            switch (i) {
            case 0: wrong.width = 33, word = "width"; break;
            case 1: wrong.height = 25, word = "height"; break;
            case 2: wrong.channels = 1, word = "channels"; break;
            case 3: wrong.format = WEFT_FORMAT_U8, word = "format"; break;
            case 4: wrong.data = NULL, word = "data"; break;
            default: wrong.stride = 4, word = "stride"; break;
            }
            REFUSED(measure[m](context, &photo, &wrong), function[m], word);
        }
    }
    assert_true(all_bytes(&out, 0xa5));
    free_image(&out);

    uint64_t counts[12];
    memset(counts, 0xa5, sizeof counts);
    REFUSED(weft_histogram(NULL, &photo, 0, 1, 4, counts), "weft_histogram", "context");
    REFUSED(weft_histogram(context, NULL, 0, 1, 4, counts), "weft_histogram", "image");
    REFUSED(weft_histogram(context, &photo, 0, 1, 4, NULL), "weft_histogram", "counts");
    REFUSED(weft_histogram(context, &photo, 0, 1, 0, counts), "weft_histogram", "bins");
    REFUSED(weft_histogram(context, &photo, 0, 1, 65537, counts), "weft_histogram", "bins");
    const float bounds[][2] = {{1, 0}, {0, 0}, {NAN, 1}, {0, NAN}, {-INFINITY, 1}, {0, INFINITY}};
    for (size_t i = 0; i < sizeof bounds / sizeof *bounds; ++i)
        REFUSED(weft_histogram(context, &photo, bounds[i][0], bounds[i][1], 4, counts), "weft_histogram", "low");
    for (size_t i = 0; i < sizeof counts; ++i) assert_int_equal(((unsigned char *)counts)[i], 0xa5);
}

static void comparing(void **state)
{
    (void)state;
    const char *function = "weft_compare";
    weft_comparison comparison;
    memset(&comparison, 0xa5, sizeof comparison);
    comparison.size = sizeof comparison;
    const weft_comparison before = comparison;
    REFUSED(weft_compare(NULL, &photo, &photo, NULL, NULL, NULL, &comparison), function, "context");
    REFUSED(weft_compare(context, NULL, &photo, NULL, NULL, NULL, &comparison), function, "exemplar");
    REFUSED(weft_compare(context, &photo, NULL, NULL, NULL, NULL, &comparison), function, "output");
    REFUSED(weft_compare(context, &photo, &photo, NULL, NULL, NULL, NULL), function, "comparison");
    weft_image grey = new_grain(GRAIN_SOFT, 32, 32, 1, 9), small = new_grain(GRAIN_SOFT, 15, 16, 3, 9),
               low = new_grain(GRAIN_SOFT, 16, 15, 3, 9);
    REFUSED(weft_compare(context, &photo, &grey, NULL, NULL, NULL, &comparison), function, "channels");
    REFUSED(weft_compare(context, &photo, &small, NULL, NULL, NULL, &comparison), function, "output");
    REFUSED(weft_compare(context, &small, &photo, NULL, NULL, NULL, &comparison), function, "exemplar");
    REFUSED(weft_compare(context, &photo, &low, NULL, NULL, NULL, &comparison), function, "output");
    REFUSED(weft_compare(context, &low, &photo, NULL, NULL, NULL, &comparison), function, "exemplar");
    free_image(&grey);
    free_image(&small);
    free_image(&low);
    weft_compare_options options = WEFT_COMPARE_OPTIONS_INIT;
    options.size = 1;
    REFUSED(weft_compare(context, &photo, &photo, &options, NULL, NULL, &comparison), function, "size");
    options.size = sizeof options;
    options.zero = 7;
    assert_refused(weft_compare(context, &photo, &photo, &options, NULL, NULL, &comparison), WEFT_ERROR_UNSUPPORTED,
                   function, "zero");
    assert_memory_equal(&comparison, &before, sizeof before);
    comparison.size = 0;
    REFUSED(weft_compare(context, &photo, &photo, NULL, NULL, NULL, &comparison), function, "size");
}

static void describing(void **state)
{
    (void)state;
    const char *function = "weft_describe";
    weft_description description;
    memset(&description, 0xa5, sizeof description);
    description.size = sizeof description;
    const weft_description before = description;
    weft_image narrow = new_grain(GRAIN_SOFT, 15, 16, 3, 9), low = new_grain(GRAIN_SOFT, 16, 15, 3, 9);
    REFUSED(weft_describe(NULL, &photo, NULL, NULL, &description), function, "context");
    REFUSED(weft_describe(context, NULL, NULL, NULL, &description), function, "photo");
    REFUSED(weft_describe(context, &photo, NULL, NULL, NULL), function, "description");
    REFUSED(weft_describe(context, &narrow, NULL, NULL, &description), function, "15 x 16");
    REFUSED(weft_describe(context, &low, NULL, NULL, &description), function, "16 x 15");
    assert_memory_equal(&description, &before, sizeof before);
    const uint32_t wrong_sizes[] = {0, 3, 4097, UINT32_MAX};
    for (int i = 0; i < 4; ++i) {
        description.size = wrong_sizes[i];
        REFUSED(weft_describe(context, &photo, NULL, NULL, &description), function, "size");
    }
    free_image(&narrow);
    free_image(&low);

    /* Of an older header: what it does not know stays as it was. */
    description = before;
    description.size = offsetof(weft_description, histogram);
    assert_ok(weft_describe(context, &photo, NULL, NULL, &description));
    const size_t known = offsetof(weft_description, histogram);
    assert_memory_equal((char *)&description + known, (const char *)&before + known, sizeof before - known);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(input_images), cmocka_unit_test(analysis),  cmocka_unit_test(pixels_that_are_not_finite),
        cmocka_unit_test(measures),     cmocka_unit_test(comparing), cmocka_unit_test(describing),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
