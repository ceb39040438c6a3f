/* Parameters of wavelet noise: in, out, through files, and every wrong one. */
#include "refusals.h"
#include "wavelets.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static weft_context *context;

static int begin(void **state)
{
    (void)state;
    context = new_context("scalar", 1);
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_context_free(context);
    return 0;
}

static void assert_parameters(const weft_model *model, const weft_wavelet *expected)
{
    weft_wavelet got = WEFT_WAVELET_INIT;
    assert_ok(weft_model_get_wavelet(model, &got));
    assert_memory_equal(&got, expected, sizeof got);
}

static void parameters_come_back(void **state)
{
    (void)state;
    const uint32_t sizes[][3] = {{1, 1, 0}, {1, 16, 2}, {3, 8, 10}, {2, 5, 0}, {4, 7, 32}, {16, 16, 32}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        const weft_wavelet wavelet = random_wavelet(sizes[i][0], sizes[i][1], sizes[i][2], 10 + i);
        weft_model *model = new_wavelet(context, &wavelet), *again = NULL;
        assert_parameters(model, &wavelet);
        weft_model_info info = WEFT_MODEL_INFO_INIT;
        assert_ok(weft_model_get(model, &info));
        assert_int_equal(info.method, WEFT_METHOD_WAVELET);
        assert_int_equal(info.channels, wavelet.channels);
        assert_int_equal(info.interpolation, 0);

        size_t size = 0, size_again = 0;
        void *bytes = saved(model, &size);
        assert_ok(weft_model_load(context, bytes, size, &again));
        assert_parameters(again, &wavelet);
        void *bytes_again = saved(again, &size_again);
        assert_int_equal(size, size_again);
        assert_memory_equal(bytes, bytes_again, size);
        free(bytes_again);
        free(bytes);
        weft_model_free(again);
        weft_model_free(model);
    }
}

/* What is beyond bands, knots and channels is not looked at, and is 0 in the answer. */
static void unused_parameters_do_not_matter(void **state)
{
    (void)state;
    const weft_wavelet wavelet = random_wavelet(2, 3, 4, 1);
    weft_wavelet dirty = wavelet;
    dirty.mean[2] = dirty.axes[2][0] = dirty.axes[0][2] = dirty.weight[3][0] = dirty.weight[0][2] = NAN;
    dirty.knot_x[4][0] = dirty.knot_y[0][2] = dirty.knot_slope[31][15] = -INFINITY;
    weft_model *model = new_wavelet(context, &dirty);
    assert_parameters(model, &wavelet);
    weft_model_free(model);
}

/* As weft_analyze_wavelet makes it of a photo: as many bands as it holds, ten knots. */
static void a_colour_photo_takes_less_than_two_kilobytes(void **state)
{
    (void)state;
    weft_image photo = new_grain(GRAIN_SOFT, 512, 512, 3, 1);
    weft_model *model = NULL;
    weft_wavelet wavelet = WEFT_WAVELET_INIT;
    size_t size = 0;
    assert_ok(weft_analyze_wavelet(context, &photo, NULL, NULL, NULL, &model));
    assert_ok(weft_model_get_wavelet(model, &wavelet));
    assert_int_equal(wavelet.channels, 3);
    assert_int_equal(wavelet.knots, 10);
    assert_in_range(wavelet.bands, 6, 9);
    free(saved(model, &size));
    assert_in_range(size, 100, 2000);
    weft_model_free(model);
    free_image(&photo);
}

/* One wrong parameter of a good model of 3 channels, 4 bands and 5 knots; the sentence must have the word. */
static const char *spoil(weft_wavelet *wavelet, int i)
{
    switch (i) {
    case 0: wavelet->channels = 0; return "channels";
    case 1: wavelet->channels = 17; return "channels";
    case 2: wavelet->channels = UINT32_MAX; return "channels";
    case 3: wavelet->bands = 0; return "bands";
    case 4: wavelet->bands = 17; return "bands";
    case 5: wavelet->bands = UINT32_MAX; return "bands";
    case 6: wavelet->knots = 1; return "knots";
    case 7: wavelet->knots = 33; return "knots";
    case 8: wavelet->knots = UINT32_MAX; return "knots";
    case 9: wavelet->mean[2] = NAN; return "mean";
    case 10: wavelet->mean[0] = INFINITY; return "mean";
    case 11: wavelet->axes[1][1] = NAN; return "axes";
    case 12: wavelet->axes[0][0] += 0.01f; return "axes";
    case 13: memcpy(wavelet->axes[1], wavelet->axes[0], sizeof wavelet->axes[0]); return "axes";
    case 14: wavelet->weight[3][1] = -0.01f; return "weight[3][1]";
    case 15: wavelet->weight[0][2] = NAN; return "weight";
    case 16: wavelet->weight[1][0] = INFINITY; return "weight";
    case 17: wavelet->knot_x[2][1] = wavelet->knot_x[1][1]; return "knot_x[2][1]";
    case 18: wavelet->knot_x[4][0] = -1; return "knot_x[4][0]";
    case 19: wavelet->knot_x[0][0] = NAN; return "knot_x";
    case 20: wavelet->knot_y[3][2] = -1; return "knot_y[3][2]";
    case 21: wavelet->knot_y[1][0] = -INFINITY; return "knot_y";
    case 22: wavelet->knot_slope[0][0] = -1; return "knot_slope[0][0]";
    case 23: wavelet->knot_slope[4][2] = NAN; return "knot_slope";
    case 24: wavelet->size = 0; return "size";
    case 25: wavelet->size = 16385; return "size";
    default: return NULL;
    }
}

