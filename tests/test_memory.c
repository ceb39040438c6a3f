/* Every allocation fails once, in turn, in every function: the status, untouched outputs, nothing left. And the limit.
 */
#include "failing.h"
#include <stdlib.h>
#include <string.h>

/* What the calls under test work with; made without failures, by a context of its own. */
static weft_image photo, output;
static void *model_bytes;
static size_t model_size;
static char *text;
static size_t text_size;

static int begin(void **state)
{
    (void)state;
    weft_context *context = new_context("scalar", 1);
    photo = new_grain(GRAIN_SOFT, 24, 20, 3, 1);
    output = new_grain(GRAIN_SOFT, 32, 32, 3, 2);
    weft_model *model = new_texton(context, 16, 3, 8, WEFT_INTERPOLATION_LINEAR, 3);
    model_bytes = saved(model, &model_size);
    assert_ok(weft_model_save_texton(model, NULL, 0, &text_size));
    text = malloc(text_size);
    assert_ok(weft_model_save_texton(model, text, text_size, &text_size));
    weft_model_free(model);
    weft_context_free(context);
    return 0;
}

static int end(void **state)
{
    (void)state;
    free_image(&photo);
    free_image(&output);
    free(model_bytes);
    free(text);
    return 0;
}

static const weft_texton_options few = {sizeof few, 8, 2, 0, 0, 0, 0};
CALL_THAT_MAKES_A_MODEL(analyze_texton, weft_analyze_texton(context, &photo, &few, NULL, NULL, &model))
CALL_THAT_MAKES_A_MODEL(analyze_picture, weft_analyze_picture(context, &photo, &model))
CALL_THAT_MAKES_A_MODEL(load, weft_model_load(context, model_bytes, model_size, &model))
CALL_THAT_MAKES_A_MODEL(load_texton, weft_model_load_texton(context, text, text_size, &model))

static weft_status use_model(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_model *model = NULL;
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    weft_part_info part = WEFT_PART_INFO_INIT;
    char *bytes = malloc(model_size + text_size);
    size_t length = 0;
    assert_ok(weft_model_load(context, model_bytes, model_size, &model));
    weft_image image = part_of(model, 0);
    arm(ledger, fail_at);
    weft_status status = weft_model_get(model, &info);
    if (status == WEFT_OK) status = weft_model_save(model, bytes, model_size);
    if (status == WEFT_OK) status = weft_model_save_texton(model, bytes, text_size, &length);
    if (status == WEFT_OK) status = weft_model_part(model, 0, &part);
    if (status == WEFT_OK) status = weft_model_part_read(model, 0, &image);
    disarm(ledger);
    free_image(&image);
    free(bytes);
    weft_model_free(model);
    return status;
}

static weft_status call_create(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_model *model = NULL;
    const weft_status status = weft_model_load(context, model_bytes, model_size, &model);
    return status == WEFT_OK ? create(context, model, ledger, fail_at) : status;
}

static weft_status call_create_picture(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_model *model = NULL;
    const weft_status status = weft_analyze_picture(context, &photo, &model);
    return status == WEFT_OK ? create(context, model, ledger, fail_at) : status;
}

static weft_status call_render(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_model *model = NULL;
    weft_texture *texture = NULL;
    weft_image image = new_image(70, 50, 3, WEFT_FORMAT_U8);
    weft_status status = weft_model_load(context, model_bytes, model_size, &model);
    if (status == WEFT_OK) status = weft_texture_create(context, model, NULL, &texture);
    arm(ledger, fail_at);
    if (status == WEFT_OK) status = weft_texture_render(texture, 3, -5, 1, NULL, NULL, &image);
    disarm(ledger);
    free_image(&image);
    weft_texture_free(texture);
    weft_model_free(model);
    return status;
}

static weft_status call_spectrum(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_image out = new_image(10, 7, 3, WEFT_FORMAT_F32);
    fill_bytes(&out, 0xa5);
    arm(ledger, fail_at);
    const weft_status status = weft_power_spectrum(context, &photo, &out);
    disarm(ledger);
    if (status != WEFT_OK) assert_true(all_bytes(&out, 0xa5));
    free_image(&out);
    return status;
}

static weft_status call_autocovariance(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_image out = new_image(10, 7, 3, WEFT_FORMAT_F32);
    fill_bytes(&out, 0xa5);
    arm(ledger, fail_at);
    const weft_status status = weft_autocovariance(context, &photo, &out);
    disarm(ledger);
    if (status != WEFT_OK) assert_true(all_bytes(&out, 0xa5));
    free_image(&out);
    return status;
}

static weft_status call_histogram(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    uint64_t counts[30];
    unsigned char untouched[sizeof counts];
    memset(counts, 0xa5, sizeof counts);
    memset(untouched, 0xa5, sizeof counts);
    arm(ledger, fail_at);
    const weft_status status = weft_histogram(context, &photo, 0, 1, 10, counts);
    disarm(ledger);
    if (status != WEFT_OK) assert_memory_equal(counts, untouched, sizeof counts);
    return status;
}

