/* The devices that `weft bench` times, and all that it prepares. */
#include "bench.h"
#include "clock.h"
#include "command.h"
#include "open.h"
#include "progress.h"
#include "report.h"
#include "threads.h"

#include <stdlib.h>
#include <string.h>

enum { FIRST_POINTS = 4096 };
static const double sample_seconds = 0.25; /* that a measurement of points may take */
static const double domain = 4096;         /* edge of the square that the points lie in */

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

static void do_sample(void* argument, uint32_t i, uint32_t count)
{
    const device_case* d = argument;
    const bench* b = d->owner;
    uint32_t first = (uint32_t)((uint64_t)d->points * i / count),
             end = (uint32_t)((uint64_t)d->points * (i + 1) / count);
    weft_status status =
        weft_texture_sample(d->texture, end - first, b->places + first, b->colours + (size_t)first * b->info.channels);
    if (status != WEFT_OK) b->colours[0] = -1e30f; /* run_sample asks once more for the sentence */
}

static int run_sample(void* state)
{
    const device_case* d = state;
    const bench* b = d->owner;
    b->colours[0] = 0;
    int code = bench_on_threads(d->threads, do_sample, state);
    if (code != EXIT_FINE || b->colours[0] > -1e29f) return code;
    weft_status status = weft_texture_sample(d->texture, d->points, b->places, b->colours);
    return status == WEFT_OK ? failed("points failed on some thread") : failed_weft(status);
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

/* Draws the first window, which pays what is paid once, and finds how many points take no longer than they may. */
static int warm_up(device_case* d)
{
    double begin = wall_seconds();
    int code = run_window(d);
    d->first_seconds = wall_seconds() - begin;
    d->points = FIRST_POINTS;
    for (int i = 0; i < 2 && code == EXIT_FINE; i++) {
        begin = wall_seconds();
        code = run_sample(d);
    }
    double most = FIRST_POINTS * sample_seconds / (wall_seconds() - begin + 1e-9);
    d->points = most > MOST_POINTS ? MOST_POINTS : most > FIRST_POINTS ? (uint32_t)most : FIRST_POINTS;
    return code;
}

static int add_device(bench* b, const char* name, uint32_t threads)
{
    device_case* d = &b->devices[b->device_count];
    memset(d, 0, sizeof *d);
    d->owner = b;
    d->threads = threads;
    b->device_count++;
    int code = open_texture(d, name);
    if (code == EXIT_FINE) code = warm_up(d);
    const measurement window = {run_window, d, (double)b->size.width * b->size.height, 0, {0}, {0}};
    const measurement sample = {run_sample, d, d->points, 0, {0}, {0}};
    d->window = window;
    d->sample = sample;
    return code;
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

/* Incoherent points, the same in every run. */
static void fill_places(bench* b)
{
    uint64_t state = 1;
    for (size_t i = 0; i < MOST_POINTS; i++) {
        double place[2];
        for (int k = 0; k < 2; k++) {
            state = state * 6364136223846793005u + 1442695040888963407u; /* Knuth's MMIX generator */
            place[k] = (double)(state >> 11) * (domain / 9007199254740992.0);
        }
        const weft_point point = {place[0], place[1], {0, 0}, {0, 0}};
        b->places[i] = point;
    }
}

static int reserve(bench* b)
{
    size_t channels = b->info.channels;
    b->pixels = malloc((size_t)b->size.width * b->size.height * channels * sizeof *b->pixels);
    b->colours = malloc((size_t)MOST_POINTS * channels * sizeof *b->colours);
    b->places = malloc((size_t)MOST_POINTS * sizeof *b->places);
    b->store_memory = malloc(BENCH_STORE_BYTES + 64);
    b->devices = malloc(MOST_DEVICES * THREAD_CASES * sizeof *b->devices);
    if (!b->pixels || !b->colours || !b->places || !b->store_memory || !b->devices) return failed("out of memory");
    b->store = (void*)(((uintptr_t)b->store_memory + 63) / 64 * 64);
    return EXIT_FINE;
}

int bench_prepare(bench* b, const arguments* common)
{
    uint32_t all = common->threads ? common->threads : available_threads();
    int code = reserve(b);
    if (code != EXIT_FINE) return code;
    fill_places(b);
    b->multiply_add = machine_multiply_add();
    b->has_yardstick = yardstick_open(&b->yardstick, b->model, &b->info, b->impacts) == 0;
    bench_add_limits(b, 1);
    if (all > 1) bench_add_limits(b, all);
    return add_devices(b, common->device);
}

int bench_measure(bench* b)
{
    measurement* list[THREAD_CASES * (4 + 2 * MOST_DEVICES)];
    int count = 0;
    for (int i = 0; i < b->limit_count; i++) {
        list[count++] = &b->limits[i].multiply_add;
        list[count++] = &b->limits[i].store[0];
        list[count++] = &b->limits[i].store[1];
        if (b->has_yardstick) list[count++] = &b->limits[i].yardstick;
    }
    for (int i = 0; i < b->device_count; i++) {
        list[count++] = &b->devices[i].window;
        list[count++] = &b->devices[i].sample;
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
    free(b->places);
    free(b->colours);
    free(b->pixels);
    yardstick_free(&b->yardstick);
    weft_model_free(b->model);
}
