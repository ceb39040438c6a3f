/* As test_memory, for stationary tiles and their costs: every allocation fails once, in turn. */
#include "failing.h"
#include "stained.h"
#include <stdlib.h>

static weft_image photo, map;
static void *bytes;
static size_t size;
static weft_stationary_options options;

static int begin(void **state)
{
    (void)state;
    const weft_stationary_options fresh = WEFT_STATIONARY_OPTIONS_INIT;
    weft_context *context = new_context("scalar", 1);
    photo = new_stained_maps(24, 20, 3, 1);
    map = new_image(2, 2, 1, WEFT_FORMAT_F32);
    fill_bytes(&map, 0x3e);
    weft_model *model = new_tile(context, 64, 64, 3, 1);
    bytes = saved(model, &size);
    weft_model_free(model);
    weft_context_free(context);
    options = fresh;
    options.width = options.height = 64;
    options.patch = 5;
    options.sigma_map = &map;
    return 0;
}

static int end(void **state)
{
    (void)state;
    free_image(&photo);
    free_image(&map);
    free(bytes);
    return 0;
}

CALL_THAT_MAKES_A_MODEL(analyze, weft_analyze_stationary(context, &photo, &options, NULL, NULL, &model))
CALL_THAT_MAKES_A_MODEL(load, weft_model_load(context, bytes, size, &model))

static weft_status call_create(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_model *model = NULL;
    const weft_status status = weft_model_load(context, bytes, size, &model);
    return status == WEFT_OK ? create(context, model, ledger, fail_at) : status;
}

/* The model's own memory is what is used: it has the context's limit. */
static weft_status call_apply(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_model *model = NULL;
    weft_image tile = new_image(64, 64, 3, WEFT_FORMAT_F32), places = new_image(64, 64, 2, WEFT_FORMAT_F32);
    weft_part_info info = WEFT_PART_INFO_INIT;
    fill_bytes(&tile, 0xa5);
    fill_bytes(&places, 0xa5);
    weft_status status = weft_model_load(context, bytes, size, &model);
    arm(ledger, fail_at);
    if (status == WEFT_OK) status = weft_model_part(model, 1, &info);
    if (status == WEFT_OK)
        status = weft_model_part_read(model, 1, &places);
    else
        assert_true(all_bytes(&places, 0xa5));
    if (status == WEFT_OK) status = weft_model_apply(model, &photo, &tile);
    disarm(ledger);
    if (status != WEFT_OK) assert_true(all_bytes(&tile, 0xa5));
    weft_model_free(model);
    free_image(&tile);
    free_image(&places);
    return status;
}

static weft_status cost_of(weft_context *context, weft_stationarity measure, Ledger *ledger, uint64_t fail_at)
{
    weft_stationarity_options cost_options = WEFT_STATIONARITY_OPTIONS_INIT;
    weft_image costs = new_image(5, 4, 1, WEFT_FORMAT_F32);
    float cost = 7;
    cost_options.stationarity = measure;
    fill_bytes(&costs, 0xa5);
    arm(ledger, fail_at);
    const weft_status status = weft_stationarity_cost(context, &photo, &cost_options, NULL, NULL, &costs, &cost);
    disarm(ledger);
    if (status != WEFT_OK) assert_true(cost == 7 && all_bytes(&costs, 0xa5));
    free_image(&costs);
    return status;
}

static weft_status call_moments(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    return cost_of(context, WEFT_STATIONARITY_MOMENTS, ledger, fail_at);
}

static weft_status call_steerable(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    return cost_of(context, WEFT_STATIONARITY_STEERABLE, ledger, fail_at);
}

static weft_status call_texture_cost(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_texture_cost_options cost_options = WEFT_TEXTURE_COST_OPTIONS_INIT;
    float cost = 7;
    cost_options.samples = 4;
    arm(ledger, fail_at);
    const weft_status status = weft_texture_cost(context, &photo, &photo, &cost_options, NULL, NULL, &cost);
    disarm(ledger);
    if (status != WEFT_OK) assert_true(cost == 7);
    return status;
}

EACH(load)
EACH(create)
EACH(apply)
EACH(moments)
EACH(steerable)
EACH(texture_cost)

/* A tile takes time: the limits once, failures on one thread. */
static void test_analyze(void **state)
{
    (void)state;
    fail_in_turn(call_analyze, 1, 0);
    fail_in_turn(call_analyze, 2, 1);
    limit_each(call_analyze);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_load),    cmocka_unit_test(test_create),    cmocka_unit_test(test_apply),
        cmocka_unit_test(test_moments), cmocka_unit_test(test_steerable), cmocka_unit_test(test_texture_cost),
        cmocka_unit_test(test_analyze),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
