/* Handles may be freed in any order, may outlive what they were made from, and may be used with another context. */
#include "allocators.h"
#include "support.h"
#include <stdlib.h>

/* One of everything, over one ledger. */
typedef struct Family {
    Ledger ledger;
    weft_context *context;
    weft_model *model, *copy;
    weft_texture *texture;
} Family;

static void make_family(Family *family, const char *device)
{
    ledger_open(&family->ledger, 0);
    const weft_allocator allocator = ledger_allocator(&family->ledger);
    weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
    options.allocator = &allocator; /* copied: it dies before the context does */
    options.threads = 2;
    options.device = device;
    assert_ok(weft_context_create(&options, &family->context));
    family->model = new_texton(family->context, 16, 3, 8, WEFT_INTERPOLATION_LINEAR, 5);
    size_t size = 0;
    void *bytes = saved(family->model, &size);
    assert_ok(weft_model_load(family->context, bytes, size, &family->copy));
    free(bytes);
    family->texture = new_texture(family->context, family->model, 10, 6, 0);
}

static void free_member(Family *family, uint32_t member)
{
    switch (member) {
    case 0: weft_context_free(family->context); break;
    case 1: weft_model_free(family->model); break;
    case 2: weft_model_free(family->copy); break;
    default: weft_texture_free(family->texture); break;
    }
}

/* What is still alive must still work. */
static void use_rest(const Family *family, const int *freed, const weft_image *expected)
{
    if (!freed[1] || !freed[2]) {
        weft_model_info info = WEFT_MODEL_INFO_INIT;
        assert_ok(weft_model_get(freed[1] ? family->copy : family->model, &info));
        assert_int_equal(info.channels, 3);
        weft_image part = part_of(freed[1] ? family->copy : family->model, 0);
        assert_int_equal(part.width, 8);
        free_image(&part);
    }
    if (!freed[3]) {
        weft_image pixels = rendered(family->texture, -7, 11, 0, 40, 30, 3);
        assert_same_pixels(&pixels, expected, "after others were freed");
        free_image(&pixels);
    }
    if (!freed[0] && !freed[2]) weft_texture_free(new_texture(family->context, family->copy, 10, 6, 0));
}

static void every_order(const char *device)
{
    Family family;
    make_family(&family, device);
    weft_image expected = rendered(family.texture, -7, 11, 0, 40, 30, 3);
    for (uint32_t i = 0; i < 4; ++i) free_member(&family, i);
    ledger_close(&family.ledger);

    for (uint32_t code = 0; code < 256; ++code) {
        const uint32_t order[4] = {code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6};
        if ((1u << order[0] | 1u << order[1] | 1u << order[2] | 1u << order[3]) != 15) continue;
        int freed[4] = {0, 0, 0, 0};
        make_family(&family, device);
        for (uint32_t i = 0; i < 4; ++i) {
            free_member(&family, order[i]);
            freed[order[i]] = 1;
            use_rest(&family, freed, &expected);
        }
        ledger_close(&family.ledger);
    }
    free_image(&expected);
}

static void every_order_of_freeing(void **state)
{
    (void)state;
    char names[MOST_DEVICES][64];
    const uint32_t count = usable_devices(names, 0);
    for (uint32_t i = 0; i < count; ++i) every_order(names[i]);
}

static void a_model_is_used_with_another_context(void **state)
{
    (void)state;
    weft_context *first = new_context("scalar", 1), *second = new_context(NULL, 2);
    weft_model *model = new_texton(first, 16, 1, 8, WEFT_INTERPOLATION_LINEAR, 5);
    weft_texture *here = new_texture(first, model, 10, 6, 0), *there = new_texture(second, model, 10, 6, 0);
    weft_context_free(first);
    weft_model_free(model);
    weft_image a = rendered(here, 0, 0, 0, 33, 9, 1), b = rendered(there, 0, 0, 0, 33, 9, 1);
    assert_same_pixels(&a, &b, "two contexts");
    free_image(&a);
    free_image(&b);
    weft_texture_free(there);
    weft_texture_free(here);
    weft_context_free(second);
}

static void many_times(void **state)
{
    (void)state;
    Ledger ledger;
    ledger_open(&ledger, 0);
    const weft_allocator allocator = ledger_allocator(&ledger);
    for (uint32_t i = 0; i < scaled(100, 20); ++i) {
        weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
        weft_context *context = NULL;
        options.allocator = &allocator;
        options.threads = 1 + i % 3;
        assert_ok(weft_context_create(&options, &context));
        weft_model *model = new_picture(context, 5, 7, 1 + i % 16, i);
        weft_texture *texture = new_texture(context, model, 0, 0, 0);
        weft_image pixels = rendered(texture, 0, 0, 0, 16, 16, 1 + i % 16);
        free_image(&pixels);
        weft_texture_free(texture);
        weft_model_free(model);
        weft_context_free(context);
        assert_int_equal(ledger.held, 0);
    }
    ledger_close(&ledger);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_order_of_freeing),
        cmocka_unit_test(a_model_is_used_with_another_context),
        cmocka_unit_test(many_times),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
