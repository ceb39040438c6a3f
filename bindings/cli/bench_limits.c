/* The limits that `weft bench` measures: multiply-adds, stores, and the paper's shader. */
#include "bench.h"
#include "command.h"
#include "report.h"
#include "threads.h"

enum { YARDSTICK_ROWS = 32 };
static const uint64_t multiply_add_rounds = 4000000;
static const size_t store_bytes = BENCH_STORE_BYTES;

int bench_on_threads(uint32_t threads, void (*work)(void* argument, uint32_t i, uint32_t count), void* argument)
{
    return run_threads(threads, work, argument) == 0 ? EXIT_FINE : failed("threads could not be started");
}

static void do_multiply_add(void* argument, uint32_t i, uint32_t count)
{
    const limit_case* c = argument;
    (void)i, (void)count;
    volatile float kept = c->owner->multiply_add.run(multiply_add_rounds); /* what is computed is needed by someone */
    (void)kept;
}

static void store_share(void* memory, uint32_t i, uint32_t count, int non_temporal)
{
    size_t share = store_bytes / count / 64 * 64;
    machine_store((char*)memory + share * i, share, non_temporal);
}

static void do_plain_store(void* argument, uint32_t i, uint32_t count)
{
    store_share(((limit_case*)argument)->owner->store, i, count, 0);
}

static void do_non_temporal_store(void* argument, uint32_t i, uint32_t count)
{
    store_share(((limit_case*)argument)->owner->store, i, count, 1);
}

static uint32_t yardstick_rows(const bench* b)
{
    return b->size.height < YARDSTICK_ROWS ? b->size.height : YARDSTICK_ROWS;
}

/* Every so-manieth row of the window. */
static void do_yardstick(void* argument, uint32_t i, uint32_t count)
{
    const bench* b = ((limit_case*)argument)->owner;
    uint32_t rows = yardstick_rows(b), step = b->size.height / rows;
    for (uint32_t y = i; y < rows; y += count)
        for (uint32_t x = 0; x < b->size.width; x++)
            yardstick_pixel(&b->yardstick, (float)x + 0.5f, (float)(y * step) + 0.5f,
                            b->pixels + ((size_t)y * b->size.width + x) * b->info.channels);
}

static int run_multiply_add(void* state)
{
    return bench_on_threads(((limit_case*)state)->threads, do_multiply_add, state);
}

static int run_plain_store(void* state)
{
    return bench_on_threads(((limit_case*)state)->threads, do_plain_store, state);
}

static int run_non_temporal_store(void* state)
{
    return bench_on_threads(((limit_case*)state)->threads, do_non_temporal_store, state);
}

static int run_yardstick(void* state) { return bench_on_threads(((limit_case*)state)->threads, do_yardstick, state); }

void bench_add_limits(bench* b, uint32_t threads)
{
    limit_case* c = &b->limits[b->limit_count++];
    const double rounds = (double)multiply_add_rounds * threads;
    const measurement multiply_add = {run_multiply_add, c, b->multiply_add.lanes * rounds, 0, {0}, {0}};
    const measurement plain = {run_plain_store, c, (double)store_bytes, 0, {0}, {0}};
    const measurement non_temporal = {run_non_temporal_store, c, (double)store_bytes, 0, {0}, {0}};
    const measurement gather = {run_yardstick, c, (double)b->size.width * yardstick_rows(b), 0, {0}, {0}};
    c->owner = b;
    c->threads = threads;
    c->multiply_add = multiply_add;
    c->store[0] = plain;
    c->store[1] = non_temporal;
    c->yardstick = gather;
}
