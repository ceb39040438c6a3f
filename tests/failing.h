/* What the tests of memory share: a call is made again and again, each of its allocations failing in turn, and within
 * limits. */
#ifndef WEFT_TESTS_FAILING_H
#define WEFT_TESTS_FAILING_H

#include "allocators.h"
#include "support.h"
#include <string.h>

static char elsewhere;
#define UNTOUCHED ((void *)&elsewhere)

/* A call over a context whose allocator is the ledger's; everything it makes is freed by it. Allocations of the set-up
 * before the call under test are not failed: `arm` begins the count. The limit of a context holds for the set-up as
 * well. */
typedef weft_status (*Call)(weft_context *context, Ledger *ledger, uint64_t fail_at);

static inline void arm(Ledger *ledger, uint64_t fail_at) { ledger->fail_at = fail_at ? ledger->calls + fail_at : 0; }

static inline void disarm(Ledger *ledger) { ledger->fail_at = 0; }

/* Calls that make a model, or a texture of a model that they free, from what `begin` prepared. */
#define CALL_THAT_MAKES_A_MODEL(name, expression)                                                                      \
    static weft_status call_##name(weft_context *context, Ledger *ledger, uint64_t fail_at)                            \
    {                                                                                                                  \
        weft_model *model = UNTOUCHED;                                                                                 \
        arm(ledger, fail_at);                                                                                          \
        const weft_status status = (expression);                                                                       \
        disarm(ledger);                                                                                                \
        if (status == WEFT_OK)                                                                                         \
            weft_model_free(model);                                                                                    \
        else                                                                                                           \
            assert_ptr_equal(model, UNTOUCHED);                                                                        \
        return status;                                                                                                 \
    }
static inline weft_status create(weft_context *context, weft_model *model, Ledger *ledger, uint64_t fail_at)
{
    weft_texture *texture = UNTOUCHED;
    arm(ledger, fail_at);
    const weft_status status = weft_texture_create(context, model, NULL, &texture);
    disarm(ledger);
    if (status == WEFT_OK)
        weft_texture_free(texture);
    else
        assert_ptr_equal(texture, UNTOUCHED);
    weft_model_free(model);
    return status;
}

static inline weft_status with_context(Call call, uint32_t threads, uint64_t limit, Ledger *ledger, uint64_t fail_at)
{
    const weft_allocator allocator = ledger_allocator(ledger);
    weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
    weft_context *context = NULL;
    options.allocator = &allocator;
    options.threads = threads;
    options.device = "scalar";
    options.memory_limit = limit;
    weft_status status = weft_context_create(&options, &context);
    if (limit == 0) assert_ok(status); /* else the limit may be too low for a context itself */
    if (status == WEFT_OK) status = call(context, ledger, fail_at);
    weft_context_free(context);
    return status;
}

/* Fails allocation n of the call for n = 1, 2, ... until the call succeeds. Where a call makes thousands of
 * allocations, n grows in steps after the first hundred. */
static inline void fail_in_turn(Call call, uint32_t threads, int all_after)
{
    weft_status status = WEFT_ERROR_MEMORY;
    for (uint64_t n = 1; status != WEFT_OK; n += 1 + (n > 100 ? n / scaled(16, 4) : 0)) {
        Ledger ledger;
        ledger_open(&ledger, 0);
        ledger.fail_from_there = all_after;
        status = with_context(call, threads, 0, &ledger, n);
        if (status != WEFT_OK) {
            assert_int_equal(status, WEFT_ERROR_MEMORY);
            assert_true(strlen(weft_error_message()) > 10);
        }
        ledger_close(&ledger);
        assert_true(n < 1000000);
    }
}

/* Once the allocation alone and once with all after it. */
static inline void fail_each(Call call)
{
    for (uint32_t threads = 1; threads <= 2; ++threads)
        for (int all_after = 0; all_after < 2; ++all_after) fail_in_turn(call, threads, all_after);
}

/* With a limit of the call's peak it succeeds; with any lower one it fails, or does with less; the limit is always
 * kept. */
static inline void limit_each(Call call)
{
    Ledger ledger;
    ledger_open(&ledger, 0);
    assert_ok(with_context(call, 1, 0, &ledger, 0));
    const uint64_t peak = ledger.peak;
    ledger_close(&ledger);
    uint32_t refused = 0;
    for (uint32_t eighths = 8; eighths > 0; --eighths) {
        const uint64_t limit = peak * eighths / 8;
        if (limit == 0) continue;
        ledger_open(&ledger, 0);
        const weft_status status = with_context(call, 1, limit, &ledger, 0);
        if (eighths == 8) assert_int_equal(status, WEFT_OK);
        if (status != WEFT_OK) assert_int_equal(status, WEFT_ERROR_MEMORY);
        assert_true(ledger.peak <= limit);
        refused += status != WEFT_OK;
        ledger_close(&ledger);
    }
    if (peak >= 8) assert_true(refused > 0);
}

#define EACH(name)                                                                                                     \
    static void test_##name(void **state)                                                                              \
    {                                                                                                                  \
        (void)state;                                                                                                   \
        fail_each(call_##name);                                                                                        \
        limit_each(call_##name);                                                                                       \
    }

#endif
