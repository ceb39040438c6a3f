/* As test_memory, for wavelet noise, mixing, surfaces and solids: every allocation fails once, in turn. */
#include "failing.h"
#include "wavelets.h"
#include <stdlib.h>

static weft_image photo;
static void *texton_bytes, *wavelet_bytes;
static size_t texton_size, wavelet_size;
static weft_wavelet wavelet;

static int begin(void **state)
{
    (void)state;
    weft_context *context = new_context("scalar", 1);
    photo = new_grain(GRAIN_SOFT, 12, 10, 3, 1);
    wavelet = random_wavelet(1, 2, 4, 1);
    weft_model *texton = new_texton(context, 16, 1, 4, WEFT_INTERPOLATION_LINEAR, 3),
               *noise = new_wavelet(context, &wavelet);
    texton_bytes = saved(texton, &texton_size);
    wavelet_bytes = saved(noise, &wavelet_size);
    weft_model_free(noise);
    weft_model_free(texton);
    weft_context_free(context);
    return 0;
}

static int end(void **state)
{
    (void)state;
    free_image(&photo);
    free(texton_bytes);
    free(wavelet_bytes);
    return 0;
}

CALL_THAT_MAKES_A_MODEL(analyze_wavelet, weft_analyze_wavelet(context, &photo, NULL, NULL, NULL, &model))
CALL_THAT_MAKES_A_MODEL(from_wavelet, weft_model_from_wavelet(context, &wavelet, &model))
CALL_THAT_MAKES_A_MODEL(load_wavelet, weft_model_load(context, wavelet_bytes, wavelet_size, &model))

/* Mixing of two models that the same bytes make, steps of textons or t of wavelets. */
static weft_status mix(weft_context *context, const void *bytes, size_t size, Ledger *ledger, uint64_t fail_at)
{
    weft_model *a = NULL, *mixed = UNTOUCHED;
    weft_status status = weft_model_load(context, bytes, size, &a);
    if (status != WEFT_OK) return status;
    arm(ledger, fail_at);
    status = weft_model_mix(context, a, a, 0.5f, 2, &mixed);
    disarm(ledger);
    if (status == WEFT_OK)
        weft_model_free(mixed);
    else
        assert_ptr_equal(mixed, UNTOUCHED);
    weft_model_free(a);
    return status;
}

static weft_status call_mix(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    return mix(context, texton_bytes, texton_size, ledger, fail_at);
}

static weft_status call_morph(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    return mix(context, wavelet_bytes, wavelet_size, ledger, fail_at);
}

static weft_status call_create_wavelet(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    weft_model *model = NULL;
    const weft_status status = weft_model_load(context, wavelet_bytes, wavelet_size, &model);
    return status == WEFT_OK ? create(context, model, ledger, fail_at) : status;
}

/* The first points in space open the texture once more. */
static weft_status call_surface(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    const weft_surface_point point = {{1, 2, 3}, {1, 0, 0}, {0, 1, 0}};
    weft_model *model = NULL;
    weft_texture *texture = NULL;
    float out = 7;
    weft_status status = weft_model_load(context, texton_bytes, texton_size, &model);
    if (status == WEFT_OK) status = weft_texture_create(context, model, NULL, &texture);
    arm(ledger, fail_at);
    if (status == WEFT_OK) status = weft_texture_sample_surface(texture, 1, &point, &out);
    disarm(ledger);
    if (status != WEFT_OK) assert_true(out == 7);
    weft_texture_free(texture);
    weft_model_free(model);
    return status;
}

static weft_status call_solid(weft_context *context, Ledger *ledger, uint64_t fail_at)
{
    const weft_solid_point point = {{1, 2, 3}, 1, 0};
    weft_model *model = NULL;
    weft_texture *texture = NULL;
    float out = 7;
    weft_status status = weft_model_load(context, wavelet_bytes, wavelet_size, &model);
    if (status == WEFT_OK) status = weft_texture_create(context, model, NULL, &texture);
    arm(ledger, fail_at);
    if (status == WEFT_OK) status = weft_texture_sample_solid(texture, 1, &point, &out);
    disarm(ledger);
    if (status != WEFT_OK) assert_true(out == 7);
    weft_texture_free(texture);
    weft_model_free(model);
    return status;
}

EACH(from_wavelet)
EACH(load_wavelet)
EACH(morph)
EACH(create_wavelet)
EACH(surface)
EACH(analyze_wavelet)
EACH(mix)

/* Lattices in space are large: once will do. */
static void test_solid(void **state)
{
    (void)state;
    fail_in_turn(call_solid, 1, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_from_wavelet),    cmocka_unit_test(test_load_wavelet), cmocka_unit_test(test_morph),
        cmocka_unit_test(test_create_wavelet),  cmocka_unit_test(test_surface),      cmocka_unit_test(test_solid),
        cmocka_unit_test(test_analyze_wavelet), cmocka_unit_test(test_mix),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
