/* The `.texton` text: what is read, what is written, every truncation, every wrong word. */
#include "support.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static weft_context *context;
static char elsewhere;
#define UNTOUCHED ((void *)&elsewhere)

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

/* 3 x 2 coefficients in a frame of zeros, as the authors write them: bottom row first. */
static const char framed[] = "TEXTON\n1\n1\n0.5 0.25 0.125\n5 4\n"
                             "0 0 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n"
                             "0 0 0\n4 40 0.4\n5 50 0.5\n6 60 0.6\n0 0 0\n"
                             "0 0 0\n1 10 0.1\n2 20 0.2\n3e0 3.0e+1 -0.3\n0 0 0\n"
                             "0 0 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n"
                             "Original image: none\n";

static weft_model *read_text(const char *text, size_t size)
{
    weft_model *model = NULL;
    assert_ok(weft_model_load_texton(context, text, size, &model));
    return model;
}

static void what_is_read(void **state)
{
    (void)state;
    weft_model *model = read_text(framed, sizeof framed - 1);
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    assert_ok(weft_model_get(model, &info));
    assert_int_equal(info.method, WEFT_METHOD_TEXTON);
    assert_int_equal(info.channels, 3);
    assert_int_equal(info.width, 3);
    assert_int_equal(info.height, 2);
    assert_int_equal(info.interpolation, WEFT_INTERPOLATION_LINEAR);
    assert_true(info.model_error == -1);
    assert_true(info.mean[0] == 0.5f && info.mean[1] == 0.25f && info.mean[2] == 0.125f);
    weft_image part = part_of(model, 0);
    static const float expected[2][3][3] = {{{1, 10, 0.1f}, {2, 20, 0.2f}, {3, 30, -0.3f}},
                                            {{4, 40, 0.4f}, {5, 50, 0.5f}, {6, 60, 0.6f}}};
    assert_memory_equal(part.data, expected, sizeof expected); /* the top row is the last of the text */
    free_image(&part);
    weft_model_free(model);
}

static void every_order_of_interpolation(void **state)
{
    (void)state;
    static const weft_interpolation expected[] = {WEFT_INTERPOLATION_NEAREST,
                                                  WEFT_INTERPOLATION_LINEAR,
                                                  0,
                                                  WEFT_INTERPOLATION_CUBIC,
                                                  0,
                                                  WEFT_INTERPOLATION_QUINTIC,
                                                  0,
                                                  0,
                                                  0,
                                                  0};
    for (char order = '0'; order <= '9'; ++order) {
        char text[sizeof framed];
        weft_model *model = UNTOUCHED;
        weft_model_info info = WEFT_MODEL_INFO_INIT;
        memcpy(text, framed, sizeof text);
        text[9] = order;
        if (!expected[order - '0']) {
            assert_refused(weft_model_load_texton(context, text, sizeof text - 1, &model), WEFT_ERROR_FORMAT,
                           "weft_model_load_texton", "interpolation");
            assert_ptr_equal(model, UNTOUCHED);
            continue;
        }
        model = read_text(text, sizeof text - 1);
        assert_ok(weft_model_get(model, &info));
        assert_int_equal(info.interpolation, expected[order - '0']);
        weft_model_free(model);
    }
}

/* Text -> model -> text -> model: the same floats, and from then on the same text. Also from a model that was analysed.
 */
