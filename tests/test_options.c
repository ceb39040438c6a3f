/* Structs of another size: shorter ones are filled up with zeros, longer ones are read if their tail is zero, else
 * refused. */
#include "support.h"
#include <stdlib.h>
#include <string.h>

/* A struct as a newer header would have it: ours, then a tail. The union keeps both aligned. */
#define TAIL 24
#define LONGER(Type)                                                                                                   \
    typedef union Longer_##Type {                                                                                      \
        Type known;                                                                                                    \
        unsigned char bytes[sizeof(Type) + TAIL];                                                                      \
    } Longer_##Type
LONGER(weft_context_options);
LONGER(weft_texton_options);
LONGER(weft_texture_options);
LONGER(weft_compare_options);
LONGER(weft_stationary_options);
LONGER(weft_stationarity_options);
LONGER(weft_texture_cost_options);
LONGER(weft_device_info);
LONGER(weft_model_info);
LONGER(weft_part_info);
LONGER(weft_comparison);

static weft_context *context;
static weft_image photo;
static weft_model *model;

static int begin(void **state)
{
    (void)state;
    context = new_context("scalar", 1);
    photo = new_grain(GRAIN_SOFT, 24, 20, 1, 1);
    model = new_texton(context, 16, 1, 8, WEFT_INTERPOLATION_LINEAR, 2);
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_model_free(model);
    weft_context_free(context);
    free_image(&photo);
    return 0;
}

/* The functions that read a struct, each as "what does the call say when given these bytes". */
static weft_status read_context(const void *options)
{
    weft_context *made = NULL;
    const weft_status status = weft_context_create(options, &made);
    weft_context_free(made);
    return status;
}

static weft_status read_texton(const void *options)
{
    weft_model *made = NULL;
    const weft_status status = weft_analyze_texton(context, &photo, options, NULL, NULL, &made);
    weft_model_free(made);
    return status;
}

static weft_status read_texture(const void *options)
{
    weft_texture *made = NULL;
    const weft_status status = weft_texture_create(context, model, options, &made);
    weft_texture_free(made);
    return status;
}

static weft_status read_compare(const void *options)
{
    weft_comparison comparison = WEFT_COMPARISON_INIT;
    return weft_compare(context, &photo, &photo, options, NULL, NULL, &comparison);
}

static weft_status read_stationary(const void *options)
{
    weft_model *made = NULL;
    const weft_status status = weft_analyze_stationary(context, &photo, options, NULL, NULL, &made);
    weft_model_free(made);
    return status;
}

static weft_status read_stationarity(const void *options)
{
    float cost;
    return weft_stationarity_cost(context, &photo, options, NULL, NULL, NULL, &cost);
}

static weft_status read_texture_cost(const void *options)
{
    float cost;
    return weft_texture_cost(context, &photo, &photo, options, NULL, NULL, &cost);
}

/* `options` has `size` bytes that mean something and TAIL bytes behind them. */
static void longer(weft_status (*read)(const void *), void *options, uint32_t size, const char *function)
{
    unsigned char *bytes = options;
    const uint32_t claimed[] = {size + 1, size + 4, size + TAIL};
    for (size_t i = 0; i < 3; ++i) {
        memset(bytes + size, 0, TAIL);
        memcpy(bytes, &claimed[i], sizeof claimed[i]);
        assert_ok(read(bytes));
        for (uint32_t k = size; k < claimed[i]; ++k) {
            bytes[k] = 1;
            assert_refused(read(bytes), WEFT_ERROR_UNSUPPORTED, function, "options");
            bytes[k] = 0;
        }
        if (claimed[i] < size + TAIL) bytes[claimed[i]] = 0xff; /* beyond what is claimed: not ours to read */
        assert_ok(read(bytes));
    }
}

static void longer_options(void **state)
{
    (void)state;
    const weft_context_options fresh_context = WEFT_CONTEXT_OPTIONS_INIT;
    const weft_texton_options fresh_texton = WEFT_TEXTON_OPTIONS_INIT;
    const weft_texture_options fresh_texture = WEFT_TEXTURE_OPTIONS_INIT;
    const weft_compare_options fresh_compare = WEFT_COMPARE_OPTIONS_INIT;
    Longer_weft_context_options context_options = {fresh_context};
    Longer_weft_texton_options texton_options = {fresh_texton};
    Longer_weft_texture_options texture_options = {fresh_texture};
    Longer_weft_compare_options compare_options = {fresh_compare};
    longer(read_context, &context_options, sizeof fresh_context, "weft_context_create");
    longer(read_texton, &texton_options, sizeof fresh_texton, "weft_analyze_texton");
    longer(read_texture, &texture_options, sizeof fresh_texture, "weft_texture_create");
    longer(read_compare, &compare_options, sizeof fresh_compare, "weft_compare");
}

