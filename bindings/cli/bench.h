/* What `weft bench` measures: the machine's limits and the paper's shader per number of threads, then each device. */
#ifndef WEFT_CLI_BENCH_H
#define WEFT_CLI_BENCH_H

#include "json.h"
#include "machine.h"
#include "measure.h"
#include "numbers.h"
#include "options.h"
#include "yardstick.h"

#include <weft/weft.h>

enum { MOST_POINTS = 1000000, MOST_DEVICES = 64, THREAD_CASES = 2, BENCH_STORE_BYTES = 64 << 20 };

typedef struct bench bench;

/* The limits with one number of threads. */
typedef struct limit_case {
    bench* owner;
    uint32_t threads;
    measurement multiply_add, store[2], yardstick; /* store: plain, non-temporal */
} limit_case;

/* One device with one number of threads. */
typedef struct device_case {
    bench* owner;
    weft_device_info device;
    uint32_t threads, points;
    weft_context* context;
    weft_texture* texture;
    double first_seconds; /* of the first window, with all that is done once */
    measurement window, sample;
} device_case;

struct bench {
    const char* path;
    extent size;
    float impacts;
    uint32_t repetitions;
    weft_model* model;
    weft_model_info info;
    multiply_add_loop multiply_add;
    yardstick yardstick;
    int has_yardstick; /* the model is texton noise */
    float *pixels, *colours;
    weft_point* places;
    void *store_memory, *store;
    limit_case limits[THREAD_CASES];
    int limit_count;
    device_case* devices; /* MOST_DEVICES * THREAD_CASES */
    int device_count;
};

/* Prepares everything to be measured; `common` says which devices and threads. An exit code. */
int bench_prepare(bench* b, const arguments* common);

/* Adds what is measured once per number of threads. */
void bench_add_limits(bench* b, uint32_t threads);

/* Work on threads of our own; an exit code. */
int bench_on_threads(uint32_t threads, void (*work)(void* argument, uint32_t i, uint32_t count), void* argument);

/* Measures it. */
int bench_measure(bench* b);
void bench_free(bench* b);

void bench_write_json(const bench* b);
void bench_write_text(const bench* b);

/* Ratios by best_rate, or by processor_rate, which other programs disturb less; 0 where one is not defined. */
typedef double (*bench_rate)(const measurement* m);

double ratio_of_peak(const bench* b, const device_case* d, bench_rate rate); /* 3 * impacts, or 10, * channels */
double ratio_of_store(const bench* b, const device_case* d, bench_rate rate);
double ratio_to_yardstick(const bench* b, const device_case* d, bench_rate rate);
double ratio_to_scalar(const bench* b, const device_case* d, bench_rate rate);
double ratio_to_simd(const bench* b, const device_case* d, bench_rate rate); /* the best simd device */
double ratio_to_one_thread(const bench* b, const device_case* d, bench_rate rate);
double ratio_points_to_scalar(const bench* b, const device_case* d, bench_rate rate);

#endif
