/* The devices that `weft bench` times, and what it prepares for them. */
#include "bench.h"
#include "clock.h"
#include "command.h"
#include "open.h"
#include "progress.h"
#include "report.h"
#include "threads.h"

#include <stdlib.h>
#include <string.h>

static int32_t only_cancel(void* user, float done) WEFT_NOEXCEPT
{
    (void)user, (void)done;
    return interrupted();
}

static int run_window(void* state)
{
    const device_case* d = state;
    const bench* b = d->owner;
    weft_image image = {b->pixels, 0, b->size.width, b->size.height, b->info.channels, WEFT_FORMAT_F32};
    weft_status status = weft_texture_render(d->texture, 0, 0, 0, only_cancel, NULL, &image);
    return status == WEFT_OK ? EXIT_FINE : failed_weft(status);
}

static int open_texture(device_case* d, const char* name)
{
    const bench* b = d->owner;
    const weft_device_info info = WEFT_DEVICE_INFO_INIT;
    const arguments common = {name, d->threads, 0, 0, {NULL}, 0};
    weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    options.impacts = b->impacts;
    d->device = info;
    int code = open_context(&common, &d->context);
    if (code != EXIT_FINE) return code;
    weft_status status = weft_context_device(d->context, &d->device);
    if (status == WEFT_OK) status = weft_texture_create(d->context, b->model, &options, &d->texture);
    return status == WEFT_OK ? EXIT_FINE : failed_weft(status);
}

static int add_device(bench* b, const char* name, uint32_t threads)
{
    device_case* d = &b->devices[b->device_count];
    memset(d, 0, sizeof *d);
    d->owner = b;
    d->threads = threads;
    b->device_count++;
    int code = open_texture(d, name);
    const double begin = wall_seconds();
    if (code == EXIT_FINE) code = run_window(d);
    d->first_seconds = wall_seconds() - begin; /* with all that is paid once */
    const measurement window = {run_window, d, (double)b->size.width * b->size.height, 0, {0}, {0}};
    d->window = window;
    return code == EXIT_FINE ? bench_add_points(d) : code;
}

static int is_known(const bench* b, const char* name)
{
    for (int i = 0; i < b->device_count; i++)
        if (strcmp(b->devices[i].device.name, name) == 0) return 1;
    return 0;
}

/* Adds a device with every number of threads. */
static int add_device_cases(bench* b, const char* name)
{
    int code = EXIT_FINE;
    if (is_known(b, name) || b->device_count + THREAD_CASES > MOST_DEVICES * THREAD_CASES) return EXIT_FINE;
    for (int i = 0; i < b->limit_count && code == EXIT_FINE; i++) code = add_device(b, name, b->limits[i].threads);
    return code;
}

static int add_devices(bench* b, const char* only)
{
    uint32_t count = 0;
    int code = add_device_cases(b, "scalar");
    if (code == EXIT_FINE && only) return add_device_cases(b, only);
    weft_status status = weft_device_count(&count);
    if (status != WEFT_OK) return failed_weft(status);
    for (uint32_t i = 0; i < count && code == EXIT_FINE; i++) {
        weft_device_info device = WEFT_DEVICE_INFO_INIT;
        if (weft_device_get(i, &device) == WEFT_OK && device.status == WEFT_OK) code = add_device_cases(b, device.name);
    }
    return code;
}

static int reserve(bench* b)
{
    size_t channels = b->info.channels;
    b->pixels = malloc((size_t)b->size.width * b->size.height * channels * sizeof *b->pixels);
    b->store_memory = malloc(BENCH_STORE_BYTES + 64);
    b->devices = malloc(MOST_DEVICES * THREAD_CASES * sizeof *b->devices);
    if (!b->pixels || !b->store_memory || !b->devices) return failed("out of memory");
    b->store = (void*)(((uintptr_t)b->store_memory + 63) / 64 * 64);
    return bench_make_points(b);
}

/* What the model is compared with; an exit code. */
static int open_yardsticks(bench* b)
{
    weft_wavelet wavelet = WEFT_WAVELET_INIT;
    if (b->info.method == WEFT_METHOD_TEXTON)
        b->has_yardstick = yardstick_open(&b->yardstick, b->model, &b->info, b->impacts) == 0;
    if (b->info.method != WEFT_METHOD_WAVELET) return EXIT_FINE;
    weft_status status = weft_model_get_wavelet(b->model, &wavelet);
    if (status != WEFT_OK) return failed_weft(status);
    b->octaves = wavelet.bands;
    b->has_yardstick = 1;
    return direct_open(&b->direct, b->octaves) == 0 && solid_open(&b->solid) == 0 ? EXIT_FINE : failed("out of memory");
}

int bench_prepare(bench* b, const arguments* common)
{
    uint32_t all = common->threads ? common->threads : available_threads();
    int code = reserve(b);
    if (code == EXIT_FINE) code = open_yardsticks(b);
    if (code != EXIT_FINE) return code;
    b->multiply_add = machine_multiply_add();
    bench_add_limits(b, 1);
    if (all > 1) bench_add_limits(b, all);
    return add_devices(b, common->device);
}

int bench_measure(bench* b)
{
    measurement* list[THREAD_CASES * (5 + 3 * MOST_DEVICES)];
    int count = 0;
    for (int i = 0; i < b->limit_count; i++) {
        list[count++] = &b->limits[i].multiply_add;
        list[count++] = &b->limits[i].store[0];
        list[count++] = &b->limits[i].store[1];
        if (b->has_yardstick) list[count++] = &b->limits[i].yardstick;
        if (b->octaves > 0) list[count++] = &b->limits[i].solid;
    }
    for (int i = 0; i < b->device_count; i++) {
        list[count++] = &b->devices[i].window;
        list[count++] = &b->devices[i].plane.sample;
        if (b->has_yardstick) list[count++] = &b->devices[i].space.sample;
    }
    return measure(list, count, (int)b->repetitions);
}

void bench_free(bench* b)
{
    for (int i = 0; i < b->device_count; i++) {
        weft_texture_free(b->devices[i].texture);
        weft_context_free(b->devices[i].context);
    }
    free(b->devices);
    free(b->store_memory);
    bench_free_points(b);
    free(b->pixels);
    yardstick_free(&b->yardstick);
    direct_free(&b->direct);
    solid_free(&b->solid);
    weft_model_free(b->model);
}