/* Only `size` and some fields are there; what lies behind is rubbish that must not be read. */
static void shorter(weft_status (*read)(const void *), const void *fresh, uint32_t whole, const uint32_t *ends,
                    size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        unsigned char *bytes = malloc(whole);
        memset(bytes, 0xff, whole);
        memcpy(bytes, fresh, ends[i]);
        memcpy(bytes, &ends[i], sizeof ends[i]);
        assert_ok(read(bytes));
        free(bytes);
    }
}

#define END_OF(type, field) (uint32_t)(offsetof(type, field) + sizeof(((const type *)0)->field))

static void shorter_options(void **state)
{
    (void)state;
    const weft_context_options context_options = WEFT_CONTEXT_OPTIONS_INIT;
    const uint32_t context_ends[] = {END_OF(weft_context_options, size), END_OF(weft_context_options, threads),
                                     END_OF(weft_context_options, device), END_OF(weft_context_options, memory_limit),
                                     END_OF(weft_context_options, allocator)};
    shorter(read_context, &context_options, sizeof context_options, context_ends, 5);
    const weft_texton_options texton_options = WEFT_TEXTON_OPTIONS_INIT;
    const uint32_t texton_ends[] = {END_OF(weft_texton_options, size),       END_OF(weft_texton_options, support),
                                    END_OF(weft_texton_options, iterations), END_OF(weft_texton_options, interpolation),
                                    END_OF(weft_texton_options, projection), END_OF(weft_texton_options, zero)};
    shorter(read_texton, &texton_options, sizeof texton_options, texton_ends, 6);
    const weft_texture_options texture_options = WEFT_TEXTURE_OPTIONS_INIT;
    const uint32_t texture_ends[] = {END_OF(weft_texture_options, size), END_OF(weft_texture_options, period_x),
                                     END_OF(weft_texture_options, period_y), END_OF(weft_texture_options, impacts)};
    shorter(read_texture, &texture_options, sizeof texture_options, texture_ends, 4);
    const weft_compare_options compare_options = WEFT_COMPARE_OPTIONS_INIT;
    const uint32_t compare_ends[] = {END_OF(weft_compare_options, size), END_OF(weft_compare_options, zero)};
    shorter(read_compare, &compare_options, sizeof compare_options, compare_ends, 2);
}

/* Small tiles, so that they take little time. */
static void options_of_tiles(void **state)
{
    (void)state;
    weft_stationary_options fresh = WEFT_STATIONARY_OPTIONS_INIT;
    const weft_stationarity_options fresh_stationarity = WEFT_STATIONARITY_OPTIONS_INIT;
    const weft_texture_cost_options fresh_cost = WEFT_TEXTURE_COST_OPTIONS_INIT;
    fresh.width = fresh.height = 64;
    Longer_weft_stationary_options options = {fresh};
    Longer_weft_stationarity_options stationarity_options = {fresh_stationarity};
    Longer_weft_texture_cost_options cost_options = {fresh_cost};
    longer(read_stationary, &options, sizeof fresh, "weft_analyze_stationary");
    longer(read_stationarity, &stationarity_options, sizeof fresh_stationarity, "weft_stationarity_cost");
    longer(read_texture_cost, &cost_options, sizeof fresh_cost, "weft_texture_cost");
    const uint32_t ends[] = {END_OF(weft_stationary_options, height), END_OF(weft_stationary_options, patch),
                             END_OF(weft_stationary_options, seed), END_OF(weft_stationary_options, sigma_map)};
    shorter(read_stationary, &fresh, sizeof fresh, ends, 4);
    const uint32_t stationarity_ends[] = {END_OF(weft_stationarity_options, size),
                                          END_OF(weft_stationarity_options, sigma)};
    shorter(read_stationarity, &fresh_stationarity, sizeof fresh_stationarity, stationarity_ends, 2);
    const uint32_t cost_ends[] = {END_OF(weft_texture_cost_options, patch), END_OF(weft_texture_cost_options, zero)};
    shorter(read_texture_cost, &fresh_cost, sizeof fresh_cost, cost_ends, 2);
}

/* A field that is there is read, however short the struct: support 4 in the first eight bytes. */
static void a_short_struct_is_read(void **state)
{
    (void)state;
    weft_texton_options options = WEFT_TEXTON_OPTIONS_INIT;
    weft_model *made = NULL;
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    options.support = 4;
    options.interpolation = 77;
    options.size = END_OF(weft_texton_options, iterations);
    assert_ok(weft_analyze_texton(context, &photo, &options, NULL, NULL, &made));
    assert_ok(weft_model_get(made, &info));
    assert_int_equal(info.width, 4);
    weft_model_free(made);
}

