/* Galerne, Leclaire, Moisan, "Texton Noise" (2017), equation (1) and section 8: for each pixel, the Poisson points of
 * the cells around it are drawn anew, and each impact is one bilinear fetch from the texton. */
#include "yardstick.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const float cell_size = 0.6f; /* of the texton's edge: the paper's compromise */
static const float two_pi = 6.2831853f;

/* Xorshift (Marsaglia 2003), seeded by a hash of the cell, as the paper does after Reed (2013). */
static uint32_t next(uint32_t* state)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return *state;
}

static float uniform(uint32_t* state) { return (float)(next(state) >> 8) * (1.0f / 16777216.0f); }

static uint32_t wang_hash(uint32_t seed)
{
    seed = (seed ^ 61u) ^ (seed >> 16);
    seed *= 9u;
    seed ^= seed >> 4;
    seed *= 0x27d4eb2du;
    return seed ^ (seed >> 15);
}

/* A Poisson variate by the Gaussian approximation, which the paper uses for its high intensities. */
static int poisson(uint32_t* state, float mean)
{
    float u = 1.0f - uniform(state), v = uniform(state);
    float normal = sqrtf(-2.0f * logf(u)) * cosf(two_pi * v);
    float count = floorf(mean + sqrtf(mean) * normal + 0.5f);
    return count > 0 ? (int)count : 0;
}

/* Adds the texton, bilinearly interpolated, at (dx, dy) texels from its first coefficient. */
static void fetch(const yardstick* y, float dx, float dy, float* sum)
{
    float left = floorf(dx), top = floorf(dy), tx = dx - left, ty = dy - top;
    size_t row = (size_t)(y->width + 2) * y->channels;
    const float* t = y->texton + (size_t)((int)top + 1) * row + (size_t)((int)left + 1) * y->channels;
    for (uint32_t c = 0; c < y->channels; c++) {
        float upper = t[c] + tx * (t[c + y->channels] - t[c]);
        float lower = t[row + c] + tx * (t[row + c + y->channels] - t[row + c]);
        sum[c] += upper + ty * (lower - upper);
    }
}

static void add_cell(const yardstick* y, int cx, int cy, const float at[2], const float cell[2], float* sum)
{
    uint32_t state = wang_hash((uint32_t)cx + wang_hash((uint32_t)cy)) | 1u;
    float rate = y->impacts / ((float)y->width * (float)y->height);
    int count = poisson(&state, rate * cell[0] * cell[1]);
    for (int i = 0; i < count; i++) {
        float dx = at[0] - ((float)cx + uniform(&state)) * cell[0] + 0.5f * (float)y->width - 0.5f;
        float dy = at[1] - ((float)cy + uniform(&state)) * cell[1] + 0.5f * (float)y->height - 0.5f;
        if (dx >= -1 && dx < (float)y->width && dy >= -1 && dy < (float)y->height) fetch(y, dx, dy, sum);
    }
}

void yardstick_pixel(const yardstick* y, float x_at, float y_at, float* out)
{
    const float at[2] = {x_at, y_at};
    const float cell[2] = {cell_size * (float)y->width, cell_size * (float)y->height};
    const float reach[2] = {0.5f * (float)y->width + 0.5f, 0.5f * (float)y->height + 0.5f};
    float sum[16] = {0};
    int last_x = (int)floorf((x_at + reach[0]) / cell[0]), last_y = (int)floorf((y_at + reach[1]) / cell[1]);
    for (int cy = (int)floorf((y_at - reach[1]) / cell[1]); cy <= last_y; cy++)
        for (int cx = (int)floorf((x_at - reach[0]) / cell[0]); cx <= last_x; cx++) add_cell(y, cx, cy, at, cell, sum);
    float rate = y->impacts / ((float)y->width * (float)y->height);
    float scale = 1.0f / sqrtf(rate);
    for (uint32_t c = 0; c < y->channels; c++) out[c] = y->mean[c] + scale * (sum[c] - rate * y->sum[c]);
}

static void sum_coefficients(yardstick* y)
{
    memset(y->sum, 0, sizeof y->sum);
    size_t count = (size_t)(y->width + 2) * (y->height + 2);
    for (size_t i = 0; i < count; i++)
        for (uint32_t c = 0; c < y->channels; c++) y->sum[c] += y->texton[i * y->channels + c];
}

int yardstick_open(yardstick* y, const weft_model* model, const weft_model_info* info, float impacts)
{
    weft_part_info part = WEFT_PART_INFO_INIT;
    memset(y, 0, sizeof *y);
    if (info->method != WEFT_METHOD_TEXTON || weft_model_part(model, 0, &part) != WEFT_OK) return -1;
    size_t row = (size_t)(part.width + 2) * part.channels;
    y->texton = calloc(row * (part.height + 2), sizeof *y->texton);
    if (!y->texton) return -1;
    weft_image inside = {y->texton + row + part.channels,
                         (int64_t)(row * sizeof *y->texton),
                         part.width,
                         part.height,
                         part.channels,
                         WEFT_FORMAT_F32};
    if (weft_model_part_read(model, 0, &inside) != WEFT_OK) {
        yardstick_free(y);
        return -1;
    }
    y->width = part.width;
    y->height = part.height;
    y->channels = part.channels;
    y->impacts = impacts;
    memcpy(y->mean, info->mean, sizeof y->mean);
    sum_coefficients(y);
    return 0;
}

void yardstick_free(yardstick* y)
{
    free(y->texton);
    y->texton = NULL;
}
