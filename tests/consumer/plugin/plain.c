/* A backend from a third party, written from backend.h and PROGRAMS.md alone: it evaluates programs whose layers are
 * plain pictures (TILE, one view, no exchange, nothing referred to), bit for bit as "scalar" does, and leaves all
 * others to it. Compile with -ffp-contract=off. PLAIN_TINT is added to each pixel, to see from outside that this code
 * was at work. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <weft/backend.h>

#ifndef PLAIN_NAME
#define PLAIN_NAME "plain"
#endif

struct weft_backend_device {
    const weft_host *host;
};

struct weft_backend_texture {
    weft_backend_device *device;
    const weft_program *program;
};

/* Where a position lies on one axis: a texel of the cell and a fraction. */
typedef struct place {
    int32_t texel;
    float fraction;
} place;

typedef struct taps {
    uint32_t first, second;
    float t;
} taps;

static float lerp(float a, float b, float t) { return t * (b - a) + a; }

static int64_t floor_divide(int64_t a, int64_t b) { return a / b - (a % b < 0); }

/* PROGRAMS.md, TILE, "Locate". */
static place locate(const weft_grid *grid, uint32_t size, uint32_t period, int64_t pixel, uint32_t fraction)
{
    const int64_t x = period ? pixel - floor_divide(pixel, period) * period : pixel;
    const int64_t n = x * grid->cells, m = n - floor_divide(n, grid->span) * grid->span;
    const int64_t i = m * size / grid->span, r = m * size - i * grid->span;
    const float s = ((float)fraction * 0x1p-24f) * grid->step + (float)r * grid->inverse;
    const float k = floorf(s);
    place p;
    p.texel = (int32_t)i + (int32_t)k;
    p.fraction = s - k;
    if (p.texel >= (int32_t)size) p.texel -= (int32_t)size;
    return p;
}

static uint32_t reduce(int32_t i, uint32_t size)
{
    const int32_t r = i % (int32_t)size;
    return (uint32_t)(r < 0 ? r + (int32_t)size : r);
}

/* "Taps of a level", on one axis. */
static taps taps_of(place p, uint32_t level, float scale, uint32_t size)
{
    const float s = level == 0 ? p.fraction - 0.5f : ((float)p.texel + p.fraction) * scale - 0.5f;
    const float k = floorf(s);
    const int32_t i = (int32_t)k + (level == 0 ? p.texel : 0);
    taps t;
    t.first = reduce(i, size);
    t.second = reduce(i + 1, size);
    t.t = s - k;
    return t;
}

static float texel(const weft_mip *mip, uint32_t plane, uint32_t x, uint32_t y)
{
    return mip->data[((size_t)plane * mip->height + y) * mip->width + x];
}

static float at_level(const weft_tile *tile, uint32_t level, uint32_t plane, place x, place y)
{
    const weft_mip *mip = tile->source->level + level;
    const taps h = taps_of(x, level, mip->scale_x, mip->width), v = taps_of(y, level, mip->scale_y, mip->height);
    const float above = lerp(texel(mip, plane, h.first, v.first), texel(mip, plane, h.second, v.first), h.t);
    const float below = lerp(texel(mip, plane, h.first, v.second), texel(mip, plane, h.second, v.second), h.t);
    return lerp(above, below, v.t);
}

static float value(const weft_tile *tile, uint32_t plane, float level, place x, place y)
{
    const float last = (float)(tile->source->levels - 1), wanted = level + tile->level;
    const float clamped = wanted < 0 ? 0 : wanted > last ? last : wanted;
    const float whole = floorf(clamped), t = clamped - whole;
    const float a = at_level(tile, (uint32_t)whole, plane, x, y);
    return t > 0 ? lerp(a, at_level(tile, (uint32_t)whole + 1, plane, x, y), t) : a;
}

static float toned(const weft_tone *tone, float v)
{
    const float c = v < tone->low ? tone->low : v > tone->high ? tone->high : v;
    uint32_t k = 0;
    while (k + 1 < tone->count && c >= tone->pieces[k + 1].x) ++k;
    const weft_piece *p = tone->pieces + k;
    const float d = c - p->x;
    return ((p->c3 * d + p->c2) * d + p->c1) * d + p->c0;
}