static void round_trip(weft_model *model, uint32_t channels)
{
    size_t size = 0, again_size = 0, measured = 0;
    assert_ok(weft_model_save_texton(model, NULL, 0, &size));
    char *text = malloc(size), *again = malloc(size);
    assert_ok(weft_model_save_texton(model, text, size, &measured));
    assert_int_equal(measured, size);
    assert_null(memchr(text, 0, size));
    assert_memory_equal(text, "TEXTON\n1\n", 9);

    weft_model *copy = read_text(text, size);
    weft_image part = part_of(model, 0), copied = part_of(copy, 0);
    weft_model_info info = WEFT_MODEL_INFO_INIT, copied_info = WEFT_MODEL_INFO_INIT;
    assert_ok(weft_model_get(model, &info));
    assert_ok(weft_model_get(copy, &copied_info));
    assert_int_equal(copied_info.channels, 3);
    assert_int_equal(info.interpolation, copied_info.interpolation);
    assert_int_equal(part.width, copied.width);
    assert_int_equal(part.height, copied.height);
    for (uint32_t c = 0; c < 3; ++c) {
        const uint32_t from = channels == 3 ? c : 0;
        assert_true(info.mean[from] == copied_info.mean[c]);
        for (uint32_t i = 0; i < part.width * part.height; ++i)
            assert_true(values(&part)[i * channels + from] == values(&copied)[i * 3 + c]);
    }
    assert_ok(weft_model_save_texton(copy, again, size, &again_size));
    assert_int_equal(again_size, size);
    assert_memory_equal(text, again, size);
    free_image(&part);
    free_image(&copied);
    weft_model_free(copy);
    free(text);
    free(again);
}

static void round_trips(void **state)
{
    (void)state;
    weft_model *model = read_text(framed, sizeof framed - 1);
    round_trip(model, 3);
    weft_model_free(model);
    const weft_interpolation interpolations[] = {WEFT_INTERPOLATION_LINEAR, WEFT_INTERPOLATION_NEAREST,
                                                 WEFT_INTERPOLATION_CUBIC, WEFT_INTERPOLATION_QUINTIC};
    for (uint32_t i = 0; i < 8; ++i) {
        model = new_texton(context, 16, i & 1 ? 3 : 1, 1 + 2 * i, interpolations[i / 2], i);
        round_trip(model, i & 1 ? 3 : 1);
        weft_model_free(model);
    }
}

static void models_that_the_text_cannot_hold(void **state)
{
    (void)state;
    size_t length = 7;
    weft_model *two = new_texton(context, 16, 2, 4, WEFT_INTERPOLATION_LINEAR, 1),
               *picture = new_picture(context, 4, 4, 3, 1);
    assert_refused(weft_model_save_texton(two, NULL, 0, &length), WEFT_ERROR_UNSUPPORTED, "weft_model_save_texton", "");
    assert_refused(weft_model_save_texton(picture, NULL, 0, &length), WEFT_ERROR_UNSUPPORTED, "weft_model_save_texton",
                   "");
    assert_int_equal(length, 7);
    weft_model_free(two);
    weft_model_free(picture);
}

/* Cut anywhere, a text is refused, or nothing but the note was cut off: then the model is the same. */
static void truncations_of(const char *text, size_t size)
{
    size_t whole_size = 0, refused = 0;
    weft_model *whole = read_text(text, size);
    void *whole_bytes = saved(whole, &whole_size);
    for (size_t length = 0; length < size; ++length) {
        char *cut = malloc(length ? length : 1);
        weft_model *model = UNTOUCHED;
        memcpy(cut, text, length);
        const weft_status status = weft_model_load_texton(context, cut, length, &model);
        if (status == WEFT_OK) {
            size_t cut_size = 0;
            void *cut_bytes = saved(model, &cut_size);
            if (cut_size != whole_size || memcmp(cut_bytes, whole_bytes, whole_size) != 0)
                print_error("the first %zu of %zu bytes are another model\n", length, size);
            assert_int_equal(cut_size, whole_size);
            assert_memory_equal(cut_bytes, whole_bytes, whole_size);
            free(cut_bytes);
            weft_model_free(model);
        } else {
            assert_int_equal(status, WEFT_ERROR_FORMAT);
            assert_ptr_equal(model, UNTOUCHED);
            ++refused;
        }
        free(cut);
    }
    assert_true(refused > size / 2);
    free(whole_bytes);
    weft_model_free(whole);
}

