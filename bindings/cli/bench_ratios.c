/* The ratios of `weft bench`. */
#include "bench.h"

#include <string.h>

static const limit_case* limits_of(const bench* b, const device_case* d)
{
    for (int i = 0; i < b->limit_count; i++)
        if (b->limits[i].threads == d->threads) return &b->limits[i];
    return &b->limits[0];
}

static double divide(double value, double by) { return by > 0 ? value / by : 0; }

/* The fastest window of the devices whose name begins so, with that number of threads. */
static const device_case* find(const bench* b, const char* name, uint32_t threads)
{
    const device_case* best = NULL;
    for (int i = 0; i < b->device_count; i++) {
        const device_case* d = &b->devices[i];
        if (d->threads != threads || strncmp(d->device.name, name, strlen(name)) != 0) continue;
        if (!best || best_rate(&d->window) > best_rate(&best->window)) best = d;
    }
    return best;
}

static double window_ratio(const device_case* d, const device_case* other, bench_rate rate)
{
    return other ? divide(rate(&d->window), rate(&other->window)) : 0;
}

double ratio_of_peak(const bench* b, const device_case* d, bench_rate rate)
{
    double work = 0;
    if (b->info.method == WEFT_METHOD_TEXTON) work = 3.0 * b->info.channels * (double)b->impacts;
    if (b->info.method == WEFT_METHOD_WAVELET) work = 10.0 * b->info.channels;
    return divide(rate(&d->window) * work, rate(&limits_of(b, d)->multiply_add));
}

double ratio_of_store(const bench* b, const device_case* d, bench_rate rate)
{
    const limit_case* limits = limits_of(b, d);
    double plain = rate(&limits->store[0]), non_temporal = rate(&limits->store[1]);
    return divide(rate(&d->window) * 4.0 * b->info.channels, plain > non_temporal ? plain : non_temporal);
}

double ratio_to_yardstick(const bench* b, const device_case* d, bench_rate rate)
{
    return b->has_yardstick ? divide(rate(&d->window), rate(&limits_of(b, d)->yardstick)) : 0;
}

double ratio_to_scalar(const bench* b, const device_case* d, bench_rate rate)
{
    return window_ratio(d, find(b, "scalar", d->threads), rate);
}

double ratio_to_simd(const bench* b, const device_case* d, bench_rate rate)
{
    return window_ratio(d, find(b, "simd:", d->threads), rate);
}

double ratio_to_one_thread(const bench* b, const device_case* d, bench_rate rate)
{
    return window_ratio(d, find(b, d->device.name, 1), rate);
}

double ratio_points_to_scalar(const bench* b, const device_case* d, bench_rate rate)
{
    const device_case* scalar = find(b, "scalar", d->threads);
    return scalar ? divide(rate(&d->plane.sample), rate(&scalar->plane.sample)) : 0;
}

double ratio_space_to_scalar(const bench* b, const device_case* d, bench_rate rate)
{
    const device_case* scalar = find(b, "scalar", d->threads);
    return scalar && b->has_yardstick ? divide(rate(&d->space.sample), rate(&scalar->space.sample)) : 0;
}

double ratio_space_to_yardstick(const bench* b, const device_case* d, bench_rate rate)
{
    if (b->octaves == 0) return 0;
    return divide(rate(&d->space.sample) * b->octaves * b->info.channels, rate(&limits_of(b, d)->solid));
}

double octave_time(const bench* b, const device_case* d, bench_rate rate)
{
    return b->octaves > 0 ? divide(1e9, rate(&d->space.sample) * b->octaves * b->info.channels) : 0;
}
