/* Cook and DeRose, "Wavelet Noise" (2005), section 3.3: noise is a sum of octaves, each a uniform quadratic B-spline of
 * a tile's coefficients. In a window the spline is separable: rows of coefficients are expanded to pixels once, and a
 * row of pixels is the sum of three of them per octave, with three multiply-adds each. */
#include "yardstick_direct.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = DIRECT_SIDE, PITCH = DIRECT_SIDE + 2, LANES = 8, CHUNK = 4, STEP = LANES * CHUNK };

typedef float lanes __attribute__((vector_size(4 * LANES)));

typedef struct triple {
    float w[3];
} triple;

static triple weights_at(uint32_t pixel, uint32_t band)
{
    float t = ((float)(pixel & ((1u << band) - 1)) + 0.5f) / (float)(1u << band);
    triple weights = {{0.5f * (1 - t) * (1 - t), 0, 0.5f * t * t}};
    weights.w[1] = 1 - weights.w[0] - weights.w[2];
    return weights;
}

/* sum += w * row, fused where the instruction is there, else by two. */
static inline __attribute__((always_inline)) void add_row(lanes* sum, float w, const float* row, int fused)
{
    for (int k = 0; k < CHUNK; k++) {
        lanes value;
        memcpy(&value, row + k * LANES, sizeof value);
        if (!fused) sum[k] += w * value;
        for (int i = 0; i < LANES && fused; i++) sum[k][i] = fmaf(w, value[i], sum[k][i]);
    }
}

/* A row of pixels: `rows` are three expanded rows for each of `count` / 3 octaves. */
static inline __attribute__((always_inline)) void sum_rows(uint32_t count, const float* const* rows,
                                                           const float* weights, uint32_t width, float* out, int fused)
{
    for (uint32_t x = 0; x < width; x += STEP) {
        lanes sum[CHUNK] = {{0}};
        for (uint32_t r = 0; r < count; r++) add_row(sum, weights[r], rows[r] + x, fused);
        memcpy(out + x, sum, (width - x < STEP ? width - x : STEP) * sizeof *out);
    }
}

typedef void (*row_sum)(uint32_t count, const float* const* rows, const float* weights, uint32_t width, float* out);

static void sum_baseline(uint32_t count, const float* const* rows, const float* weights, uint32_t width, float* out)
{
    sum_rows(count, rows, weights, width, out, 0);
}

#if defined(__x86_64__)
__attribute__((target("avx2,fma"))) static void sum_fused(uint32_t count, const float* const* rows,
                                                          const float* weights, uint32_t width, float* out)
{
    sum_rows(count, rows, weights, width, out, 1);
}

static row_sum best_sum(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? sum_fused : sum_baseline;
}
#else
static row_sum best_sum(void) { return sum_baseline; }
#endif

/* What a thread keeps: per octave the last three rows of coefficients, expanded, each at its number modulo 3. */
typedef struct expansion {
    const direct_noise* noise;
    const float* tile;
    uint32_t width, pitch;
    triple* columns; /* of one octave after another: the weights of its columns */
    float* rows;
    int64_t held[DIRECT_BANDS][3];
} expansion;

static void expand(const expansion* e, uint32_t band, uint32_t row, float* to)
{
    const float* from = e->tile + (size_t)((row + band * 37) % SIDE) * PITCH;
    const triple* columns = e->columns + (size_t)band * e->width;
    if (band == 0) { /* all columns lie alike */
        for (uint32_t begin = 0; begin < e->width; begin += SIDE)
            for (uint32_t x = 0; x < SIDE && begin + x < e->width; x++)
                to[begin + x] = 0.125f * from[x] + 0.75f * from[x + 1] + 0.125f * from[x + 2];
        return;
    }
    for (uint32_t x = 0; x < e->width; x++) {
        const float* at = from + (x >> band) % SIDE;
        to[x] = columns[x].w[0] * at[0] + columns[x].w[1] * at[1] + columns[x].w[2] * at[2];
    }
}

static void make_row(expansion* e, uint32_t y, row_sum sum, float* out)
{
    const float* rows[3 * DIRECT_BANDS];
    float weights[3 * DIRECT_BANDS];
    for (uint32_t band = 0; band < e->noise->bands; band++) {
        triple vertical = weights_at(y, band);
        for (uint32_t k = 0; k < 3; k++) {
            uint32_t row = (y >> band) + k, slot = row % 3;
            float* to = e->rows + (size_t)(3 * band + slot) * e->pitch;
            if (e->held[band][slot] != (int64_t)row) expand(e, band, row, to);
            e->held[band][slot] = row;
            rows[3 * band + k] = to;
            weights[3 * band + k] = vertical.w[k];
        }
    }
    sum(3 * e->noise->bands, rows, weights, e->width, out);
}

int direct_rows(const direct_noise* noise, uint32_t width, uint32_t first, uint32_t end, float* out)
{
    expansion e = {noise, noise->tile, width, (width + STEP - 1) / STEP * STEP, NULL, NULL, {{0}}};
    e.columns = malloc(sizeof *e.columns * noise->bands * width);
    e.rows = calloc((size_t)3 * noise->bands * e.pitch, sizeof *e.rows);
    int bad = !e.columns || !e.rows;
    memset(e.held, -1, sizeof e.held);
    for (uint32_t i = 0; i < noise->bands * width && !bad; i++) e.columns[i] = weights_at(i % width, i / width);
    for (uint32_t y = first; y < end && !bad; y++) make_row(&e, y, best_sum(), out + (size_t)(y - first) * width);
    free(e.rows);
    free(e.columns);
    return bad ? -1 : 0;
}

int direct_open(direct_noise* noise, uint32_t bands)
{
    uint32_t state = 1;
    noise->bands = bands < DIRECT_BANDS ? bands : DIRECT_BANDS;
    noise->tile = malloc(sizeof *noise->tile * SIDE * PITCH);
    if (!noise->tile) return -1;
    for (uint32_t y = 0; y < SIDE; y++) {
        float* row = noise->tile + (size_t)y * PITCH;
        for (uint32_t x = 0; x < SIDE; x++) {
            state = state * 1664525u + 1013904223u; /* Knuth and Lewis */
            row[x] = (float)(int32_t)state * 0x1p-31f;
        }
        row[SIDE] = row[0];
        row[SIDE + 1] = row[1];
    }
    return 0;
}

void direct_free(direct_noise* noise)
{
    free(noise->tile);
    noise->tile = NULL;
}