static void every_truncation(void **state)
{
    (void)state;
    static const char unframed[] = "TEXTON\n1\n0\n0.5 0.25 0.125\n2 1\n0.125 1e-3 7\n0.25 0.5 1.25\nnote\n";
    truncations_of(framed, sizeof framed - 1);
    truncations_of(unframed, sizeof unframed - 1);
    size_t size = 0;
    weft_model *model = new_texton(context, 16, 3, 5, WEFT_INTERPOLATION_LINEAR, 1);
    assert_ok(weft_model_save_texton(model, NULL, 0, &size));
    char *text = malloc(size);
    assert_ok(weft_model_save_texton(model, text, size, &size));
    truncations_of(text, size);
    free(text);
    weft_model_free(model);
}

static void wrong_words(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "",
        "\n",
        "texton\n1\n1\n0 0 0\n1 1\n0 0 0\nnote\n",
        "TEXTONS\n1\n1\n0 0 0\n1 1\n0 0 0\nnote\n",
        "TEXTON\n2\n1\n0 0 0\n1 1\n0 0 0\nnote\n",
        "TEXTON\n-1\n1\n0 0 0\n1 1\n0 0 0\nnote\n",
        "TEXTON\n1\none\n0 0 0\n1 1\n0 0 0\nnote\n",
        "TEXTON\n1\n1\n0 nan 0\n1 1\n0 0 0\nnote\n",
        "TEXTON\n1\n1\n0 inf 0\n1 1\n0 0 0\nnote\n",
        "TEXTON\n1\n1\n0 1e99 0\n1 1\n0 0 0\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n0 1\n0 0 0\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n1 0\n0 0 0\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n-1 1\n0 0 0\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n1.5 1\n0 0 0\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n16384 16384\n0 0 0\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n4294967295 4294967295\n0 0 0\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n99999999999999999999 1\n0 0 0\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n1 1\n0 0 NAN\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n1 1\n0 0 -inf\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n1 1\n0 0 1e39\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n1 1\n0 0 0x10\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n1 1\n0,5 0 0\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n1 1\n0 0 zero\nnote\n",
        "TEXTON\n1\n1\n0 0 0\n2 1\n0 0 0\nnote\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; ++i) {
        weft_model *model = UNTOUCHED;
        const weft_status status = weft_model_load_texton(context, texts[i], strlen(texts[i]), &model);
        if (status != WEFT_ERROR_FORMAT) print_error("text %zu: %s\n%s", i, weft_status_name(status), texts[i]);
        assert_int_equal(status, WEFT_ERROR_FORMAT);
        assert_ptr_equal(model, UNTOUCHED);
        assert_int_equal(strncmp(weft_error_message(), "weft_model_load_texton", 22), 0);
    }
}

/* Line ends of other systems, spaces at line ends, and tiny numbers are no errors. */
static void what_is_tolerated(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "TEXTON\r\n1\r\n1\r\n0.5 0.25 1e-60\r\n1 1\r\n1 2 3\r\nnote\r\n",
        "TEXTON \n1 \n1 \n 0.5\t0.25 1e-60 \n1 1 \n1 2 3 \nnote",
        "TEXTON\n1\n1\n5e-1 .25 0\n1 1\n1.0 2.0000000000000000000001 0.3e1\n\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; ++i) {
        weft_model *model = read_text(texts[i], strlen(texts[i]));
        weft_image part = part_of(model, 0);
        const float expected[3] = {1, 2, 3};
        assert_memory_equal(part.data, expected, sizeof expected);
        free_image(&part);
        weft_model_free(model);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_read),      cmocka_unit_test(every_order_of_interpolation),
        cmocka_unit_test(round_trips),       cmocka_unit_test(models_that_the_text_cannot_hold),
        cmocka_unit_test(every_truncation),  cmocka_unit_test(wrong_words),
        cmocka_unit_test(what_is_tolerated),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
