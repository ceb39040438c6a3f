/* As test_memory, for bi-layer models and textures: every allocation fails once, in turn. */
#include "bilayers.h"
#include "failing.h"
#include <stdlib.h>

static weft_image photo;
static void *bytes;
static size_t size;
static weft_bilayer_options options;

static int begin(void **state)
{
    (void)state;
    weft_context *context = new_context("scalar", 1);
    photo = new_discs(34, 32, 1, 5);
    options = bilayer_options(2);
    options.support = 8;
    options.window = options.mask_window = 2;
    options.filter_width = 2;
    options.filter_iterations = 1;
    weft_model *model = NULL;
    assert_ok(weft_analyze_bilayer(context, &photo, &options, NULL, NULL, &model));
    bytes = saved(model, &size);
    weft_model_free(model);
    weft_context_free(context);
    return 0;
}

static int end(void **state)
{
    (void)state;
    free_image(&photo);
    free(bytes);
    return 0;
}

CALL_THAT_MAKES_A_MODEL(load, weft_model_load(context, bytes, size, &model))
CALL_THAT_MAKES_A_MODEL(analyze, weft_analyze_bilayer(context, &photo, &options, NULL, NULL, &model))

static weft_status call_create(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_model *model = NULL;
    const weft_status status = weft_model_load(context, bytes, size, &model);
    return status == WEFT_OK ? create(context, model, ledger, fail_at) : status;
}

static weft_status call_tiles(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_model *model = NULL;
    weft_texture *texture = UNTOUCHED;
    weft_texture_options tiles = WEFT_TEXTURE_OPTIONS_INIT;
    tiles.noise = WEFT_NOISE_TILE;
    tiles.turbulence = 4;
    weft_status status = weft_model_load(context, bytes, size, &model);
    if (status != WEFT_OK) return status;
    arm(ledger, fail_at);
    status = weft_texture_create(context, model, &tiles, &texture);
    disarm(ledger);
    if (status == WEFT_OK)
        weft_texture_free(texture);
    else
        assert_ptr_equal(texture, UNTOUCHED);
    weft_model_free(model);
    return status;
}

static weft_status call_render(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    float pixels[40 * 30];
    const weft_image image = {pixels, 0, 40, 30, 1, WEFT_FORMAT_F32};
    weft_model *model = NULL;
    weft_texture *texture = NULL;
    weft_status status = weft_model_load(context, bytes, size, &model);
    if (status == WEFT_OK) status = weft_texture_create(context, model, NULL, &texture);
    arm(ledger, fail_at);
    if (status == WEFT_OK) status = weft_texture_render(texture, -9, 4, 0, NULL, NULL, &image);
    disarm(ledger);
    weft_texture_free(texture);
    weft_model_free(model);
    return status;
}

EACH(load)
EACH(create)
EACH(render)

/* These take a while: once will do. */
static void test_tiles(void **state)
{
    (void)state;
    fail_in_turn(call_tiles, 1, 0);
}

static void test_analyze(void **state)
{
    (void)state;
    fail_in_turn(call_analyze, 2, 0);
    limit_each(call_analyze);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_load), cmocka_unit_test(test_create),
                                       cmocka_unit_test(test_render), cmocka_unit_test(test_tiles),
                                       cmocka_unit_test(test_analyze)};
    return cmocka_run_group_tests(tests, begin, end);
}