static void wrong_parameters(void **state)
{
    (void)state;
    const char *function = "weft_model_from_wavelet", *word;
    const weft_wavelet good = random_wavelet(3, 4, 5, 3);
    weft_model *model = new_wavelet(context, &good);
    weft_model_free(model);
    weft_wavelet wavelet = good;
    for (int i = 0; (word = spoil(&wavelet, i)) != NULL; ++i, wavelet = good)
        REFUSED_HANDLE(weft_model_from_wavelet(context, &wavelet, &model), model, WEFT_ERROR_ARGUMENT, function, word);
    REFUSED_HANDLE(weft_model_from_wavelet(NULL, &good, &model), model, WEFT_ERROR_ARGUMENT, function, "context");
    REFUSED_HANDLE(weft_model_from_wavelet(context, NULL, &model), model, WEFT_ERROR_ARGUMENT, function, "wavelet");
    REFUSED(weft_model_from_wavelet(context, &good, NULL), function, "model");
}

static void wrong_questions(void **state)
{
    (void)state;
    const char *function = "weft_model_get_wavelet";
    weft_wavelet out = random_wavelet(2, 2, 2, 1);
    const weft_wavelet before = out;
    weft_model *picture = new_picture(context, 8, 8, 1, 1), *wavelet = new_wavelet(context, &out);
    REFUSED(weft_model_get_wavelet(NULL, &out), function, "model");
    REFUSED(weft_model_get_wavelet(wavelet, NULL), function, "wavelet");
    assert_refused(weft_model_get_wavelet(picture, &out), WEFT_ERROR_UNSUPPORTED, function, "wavelet");
    assert_memory_equal(&out, &before, sizeof out);
    out.size = 3;
    REFUSED(weft_model_get_wavelet(wavelet, &out), function, "size");
    out.size = before.size;
    assert_memory_equal(&out, &before, sizeof out);
    weft_model_free(wavelet);
    weft_model_free(picture);
}

static void wrong_analyses(void **state)
{
    (void)state;
    const char *function = "weft_analyze_wavelet";
    const weft_wavelet_options fresh = WEFT_WAVELET_OPTIONS_INIT;
    weft_image photo = new_grain(GRAIN_SOFT, 32, 24, 3, 1);
    weft_model *model;
    Bad_view bad[MOST_BAD_VIEWS];
    const uint32_t count = bad_views(&photo, bad);
    for (uint32_t i = 0; i < count; ++i)
        REFUSED_HANDLE(weft_analyze_wavelet(context, &bad[i].image, NULL, NULL, NULL, &model), model,
                       WEFT_ERROR_ARGUMENT, function, bad[i].word);
    for (int i = 0; i < 5; ++i) {
        weft_wavelet_options options = fresh;
        const char *word = "";
        switch (i) {
        case 0: options.size = 3, word = "size"; break;
        case 1: options.bands = 17, word = "bands"; break;
        case 2: options.tone_knots = 1, word = "knots"; break;
        case 3: options.tone_knots = 33, word = "knots"; break;
        default: options.gaussian = 2, word = "gaussian"; break;
        }
        REFUSED_HANDLE(weft_analyze_wavelet(context, &photo, &options, NULL, NULL, &model), model, WEFT_ERROR_ARGUMENT,
                       function, word);
    }
    weft_image small = photo;
    small.height = 7;
    REFUSED_HANDLE(weft_analyze_wavelet(context, &small, NULL, NULL, NULL, &model), model, WEFT_ERROR_ARGUMENT,
                   function, "7");
    REFUSED_HANDLE(weft_analyze_wavelet(NULL, &photo, NULL, NULL, NULL, &model), model, WEFT_ERROR_ARGUMENT, function,
                   "context");
    REFUSED(weft_analyze_wavelet(context, &photo, NULL, NULL, NULL, NULL), function, "model");
    values(&photo)[100] = NAN;
    REFUSED_HANDLE(weft_analyze_wavelet(context, &photo, NULL, NULL, NULL, &model), model, WEFT_ERROR_ARGUMENT,
                   function, "photo");
    free_image(&photo);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parameters_come_back),
        cmocka_unit_test(unused_parameters_do_not_matter),
        cmocka_unit_test(a_colour_photo_takes_less_than_two_kilobytes),
        cmocka_unit_test(wrong_parameters),
        cmocka_unit_test(wrong_questions),
        cmocka_unit_test(wrong_analyses),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
