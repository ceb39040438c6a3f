/* Progress: from 0 to 1, never back, on the calling thread; cancelling at every step ends the call and leaves nothing.
 */
#include "allocators.h"
#include "support.h"
#include <math.h>
#include <pthread.h>

typedef struct Report {
    pthread_t caller;
    uint32_t calls, cancel_at; /* 0: never */
    uint32_t after_cancel;
    float first, last;
    int wrong_thread, backwards, outside;
} Report;

static int32_t on_progress(void *user, float done)
{
    Report *report = user;
    if (report->cancel_at && report->calls >= report->cancel_at) ++report->after_cancel;
    if (!pthread_equal(pthread_self(), report->caller)) report->wrong_thread = 1;
    if (!(done >= 0 && done <= 1)) report->outside = 1;
    if (report->calls == 0)
        report->first = done;
    else if (!(done >= report->last))
        report->backwards = 1;
    report->last = done;
    ++report->calls;
    return report->calls == report->cancel_at ? 1 : 0;
}

static weft_image photo, output;
static weft_context *makers;
static weft_model *model;
static char elsewhere;
#define UNTOUCHED ((void *)&elsewhere)

static int begin(void **state)
{
    (void)state;
    makers = new_context("scalar", 1);
    model = new_texton(makers, 32, 1, 16, WEFT_INTERPOLATION_LINEAR, 1);
    photo = new_grain(GRAIN_SOFT, 32, 32, 3, 1);
    output = new_grain(GRAIN_SOFT, 48, 40, 3, 2);
    return 0;
}

static int end(void **state)
{
    (void)state;
    free_image(&photo);
    free_image(&output);
    weft_model_free(model);
    weft_context_free(makers);
    return 0;
}

typedef weft_status (*Call)(weft_context *context, Report *report);

static weft_status call_analyze(weft_context *context, Report *report)
{
    weft_model *made = UNTOUCHED;
    weft_texton_options options = WEFT_TEXTON_OPTIONS_INIT;
    options.iterations = 12;
    const weft_status status = weft_analyze_texton(context, &photo, &options, on_progress, report, &made);
    if (status == WEFT_OK)
        weft_model_free(made);
    else
        assert_ptr_equal(made, UNTOUCHED);
    return status;
}

static weft_status call_analyze_wavelet(weft_context *context, Report *report)
{
    weft_model *made = UNTOUCHED;
    const weft_status status = weft_analyze_wavelet(context, &photo, NULL, on_progress, report, &made);
    if (status == WEFT_OK)
        weft_model_free(made);
    else
        assert_ptr_equal(made, UNTOUCHED);
    return status;
}

static weft_status call_render(weft_context *context, Report *report)
{
    weft_texture *texture = new_texture(context, model, 5, 0, 0);
    weft_image image = new_image(600, scaled(1500, 700), 1, WEFT_FORMAT_U8);
    const weft_status status = weft_texture_render(texture, -100, 50, 0, on_progress, report, &image);
    free_image(&image);
    weft_texture_free(texture);
    return status;
}

static weft_status call_compare(weft_context *context, Report *report)
{
    weft_comparison comparison = WEFT_COMPARISON_INIT;
    const weft_status status = weft_compare(context, &photo, &output, NULL, on_progress, report, &comparison);
    if (status != WEFT_OK) assert_true(comparison.model_error == 0 && comparison.seam_score == 0);
    return status;
}

static weft_status call_describe(weft_context *context, Report *report)
{
    weft_description description = WEFT_DESCRIPTION_INIT;
    const weft_status status = weft_describe(context, &output, on_progress, report, &description);
    if (status != WEFT_OK) assert_true(description.method == 0 && description.reasons[0] == '\0');
    return status;
}

static weft_status observed(Call call, const char *device, uint32_t threads, uint32_t cancel_at, Report *report)
{
    const Report fresh = {pthread_self(), 0, cancel_at, 0, -1, -1, 0, 0, 0};
    Ledger ledger;
    ledger_open(&ledger, 0);
    const weft_allocator allocator = ledger_allocator(&ledger);
    weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
    weft_context *context = NULL;
    options.allocator = &allocator;
    options.device = device;
    options.threads = threads;
    assert_ok(weft_context_create(&options, &context));
    *report = fresh;
    const weft_status status = call(context, report);
    weft_context_free(context);
    ledger_close(&ledger);
    assert_int_equal(report->wrong_thread, 0);
    assert_int_equal(report->backwards, 0);
    assert_int_equal(report->outside, 0);
    assert_true(report->first == 0);
    return status;
}

static void observe(Call call, uint32_t least_calls)
{
    const char *const device[] = {"scalar", NULL};
    for (int d = 0; d < 2; ++d)
        for (uint32_t threads = 1; threads <= 3; ++threads) {
            Report report;
            assert_ok(observed(call, device[d], threads, 0, &report));
            assert_true(report.last == 1);
            assert_true(report.calls >= least_calls);
            const uint32_t calls = report.calls, step = 1 + calls / scaled(24, 8);
            for (uint32_t n = 1; n <= calls; n += n < 8 ? 1 : step) {
                const weft_status status = observed(call, device[d], threads, n, &report);
                if (status == WEFT_OK && report.calls < n)
                    break; /* another number of threads' luck: fewer reports this time */
                assert_int_equal(status, WEFT_ERROR_CANCELLED);
                assert_int_equal(report.after_cancel, 0);
                assert_true(weft_error_message()[0] != 0);
            }
        }
}

static void analysis(void **state)
{
    (void)state;
    observe(call_analyze, 12);
}

static void wavelet_analysis(void **state)
{
    (void)state;
    observe(call_analyze_wavelet, 4);
}

static void rendering(void **state)
{
    (void)state;
    observe(call_render, 2);
}

static void comparison(void **state)
{
    (void)state;
    observe(call_compare, 3);
}

static void description(void **state)
{
    (void)state;
    observe(call_describe, 6);
}

/* What was cancelled can be done again, with the same result as if nothing had happened. */
static void again_after_cancelling(void **state)
{
    (void)state;
    weft_context *context = new_context(NULL, 2);
    weft_texture *texture = new_texture(context, model, 5, 9, 0);
    weft_image expected = rendered(texture, 0, 0, 0, 600, 1100, 1), image = new_image(600, 1100, 1, WEFT_FORMAT_F32);
    Report report = {pthread_self(), 0, 2, 0, -1, -1, 0, 0, 0};
    assert_int_equal(weft_texture_render(texture, 0, 0, 0, on_progress, &report, &image), WEFT_ERROR_CANCELLED);
    assert_ok(weft_texture_render(texture, 0, 0, 0, NULL, NULL, &image));
    assert_same_pixels(&image, &expected, "after cancelling");
    free_image(&image);
    free_image(&expected);
    weft_texture_free(texture);
    weft_context_free(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(analysis),   cmocka_unit_test(wavelet_analysis), cmocka_unit_test(rendering),
        cmocka_unit_test(comparison), cmocka_unit_test(description),      cmocka_unit_test(again_after_cancelling),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
