/* What the bi-layer analysis makes of input that holds little, of any number of threads, and of calls to stop. */
#include "support.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static weft_context *context;

static int begin(void **state)
{
    (void)state;
    context = new_context("scalar", 0);
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_context_free(context);
    return 0;
}

static const weft_bilayer_options fresh = WEFT_BILAYER_OPTIONS_INIT;

static uint32_t count_masks(const weft_model *model)
{
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    uint32_t count = 0;
    assert_ok(weft_model_get(model, &info));
    for (uint32_t i = 0; i < info.parts; ++i) {
        weft_part_info part = WEFT_PART_INFO_INIT;
        assert_ok(weft_model_part(model, i, &part));
        count += strncmp(part.name, "mask ", 5) == 0;
    }
    return count;
}

/* One colour has one noise, which is nothing, whatever was asked for. */
static void one_colour(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 6; ++i) {
        weft_image photo = new_image(40, 36, 1 + i % 3, WEFT_FORMAT_F32);
        for (size_t j = 0; j < image_bytes(&photo) / sizeof(float); ++j) values(&photo)[j] = i == 5 ? 1e9f : 0.3f;
        weft_bilayer_options options = fresh;
        options.noises = i;
        options.equalize = i % 2;
        options.structure = i == 4 ? WEFT_STRUCTURE_NONE : WEFT_STRUCTURE_AUTO;
        weft_model *model = NULL;
        assert_ok(weft_analyze_bilayer(context, &photo, &options, NULL, NULL, &model));
        assert_int_equal(count_masks(model), 1);
        weft_texture *texture = new_texture(context, model, 0, 1, 0);
        weft_image image = rendered(texture, -7, 5, 0, 50, 40, photo.channels);
        for (size_t j = 0; j < image_bytes(&image) / sizeof(float); ++j)
            assert_true(values(&image)[j] == values(&photo)[0]);
        free_image(&image);
        weft_texture_free(texture);
        weft_model_free(model);
        free_image(&photo);
    }
}

/* No more noises than there are different spectra: two flat colours with a straight border have few. */
static void fewer_noises_than_asked_for(void **state)
{
    (void)state;
    weft_image photo = new_image(64, 64, 3, WEFT_FORMAT_F32);
    for (uint32_t i = 0; i < 64 * 64 * 3; ++i) values(&photo)[i] = i % (64 * 3) < 32 * 3 ? 0.2f : 0.7f;
    weft_bilayer_options options = fresh;
    options.noises = 6;
    options.window = options.mask_window = 2;
    weft_model *model = NULL;
    assert_ok(weft_analyze_bilayer(context, &photo, &options, NULL, NULL, &model));
    assert_true(count_masks(model) >= 2 && count_masks(model) <= 6);
    weft_model_free(model);
    free_image(&photo);
}

/* The smallest photo, with regions in which no window would fit; values far from 0..1; many channels. */
static void little_to_learn_from(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 8; ++i) {
        const uint32_t channels = i == 7 ? 16 : 1 + i % 4;
        weft_image photo = new_grain((Grain)(i % 4), 32, 32 + i, channels, i);
        for (size_t j = 0; j < image_bytes(&photo) / sizeof(float); ++j) {
            if (i == 5) values(&photo)[j] = 1e15f * (values(&photo)[j] - 0.5f);
            if (i == 6) values(&photo)[j] *= 1e-9f;
        }
        weft_bilayer_options options = fresh;
        options.noises = 6 - i % 3;
        options.mask_window = 2u << i % 4;
        options.window = 16u >> i % 4;
        options.equalize = i % 2;
        options.border = i == 3 ? 64 : 0; /* nothing is left outside of the band */
        options.depth = 1 + i % 4;
        options.filter_width = i == 2 ? 64 : 0;
        weft_model *model = NULL;
        assert_ok(weft_analyze_bilayer(context, &photo, &options, NULL, NULL, &model));
        weft_model_info info = WEFT_MODEL_INFO_INIT;
        assert_ok(weft_model_get(model, &info));
        assert_int_equal(info.method, WEFT_METHOD_BILAYER);
        assert_int_equal(info.channels, channels);
        weft_model_free(model);
        free_image(&photo);
    }
}

