/* The limits that `weft bench` measures: multiply-adds, stores, and the papers' own ways. */
#include "bench.h"
#include "command.h"
#include "report.h"
#include "threads.h"

enum { YARDSTICK_ROWS = 32, SOLID_POINTS = 16384 };
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

/* Channel by channel, a share of the rows. */
static void do_direct(void* argument, uint32_t i, uint32_t count)
{
    const bench* b = ((limit_case*)argument)->owner;
    uint32_t first = (uint32_t)((uint64_t)b->size.height * i / count),
             end = (uint32_t)((uint64_t)b->size.height * (i + 1) / count);
    for (uint32_t c = 0; c < b->info.channels; c++) {
        float* out = b->pixels + ((size_t)c * b->size.height + first) * b->size.width;
        if (direct_rows(&b->direct, b->size.width, first, end, out) != 0) b->colours[0] = -1e30f;
    }
}

static void do_solid(void* argument, uint32_t i, uint32_t count)
{
    const bench* b = ((limit_case*)argument)->owner;
    for (uint32_t k = i; k < SOLID_POINTS; k += count)
        for (uint32_t c = 0; c < b->info.channels; c++)
            b->colours[(size_t)k * b->info.channels + c] =
                solid_value(&b->solid, b->octaves, b->solid_places[k].position);
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

static int run_yardstick(void* state)
{
    const limit_case* c = state;
    if (c->owner->octaves == 0) return bench_on_threads(c->threads, do_yardstick, state);
    c->owner->colours[0] = 0;
    int code = bench_on_threads(c->threads, do_direct, state);
    return code != EXIT_FINE || c->owner->colours[0] > -1e29f ? code : failed("out of memory");
}

static int run_solid(void* state) { return bench_on_threads(((limit_case*)state)->threads, do_solid, state); }

void bench_add_limits(bench* b, uint32_t threads)
{
    limit_case* c = &b->limits[b->limit_count++];
    const double rounds = (double)multiply_add_rounds * threads;
    const measurement multiply_add = {run_multiply_add, c, b->multiply_add.lanes * rounds, 0, {0}, {0}};
    const measurement plain = {run_plain_store, c, (double)store_bytes, 0, {0}, {0}};
    const measurement non_temporal = {run_non_temporal_store, c, (double)store_bytes, 0, {0}, {0}};
    const double rows = b->octaves > 0 ? b->size.height : yardstick_rows(b);
    const measurement windows = {run_yardstick, c, (double)b->size.width * rows, 0, {0}, {0}};
    const measurement solid = {run_solid, c, (double)SOLID_POINTS * b->octaves * b->info.channels, 0, {0}, {0}};
    c->owner = b;
    c->threads = threads;
    c->multiply_add = multiply_add;
    c->store[0] = plain;
    c->store[1] = non_temporal;
    c->yardstick = windows;
    c->solid = solid;
}