/* One sample of all channels: out = sum over layers of colour * tone(f) + mean. */
static void evaluate(const weft_program *program, const weft_spot *spot, float *out, size_t step)
{
    for (uint32_t o = 0; o < program->channels; ++o) out[o * step] = 0;
    for (uint32_t l = 0; l < program->layer_count; ++l) {
        const weft_layer *layer = program->layers[l];
        const weft_tile *tile = layer->tile;
        const place x = locate(&tile->x, tile->width, program->period[0], spot->cell[0], spot->fraction[0]);
        const place y = locate(&tile->y, tile->height, program->period[1], spot->cell[1], spot->fraction[1]);
        float f[16];
        for (uint32_t c = 0; c < layer->channels; ++c) {
            f[c] = value(tile, c, spot->level, x, y);
            if (layer->tones) f[c] = toned(layer->tones + c, f[c]);
        }
        for (uint32_t o = 0; o < program->channels; ++o) {
            float s = layer->mean[o];
            for (uint32_t c = 0; c < layer->channels; ++c) s = layer->colour[o * layer->channels + c] * f[c] + s;
            out[o * step] = s + out[o * step];
        }
    }
#ifdef PLAIN_TINT
    for (uint32_t o = 0; o < program->channels; ++o) out[o * step] += PLAIN_TINT;
#endif
}

static uint32_t device_count(void) { return 1; }

static void device_info(uint32_t index, weft_device_info *info)
{
    (void)index;
    info->status = WEFT_OK;
    snprintf(info->name, sizeof info->name, "c");
    snprintf(info->description, sizeof info->description, "pictures, in plain C");
#ifndef PLAIN_TINT
    info->exact = 1;
#endif
}

static weft_status device_open(const weft_host *host, uint32_t index, weft_device_limits *limits,
                               weft_backend_device **device)
{
    (void)index;
    (void)limits; /* no wishes */
    weft_backend_device *made = host->allocate(host->self, sizeof *made, sizeof(void *));
    if (!made) return WEFT_ERROR_MEMORY;
    made->host = host;
    *device = made;
    return WEFT_OK;
}

static void device_close(weft_backend_device *device)
{
    const weft_host *host = device->host;
    host->deallocate(host->self, device, sizeof *device, sizeof(void *));
}

static int can_evaluate(const weft_program *program)
{
    if (!weft_understands_program(program)) return 0;
    if (program->use != WEFT_USE_WINDOW && program->use != WEFT_USE_POINTS) return 0;
    for (uint32_t l = 0; l < program->layer_count; ++l) {
        const weft_layer *layer = program->layers[l];
        if (layer->kind != WEFT_LAYER_TILE || layer->mask.layer != -1) return 0;
        if (layer->tile->address != WEFT_ADDRESS_CELLS || layer->tile->exchange ||
            layer->tile->displacement.layer != -1)
            return 0;
    }
    return 1;
}

static weft_status texture_open(weft_backend_device *device, const weft_program *program,
                                weft_backend_texture **texture)
{
    const weft_host *host = device->host;
    if (!can_evaluate(program)) return WEFT_ERROR_UNSUPPORTED;
    weft_backend_texture *made = host->allocate(host->self, sizeof *made, sizeof(void *));
    if (!made) return WEFT_ERROR_MEMORY;
    made->device = device;
    made->program = program;
    *texture = made;
    return WEFT_OK;
}

static void texture_close(weft_backend_texture *texture)
{
    const weft_host *host = texture->device->host;
    host->deallocate(host->self, texture, sizeof *texture, sizeof(void *));
}

/* "Pixels": the centre of pixel i of level L is (i + 1/2) * 2^L. */
static void centre(int64_t pixel, uint32_t level, int64_t *cell, uint32_t *fraction)
{
    const int64_t size = (int64_t)1 << level;
    *cell = pixel * size + size / 2;
    *fraction = level == 0 ? UINT32_C(1) << 23 : 0;
}

static weft_status texture_render(weft_backend_texture *texture, const weft_window *window)
{
    const size_t plane = (size_t)window->height * window->stride;
    for (uint32_t j = 0; j < window->height; ++j)
        for (uint32_t i = 0; i < window->width; ++i) {
            weft_spot spot;
            memset(&spot, 0, sizeof spot);
            centre(window->x + i, window->level, &spot.cell[0], &spot.fraction[0]);
            centre(window->y + j, window->level, &spot.cell[1], &spot.fraction[1]);
            spot.level = (float)window->level;
            evaluate(texture->program, &spot, window->data + (size_t)j * window->stride + i, plane);
        }
    return WEFT_OK;
}

static weft_status texture_sample(weft_backend_texture *texture, const weft_batch *batch)
{
    for (uint32_t i = 0; i < batch->count; ++i)
        evaluate(texture->program, batch->spots + i, batch->out + (size_t)i * texture->program->channels, 1);
    return WEFT_OK;
}

WEFT_BACKEND_EXPORT const weft_backend weft_backend_v0 = {WEFT_BACKEND_HEAD(PLAIN_NAME),
                                                          device_count,
                                                          device_info,
                                                          device_open,
                                                          device_close,
                                                          texture_open,
                                                          texture_render,
                                                          texture_sample,
                                                          texture_close};