static weft_status call_compare(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_comparison comparison = WEFT_COMPARISON_INIT;
    const weft_comparison before = comparison;
    arm(ledger, fail_at);
    const weft_status status = weft_compare(context, &photo, &output, NULL, NULL, NULL, &comparison);
    disarm(ledger);
    if (status != WEFT_OK) assert_memory_equal(&comparison, &before, sizeof before);
    return status;
}

static weft_status call_describe(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_description description = WEFT_DESCRIPTION_INIT;
    const weft_description before = description;
    arm(ledger, fail_at);
    const weft_status status = weft_describe(context, &output, NULL, NULL, &description);
    disarm(ledger);
    if (status != WEFT_OK) assert_memory_equal(&description, &before, sizeof before);
    return status;
}

EACH(analyze_texton)
EACH(analyze_picture)
EACH(load)
EACH(load_texton)
EACH(create)
EACH(create_picture)
EACH(render)
EACH(spectrum)
EACH(autocovariance)
EACH(histogram)
EACH(compare)
EACH(describe)

static void test_model_functions(void **state)
{
    (void)state;
    fail_each(use_model);
}

/* A context that cannot be made leaves nothing and touches nothing. */
static void contexts(void **state)
{
    (void)state;
    char names[MOST_DEVICES][64];
    const uint32_t count = usable_devices(names, 0);
    for (uint32_t i = 0; i < count; ++i) {
        weft_status status = WEFT_ERROR_MEMORY;
        for (uint64_t n = 1; status != WEFT_OK; ++n) {
            Ledger ledger;
            ledger_open(&ledger, n);
            const weft_allocator allocator = ledger_allocator(&ledger);
            weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
            weft_context *context = UNTOUCHED;
            options.allocator = &allocator;
            options.device = names[i];
            status = weft_context_create(&options, &context);
            if (status == WEFT_OK) {
                weft_context_free(context);
            } else {
                assert_int_equal(status, WEFT_ERROR_MEMORY);
                assert_ptr_equal(context, UNTOUCHED);
            }
            ledger_close(&ledger);
            assert_true(n < 10000);
        }
    }
}

/* Each device's own allocations, while a texture is opened and used. */
static void devices(void **state)
{
    (void)state;
    char names[MOST_DEVICES][64];
    const uint32_t count = usable_devices(names, 0);
    for (uint32_t i = 0; i < count; ++i) {
        weft_status status = WEFT_ERROR_MEMORY;
        for (uint64_t n = 1; status != WEFT_OK; ++n) {
            Ledger ledger;
            ledger_open(&ledger, 0);
            const weft_allocator allocator = ledger_allocator(&ledger);
            weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
            weft_context *context = NULL;
            options.allocator = &allocator;
            options.device = names[i];
            options.threads = 1;
            assert_ok(weft_context_create(&options, &context));
            status = call_create(context, &ledger, n);
            if (status == WEFT_OK) status = call_render(context, &ledger, n);
            if (status != WEFT_OK) assert_int_equal(status, WEFT_ERROR_MEMORY);
            weft_context_free(context);
            ledger_close(&ledger);
            assert_true(n < 10000);
        }
    }
}

static void sampling_allocates_nothing(void **state)
{
    (void)state;
    Ledger ledger;
    ledger_open(&ledger, 0);
    const weft_allocator allocator = ledger_allocator(&ledger);
    weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
    weft_context *context = NULL;
    weft_model *model = NULL;
    weft_point points[300];
    float out[300 * 3];
    options.allocator = &allocator;
    assert_ok(weft_context_create(&options, &context));
    assert_ok(weft_model_load(context, model_bytes, model_size, &model));
    weft_texture *texture = new_texture(context, model, 0, 0, 0);
    Random random = {5};
    for (int i = 0; i < 300; ++i) {
        const float size = (float)random_unit(&random) * 8;
        const weft_point point = {1000 * random_unit(&random), 1000 * random_unit(&random), {size, 0}, {0, 1}};
        points[i] = point;
    }
    const uint64_t before = ledger.calls;
    ledger.fail_at = before + 1;
    assert_ok(weft_texture_sample(texture, 300, points, out));
    assert_int_equal(ledger.calls, before);
    weft_texture_free(texture);
    weft_model_free(model);
    weft_context_free(context);
    ledger_close(&ledger);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contexts),
        cmocka_unit_test(test_analyze_picture),
        cmocka_unit_test(test_load),
        cmocka_unit_test(test_load_texton),
        cmocka_unit_test(test_model_functions),
        cmocka_unit_test(test_create),
        cmocka_unit_test(test_create_picture),
        cmocka_unit_test(test_render),
        cmocka_unit_test(devices),
        cmocka_unit_test(sampling_allocates_nothing),
        cmocka_unit_test(test_histogram),
        cmocka_unit_test(test_spectrum),
        cmocka_unit_test(test_autocovariance),
        cmocka_unit_test(test_analyze_texton),
        cmocka_unit_test(test_compare),
        cmocka_unit_test(test_describe),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
