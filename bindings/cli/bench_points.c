/* The points that `weft bench` samples: in the plane, on surfaces, in solids. */
#include "bench.h"
#include "clock.h"
#include "command.h"
#include "report.h"

#include <stdlib.h>

enum { FIRST_POINTS = 4096 };
static const double sample_seconds = 0.25; /* that a measurement of points may take */
static const double domain = 4096;         /* edge of the square, or cube, that the points lie in */

static weft_status sample(const point_case* p, uint32_t first, uint32_t end)
{
    const weft_texture* texture = p->device->texture;
    const bench* b = p->device->owner;
    float* out = b->colours + (size_t)first * b->info.channels;
    if (!p->in_space) return weft_texture_sample(texture, end - first, b->places + first, out);
    if (b->solid_places) return weft_texture_sample_solid(texture, end - first, b->solid_places + first, out);
    return weft_texture_sample_surface(texture, end - first, b->surface_places + first, out);
}

static void do_sample(void* argument, uint32_t i, uint32_t count)
{
    const point_case* p = argument;
    uint32_t first = (uint32_t)((uint64_t)p->count * i / count), end = (uint32_t)((uint64_t)p->count * (i + 1) / count);
    if (sample(p, first, end) != WEFT_OK)
        p->device->owner->colours[0] = -1e30f; /* run_sample asks once more for the sentence */
}

static int run_sample(void* state)
{
    point_case* p = state;
    const bench* b = p->device->owner;
    b->colours[0] = 0;
    int code = bench_on_threads(p->device->threads, do_sample, p);
    if (code != EXIT_FINE || b->colours[0] > -1e29f) return code;
    weft_status status = sample(p, 0, p->count);
    return status == WEFT_OK ? failed("points failed on some thread") : failed_weft(status);
}

/* Finds how many points take no longer than they may; the first ones pay what is paid once. */
static int add_points(point_case* p, const device_case* d, int in_space)
{
    int code = EXIT_FINE;
    double begin = 0;
    p->device = d;
    p->in_space = in_space;
    p->count = FIRST_POINTS;
    for (int i = 0; i < 2 && code == EXIT_FINE; i++) {
        begin = wall_seconds();
        code = run_sample(p);
    }
    double most = FIRST_POINTS * sample_seconds / (wall_seconds() - begin + 1e-9);
    p->count = most > MOST_POINTS ? MOST_POINTS : most > FIRST_POINTS ? (uint32_t)most : FIRST_POINTS;
    const measurement measured = {run_sample, p, p->count, 0, {0}, {0}};
    p->sample = measured;
    return code;
}

int bench_add_points(device_case* d)
{
    int code = add_points(&d->plane, d, 0);
    return code == EXIT_FINE && d->owner->has_yardstick ? add_points(&d->space, d, 1) : code;
}

static double next_place(uint64_t* state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u; /* Knuth's MMIX generator */
    return (double)(*state >> 11) * (domain / 9007199254740992.0);
}

/* Incoherent points, the same in every run. */
static void fill(bench* b)
{
    uint64_t state = 1;
    for (size_t i = 0; i < MOST_POINTS; i++) {
        double x = next_place(&state), y = next_place(&state);
        const weft_point point = {x, y, {0, 0}, {0, 0}};
        b->places[i] = point;
    }
    for (size_t i = 0; i < MOST_POINTS; i++) {
        double x = next_place(&state), y = next_place(&state), z = next_place(&state);
        const weft_solid_point solid = {{x, y, z}, 0, 0};
        const weft_surface_point surface = {{x, y, z}, {0.8f, 0.6f, 0}, {0, 0, 1}};
        if (b->solid_places) b->solid_places[i] = solid;
        if (b->surface_places) b->surface_places[i] = surface;
    }
}

int bench_make_points(bench* b)
{
    int is_solid = b->info.method == WEFT_METHOD_WAVELET, is_surface = b->info.method == WEFT_METHOD_TEXTON;
    b->colours = malloc((size_t)MOST_POINTS * b->info.channels * sizeof *b->colours);
    b->places = malloc((size_t)MOST_POINTS * sizeof *b->places);
    if (is_solid) b->solid_places = malloc((size_t)MOST_POINTS * sizeof *b->solid_places);
    if (is_surface) b->surface_places = malloc((size_t)MOST_POINTS * sizeof *b->surface_places);
    if (!b->colours || !b->places || (is_solid && !b->solid_places) || (is_surface && !b->surface_places))
        return failed("out of memory");
    fill(b);
    return EXIT_FINE;
}

void bench_free_points(bench* b)
{
    free(b->surface_places);
    free(b->solid_places);
    free(b->places);
    free(b->colours);
}
