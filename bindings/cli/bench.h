/* What `weft bench` measures: the machine's limits and the paper's shader per number of threads, then each device. */
#ifndef WEFT_CLI_BENCH_H
#define WEFT_CLI_BENCH_H

#include "json.h"
#include "machine.h"
#include "measure.h"
#include "numbers.h"
#include "options.h"
#include "yardstick.h"
#include "yardstick_direct.h"
#include "yardstick_solid.h"

#include <weft/weft.h>

enum { MOST_POINTS = 1000000, MOST_DEVICES = 64, THREAD_CASES = 2, BENCH_STORE_BYTES = 64 << 20 };

typedef struct bench bench;

/* The limits with one number of threads. */
typedef struct limit_case {
    bench* owner;
    uint32_t threads;
    measurement multiply_add, store[2]; /* store: plain, non-temporal */
    measurement yardstick, solid;       /* of windows; of points in space, per octave and channel */
} limit_case;

/* Points of one kind on one device. */
typedef struct point_case {
    const struct device_case* device;
    int in_space; /* solid points, or points on a surface */
    uint32_t count;
    measurement sample;
} point_case;

/* One device with one number of threads. */
typedef struct device_case {
    bench* owner;
    weft_device_info device;
    uint32_t threads;
    weft_context* context;
    weft_texture* texture;
    double first_seconds; /* of the first window, with all that is done once */
    measurement window;
    point_case plane, space;
} device_case;

struct bench {
    const char* path;
    extent size;
    float impacts;
    uint32_t repetitions;
    weft_model* model;
    weft_model_info info;
    multiply_add_loop multiply_add;
    yardstick yardstick; /* of texton noise */
    direct_noise direct; /* of wavelet noise, as is `solid` */
    solid_noise solid;
    uint32_t octaves;  /* of wavelet noise, else 0 */
    int has_yardstick; /* the model is noise */
    float *pixels, *colours;
    weft_point* places;
    weft_solid_point* solid_places;     /* of wavelet noise */
    weft_surface_point* surface_places; /* of texton noise */
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

/* Points of all kinds that the model has; an exit code. */
int bench_make_points(bench* b);
void bench_free_points(bench* b);

/* Finds how many points a measurement takes, and prepares it; an exit code. */
int bench_add_points(device_case* d);

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
double ratio_space_to_scalar(const bench* b, const device_case* d, bench_rate rate);
double ratio_space_to_yardstick(const bench* b, const device_case* d, bench_rate rate); /* the code in circulation */

/* Nanoseconds of a solid point per octave and channel; 0 for what is not wavelet noise. */
double octave_time(const bench* b, const device_case* d, bench_rate rate);

#endif