static weft_status write_device(void *info) { return weft_device_get(0, info); }
static weft_status write_context_device(void *info) { return weft_context_device(context, info); }
static weft_status write_model(void *info) { return weft_model_get(model, info); }
static weft_status write_part(void *info) { return weft_model_part(model, 0, info); }
static weft_status write_comparison(void *comparison)
{
    return weft_compare(context, &photo, &photo, NULL, NULL, NULL, comparison);
}

/* Results for a shorter struct are cut where it ends; for a longer one the tail is zero; `size` stays the caller's. */
static void results(weft_status (*write)(void *), uint32_t size, uint32_t short_size)
{
    unsigned char *whole = calloc(size + TAIL, 1), *other = malloc(size + TAIL);
    memcpy(whole, &size, sizeof size);
    assert_ok(write(whole));

    memset(other, 0xa5, size + TAIL);
    memcpy(other, &short_size, sizeof short_size);
    assert_ok(write(other));
    assert_memory_equal(other, &short_size, sizeof short_size);
    assert_memory_equal(other + 4, whole + 4, short_size - 4);
    for (uint32_t i = short_size; i < size + TAIL; ++i) assert_int_equal(other[i], 0xa5);

    const uint32_t long_size = size + 16;
    memset(other, 0, size + TAIL);
    memset(other + long_size, 0xa5, TAIL - 16);
    memcpy(other, &long_size, sizeof long_size);
    assert_ok(write(other));
    assert_memory_equal(other, &long_size, sizeof long_size);
    assert_memory_equal(other + 4, whole + 4, size - 4);
    for (uint32_t i = size; i < long_size; ++i) assert_int_equal(other[i], 0);
    for (uint32_t i = long_size; i < size + TAIL; ++i) assert_int_equal(other[i], 0xa5);
    free(other);
    free(whole);
}

static void results_of_every_size(void **state)
{
    (void)state;
    results(write_device, sizeof(weft_device_info), END_OF(weft_device_info, name));
    results(write_context_device, sizeof(weft_device_info), END_OF(weft_device_info, status));
    results(write_model, sizeof(weft_model_info), END_OF(weft_model_info, bytes));
    results(write_part, sizeof(weft_part_info), END_OF(weft_part_info, channels));
    results(write_comparison, sizeof(weft_comparison), END_OF(weft_comparison, patch_distance));
}

/* NULL options, zeroed options with a size, and the _INIT value all mean the defaults: the same model, the same pixels.
 */
static void zero_is_the_default(void **state)
{
    (void)state;
    const weft_texton_options texton_options = WEFT_TEXTON_OPTIONS_INIT;
    const weft_texture_options texture_options = WEFT_TEXTURE_OPTIONS_INIT;
    weft_model *a = NULL, *b = NULL;
    size_t size_a = 0, size_b = 0;
    assert_ok(weft_analyze_texton(context, &photo, NULL, NULL, NULL, &a));
    assert_ok(weft_analyze_texton(context, &photo, &texton_options, NULL, NULL, &b));
    void *bytes_a = saved(a, &size_a), *bytes_b = saved(b, &size_b);
    assert_int_equal(size_a, size_b);
    assert_memory_equal(bytes_a, bytes_b, size_a);
    weft_texture *texture_a = NULL, *texture_b = NULL, *texture_c = new_texture(context, a, 30, 0, 0);
    assert_ok(weft_texture_create(context, a, NULL, &texture_a));
    assert_ok(weft_texture_create(context, a, &texture_options, &texture_b));
    weft_image image_a = rendered(texture_a, 0, 0, 0, 40, 20, 1), image_b = rendered(texture_b, 0, 0, 0, 40, 20, 1);
    weft_image image_c = rendered(texture_c, 0, 0, 0, 40, 20, 1);
    assert_same_pixels(&image_a, &image_b, "NULL and _INIT");
    assert_same_pixels(&image_a, &image_c, "NULL and 30 impacts");
    free_image(&image_a);
    free_image(&image_b);
    free_image(&image_c);
    weft_texture_free(texture_a);
    weft_texture_free(texture_b);
    weft_texture_free(texture_c);
    free(bytes_a);
    free(bytes_b);
    weft_model_free(a);
    weft_model_free(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(longer_options),         cmocka_unit_test(shorter_options),
        cmocka_unit_test(a_short_struct_is_read), cmocka_unit_test(results_of_every_size),
        cmocka_unit_test(zero_is_the_default),    cmocka_unit_test(options_of_tiles),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
