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

/* Adds the texton, bilinearly interpolated, at (dx, dy) texels from its first coefficient; both are at least -1. */
static void fetch(const yardstick* y, float dx, float dy, float* sum)
{
    int left = (int)(dx + 1), top = (int)(dy + 1); /* in the frame */
    float tx = dx + 1 - (float)left, ty = dy + 1 - (float)top;
    size_t texel = (size_t)y->fours * 4, row = texel * (y->width + 2);
    const float* t = y->texton + (size_t)top * row + (size_t)left * texel;
    for (size_t first = 0; first < texel; first += 4)
        for (size_t c = first; c < first + 4; c++) {
            float upper = t[c] + tx * (t[c + texel] - t[c]);
            float lower = t[row + c] + tx * (t[row + c + texel] - t[row + c]);
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
    size_t count = (size_t)(y->width + 2) * (y->height + 2), texel = (size_t)y->fours * 4;
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < y->channels; c++) y->sum[c] += y->texton[i * texel + c];
}

/* Reads the model's coefficients and spreads them over the framed texels. */
static int read_texton(yardstick* y, const weft_model* model)
{
    size_t texel = (size_t)y->fours * 4;
    float* values = malloc(sizeof *values * y->width * y->height * y->channels);
    y->texton = calloc(texel * (y->width + 2) * (y->height + 2), sizeof *y->texton);
    const weft_image image = {values, 0, y->width, y->height, y->channels, WEFT_FORMAT_F32};
    int bad = !values || !y->texton || weft_model_part_read(model, 0, &image) != WEFT_OK;
    for (size_t i = 0; i < (size_t)y->width * y->height && !bad; i++) {
        size_t place = (i / y->width + 1) * (y->width + 2) + i % y->width + 1;
        memcpy(y->texton + place * texel, values + i * y->channels, y->channels * sizeof *values);
    }
    free(values);
    return bad;
}

int yardstick_open(yardstick* y, const weft_model* model, const weft_model_info* info, float impacts)
{
    weft_part_info part = WEFT_PART_INFO_INIT;
    memset(y, 0, sizeof *y);
    if (info->method != WEFT_METHOD_TEXTON || weft_model_part(model, 0, &part) != WEFT_OK) return -1;
    y->width = part.width;
    y->height = part.height;
    y->channels = part.channels;
    y->fours = (part.channels + 3) / 4;
    y->impacts = impacts;
    memcpy(y->mean, info->mean, sizeof y->mean);
    if (read_texton(y, model) != 0) {
        yardstick_free(y);
        return -1;
    }
    sum_coefficients(y);
    return 0;
}

void yardstick_free(yardstick* y)
{
    free(y->texton);
    y->texton = NULL;
}