static void what_is_refused(void **state)
{
    (void)state;
    static const char function[] = "weft_analyze_bilayer";
    weft_image photo = new_grain(GRAIN_WHITE, 40, 36, 1, 1);
    weft_model *model = NULL;
#define REFUSED(field, value, word)                                                                                    \
    do {                                                                                                               \
        weft_bilayer_options options = fresh;                                                                          \
        options.field = value;                                                                                         \
        assert_refused(weft_analyze_bilayer(context, &photo, &options, NULL, NULL, &model), WEFT_ERROR_ARGUMENT,       \
                       function, word);                                                                                \
        assert_null(model);                                                                                            \
    } while (0)
    REFUSED(noises, 7, "7");
    REFUSED(window, 3, "window is 3");
    REFUSED(window, 32, "32");
    REFUSED(mask_window, 1, "mask_window is 1");
    REFUSED(support, 7, "7");
    REFUSED(support, 37, "36");
    REFUSED(support, 257, "257");
    REFUSED(masks, 3, "masks");
    REFUSED(masks, -1, "masks");
    REFUSED(structure, 5, "structure");
    REFUSED(colours, 1, "colours is 1");
    REFUSED(colours, 17, "17");
    REFUSED(border, 65, "65");
    REFUSED(equalize, 2, "equalize");
    REFUSED(depth, 5, "depth");
    REFUSED(filter_width, 1, "filter_width");
    REFUSED(filter_width, 65, "65");
    REFUSED(filter_iterations, 33, "33");
    REFUSED(filter_sigma, -1, "filter_sigma");
    REFUSED(filter_sigma, (float)NAN, "filter_sigma");
    REFUSED(filter_sigma, (float)INFINITY, "filter_sigma");
    photo.height = 31;
    assert_refused(weft_analyze_bilayer(context, &photo, NULL, NULL, NULL, &model), WEFT_ERROR_ARGUMENT, function,
                   "40 x 31");
    free_image(&photo);
}

static void threads_change_nothing(void **state)
{
    (void)state;
    weft_image photo = new_grain(GRAIN_SOFT, 80, 72, 3, 3);
    weft_bilayer_options options = fresh;
    options.noises = 0;
    options.support = 16;
    options.equalize = 1;
    void *expected = NULL;
    size_t size = 0;
    for (uint32_t threads = 1; threads <= 4; ++threads) {
        weft_context *own = new_context("scalar", threads);
        weft_model *model = NULL;
        assert_ok(weft_analyze_bilayer(own, &photo, &options, NULL, NULL, &model));
        size_t bytes;
        void *found = saved(model, &bytes);
        if (expected) {
            assert_int_equal(bytes, size);
            assert_memory_equal(found, expected, size);
            free(found);
        } else {
            expected = found;
            size = bytes;
        }
        weft_model_free(model);
        weft_context_free(own);
    }
    free(expected);
    free_image(&photo);
}

typedef struct Steps {
    uint32_t count, stop;
    float last;
} Steps;

static int step(void *user, float done) WEFT_NOEXCEPT
{
    Steps *steps = user;
    assert_true(done >= steps->last && done <= 1);
    steps->last = done;
    return ++steps->count == steps->stop;
}

/* Every report may be the last: nothing is left behind, and a run that is let through is the same as ever. */
static void stopped_anywhere(void **state)
{
    (void)state;
    weft_image photo = new_grain(GRAIN_SOFT, 36, 34, 1, 4);
    weft_bilayer_options options = fresh;
    options.support = 8;
    options.border = 2;
    options.noises = 2;
    Steps all = {0, 0, 0};
    weft_model *model = NULL;
    assert_ok(weft_analyze_bilayer(context, &photo, &options, step, &all, &model));
    assert_true(all.last == 1);
    weft_model_free(model);
    for (uint32_t stop = 1; stop <= all.count; stop += 1 + all.count / scaled(40, 10)) {
        Steps some = {0, stop, 0};
        model = NULL;
        assert_int_equal(weft_analyze_bilayer(context, &photo, &options, step, &some, &model), WEFT_ERROR_CANCELLED);
        assert_null(model);
        assert_int_equal(some.count, stop);
    }
    free_image(&photo);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_colour),
        cmocka_unit_test(fewer_noises_than_asked_for),
        cmocka_unit_test(little_to_learn_from),
        cmocka_unit_test(what_is_refused),
        cmocka_unit_test(threads_change_nothing),
        cmocka_unit_test(stopped_anywhere),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
