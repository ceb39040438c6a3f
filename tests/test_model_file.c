/* The model file: canonical bytes, every truncation, every flipped bit, golden files. */
#include "golden.h"
#include "stained.h"
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

#define SPECIMENS 8
static weft_model *specimen(int i)
{
    switch (i) {
    case 0: return new_texton(context, 8, 1, 1, WEFT_INTERPOLATION_LINEAR, 1);
    case 1: return new_texton(context, 8, 3, 4, WEFT_INTERPOLATION_LINEAR, 2);
    case 2: return new_texton(context, 11, 2, 3, WEFT_INTERPOLATION_NEAREST, 3);
    case 3: return new_texton(context, 8, 16, 5, WEFT_INTERPOLATION_CUBIC, 4);
    case 4: return new_texton(context, 9, 4, 4, WEFT_INTERPOLATION_QUINTIC, 5);
    case 5: return new_picture(context, 1, 1, 1, 6);
    case 6: return new_picture(context, 5, 3, 7, 7);
    default: return new_tile(context, 64, 64, 1, 8); /* no tile is smaller */
    }
}

static void saving_is_canonical(void **state)
{
    (void)state;
    for (int i = 0; i < SPECIMENS; ++i) {
        weft_model *model = specimen(i), *loaded = NULL;
        size_t size = 0, size_again = 0;
        unsigned char *bytes = saved(model, &size), *again = saved(model, &size_again);
        assert_int_equal(size, size_again);
        assert_memory_equal(bytes, again, size);
        free(again);
        assert_memory_equal(bytes, "\x89WEFT\r\n\x1a", 8);
        assert_ok(weft_model_load(context, bytes, size, &loaded));
        again = saved(loaded, &size_again);
        assert_int_equal(size, size_again);
        assert_memory_equal(bytes, again, size);

        weft_model_info info = WEFT_MODEL_INFO_INIT, loaded_info = WEFT_MODEL_INFO_INIT;
        assert_ok(weft_model_get(model, &info));
        assert_ok(weft_model_get(loaded, &loaded_info));
        assert_memory_equal(&info, &loaded_info, sizeof info);
        weft_image part = part_of(model, 0), loaded_part = part_of(loaded, 0);
        assert_same_pixels(&part, &loaded_part, "a part after loading");
        free_image(&part);
        free_image(&loaded_part);
        free(again);
        free(bytes);
        weft_model_free(model);
        weft_model_free(loaded);
    }
}

/* The bytes must be refused: a status of a bad file, a sentence, no model. */
static void must_be_refused(const void *bytes, size_t size, const char *what, size_t where)
{
    weft_model *model = UNTOUCHED;
    const weft_status status = weft_model_load(context, bytes, size, &model);
    if (status == WEFT_ERROR_FORMAT || status == WEFT_ERROR_UNSUPPORTED) {
        assert_ptr_equal(model, UNTOUCHED);
        assert_int_equal(strncmp(weft_error_message(), "weft_model_load", 15), 0);
        return;
    }
    print_error("%s %zu: %s\n", what, where, weft_status_name(status));
    fail();
}

static void every_truncation(void **state)
{
    (void)state;
    for (int i = 0; i < SPECIMENS; ++i) {
        weft_model *model = specimen(i);
        size_t size = 0;
        unsigned char *bytes = saved(model, &size);
        for (size_t length = 0; length < size; ++length) {
            unsigned char *cut =
                malloc(length ? length : 1); /* an own block, so that a sanitizer sees one byte too many */
            memcpy(cut, bytes, length);
            must_be_refused(cut, length, "truncated to", length);
            free(cut);
        }
        unsigned char *more = calloc(size + 16, 1);
        memcpy(more, bytes, size);
        for (size_t extra = 1; extra <= 16; ++extra) must_be_refused(more, size + extra, "extended by", extra);
        free(more);
        free(bytes);
        weft_model_free(model);
    }
}

/* Of a long file each bit of the headers, and many of the rest. */
static void every_flipped_bit(void **state)
{
    (void)state;
    for (int i = 0; i < SPECIMENS; ++i) {
        weft_model *model = specimen(i);
        size_t size = 0;
        unsigned char *bytes = saved(model, &size);
        const size_t step = size > 16384 ? 61 : 1;
        for (size_t bit = 0; bit < size * 8; bit += bit < 8192 ? 1 : step) {
            bytes[bit / 8] = (unsigned char)(bytes[bit / 8] ^ 1u << bit % 8);
            must_be_refused(bytes, size, "flipped bit", bit);
            bytes[bit / 8] = (unsigned char)(bytes[bit / 8] ^ 1u << bit % 8);
        }
        free(bytes);
        weft_model_free(model);
    }
}

/* Bytes exchanged, blocks zeroed or repeated: more than one bit, still never taken for a model with other content. */
static void random_damage(void **state)
{
    (void)state;
    Random random = {77};
    for (uint32_t round = 0; round < scaled(20000, 2000); ++round) {
        weft_model *model = round % 64 ? NULL : specimen((int)(round / 64 % SPECIMENS));
        static unsigned char *bytes, *damaged;
        static size_t size;
        if (model) {
            free(bytes);
            free(damaged);
            bytes = saved(model, &size);
            damaged = malloc(size);
            weft_model_free(model);
        }
        memcpy(damaged, bytes, size);
        const size_t from = random_below(&random, (uint32_t)size), to = random_below(&random, (uint32_t)size);
        size_t length = 1 + random_below(&random, 16);
        if (length > size - from) length = size - from;
        if (length > size - to) length = size - to;
        switch (random_below(&random, 3)) {
        case 0: memmove(damaged + to, damaged + from, length); break;
        case 1: memset(damaged + to, (int)random_below(&random, 2) * 255, length); break;
        default:
            for (size_t k = 0; k < length; ++k) damaged[to + k] = (unsigned char)random_bits(&random);
        }
        if (memcmp(damaged, bytes, size) != 0) must_be_refused(damaged, size, "damaged in round", round);
    }
}

/* Files of this release and of every one before it load, and are saved as the same bytes. */
static void golden_files(void **state)
{
    (void)state;
    for (size_t i = 0; i < GOLDEN_MODELS; ++i) {
        char path[512];
        size_t size = 0, size_again = 0;
        weft_model *model = NULL;
        snprintf(path, sizeof path, "%s/%s.weft", WEFT_TEST_DATA, golden_models[i]);
        void *bytes = read_file(path, &size);
        if (!bytes) print_error("no %s\n", path);
        assert_non_null(bytes);
        assert_ok(weft_model_load(context, bytes, size, &model));
        void *again = saved(model, &size_again);
        assert_int_equal(size, size_again);
        assert_memory_equal(bytes, again, size);
        free(again);
        free(bytes);
        weft_model_free(model);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(saving_is_canonical), cmocka_unit_test(every_truncation), cmocka_unit_test(every_flipped_bit),
        cmocka_unit_test(random_damage),       cmocka_unit_test(golden_files),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
