/* One plug-in, compiled once for each way in which a plug-in can be wrong, and for a few in which it is right.
 *
 * It offers one device that paints each pixel with the colour of the first layer's mean: enough to see that libweft
 * asks it, and written against backend.h alone. What differs comes from the macros WEFT_STUB_*. */
#include <stdlib.h>
#include <string.h>
#include <weft/backend.h>

#ifndef WEFT_STUB_NAME
#define WEFT_STUB_NAME "good"
#endif
#ifndef WEFT_STUB_MAGIC
#define WEFT_STUB_MAGIC WEFT_BACKEND_MAGIC
#endif
#ifndef WEFT_STUB_SIZE
#define WEFT_STUB_SIZE sizeof(weft_backend)
#endif
#ifndef WEFT_STUB_MAJOR
#define WEFT_STUB_MAJOR WEFT_BACKEND_MAJOR
#endif
#ifndef WEFT_STUB_MINOR
#define WEFT_STUB_MINOR WEFT_BACKEND_MINOR
#endif

struct weft_backend_device {
    const weft_host *host;
};

struct weft_backend_texture {
    weft_backend_device *device;
    uint32_t channels;
    float mean[16];
};

static uint32_t device_count(void)
{
#ifdef WEFT_STUB_NO_DEVICE
    return 0;
#else
    return 1;
#endif
}

static void device_info(uint32_t index, weft_device_info *info)
{
    (void)index;
#ifdef WEFT_STUB_SICK
    info->status = WEFT_ERROR_DEVICE;
    strcpy(info->description, "this device has a cold");
#else
    info->status = WEFT_OK;
    strcpy(info->description, "paints the mean");
#endif
    info->exact = 0;
}

static weft_status device_open(const weft_host *host, uint32_t index, weft_device_limits *limits,
                               weft_backend_device **device)
{
    (void)index;
    weft_backend_device *made = host->allocate(host->self, sizeof *made, sizeof(void *));
    if (!made) return WEFT_ERROR_MEMORY;
    made->host = host;
    limits->concurrency = 1;
    limits->window_width = 48;
    limits->window_height = 16;
    *device = made;
    return WEFT_OK;
}

static void device_close(weft_backend_device *device)
{
    device->host->deallocate(device->host->self, device, sizeof *device, sizeof(void *));
}

#ifdef WEFT_STUB_LATTICE
/* Mean square, over all positions, of the quadratic spline surface whose coefficients are the band's lattice, which is
 * a torus: the spline's products at lags -2..2 in both directions. */
static float mean_square(const weft_band *band)
{
    static const double product[5] = {1.0 / 120, 26.0 / 120, 66.0 / 120, 26.0 / 120, 1.0 / 120};
    const uint32_t width = band->width, height = band->height;
    double sum = 0;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            for (uint32_t j = 0; j < 5; ++j)
                for (uint32_t i = 0; i < 5; ++i) {
                    const size_t other = (size_t)((y + height + j - 2) % height) * width + (x + width + i - 2) % width;
                    sum += product[j] * product[i] * (double)band->lattice[(size_t)y * width + x] *
                           (double)band->lattice[other];
                }
    return (float)(sum / ((double)width * height));
}

/* In place of the colours, of the first plane's coarsest band: the variance of its lattice, and what the weight makes
 * of it. */
static void read_lattice(const weft_layer *layer, float *mean)
{
    const weft_band *band = &layer->bands->bands[(size_t)(layer->bands->count - 1) * layer->planes];
    mean[0] = mean_square(band);
    mean[1] = mean[0] * band->weight * band->weight;
}
#endif

static weft_status texture_open(weft_backend_device *device, const weft_program *program,
                                weft_backend_texture **texture)
{
    if (!weft_understands_program(program)) return WEFT_ERROR_UNSUPPORTED;
#ifdef WEFT_STUB_PICKY
    (void)device;
    (void)texture;
    return WEFT_ERROR_UNSUPPORTED;
#else
    weft_backend_texture *made = device->host->allocate(device->host->self, sizeof *made, sizeof(void *));
    if (!made) return WEFT_ERROR_MEMORY;
    made->device = device;
    made->channels = program->channels;
    for (uint32_t c = 0; c < program->channels; ++c) made->mean[c] = program->layers[0]->mean[c];
#ifdef WEFT_STUB_LATTICE
    if (program->layers[0]->bands && made->channels > 1) read_lattice(program->layers[0], made->mean);
#endif
    *texture = made;
    return WEFT_OK;
#endif
}

static weft_status texture_render(weft_backend_texture *texture, const weft_window *window)
{
#ifdef WEFT_STUB_FAILS
    (void)window;
    texture->device->host->error(texture->device->host->self, "the brush is broken");
    return WEFT_ERROR_DEVICE;
#else
    for (uint32_t c = 0; c < texture->channels; ++c)
        for (uint32_t y = 0; y < window->height; ++y)
            for (uint32_t x = 0; x < window->width; ++x)
                window->data[((size_t)c * window->height + y) * window->stride + x] = texture->mean[c];
    return WEFT_OK;
#endif
}

static weft_status texture_sample(weft_backend_texture *texture, const weft_batch *batch)
{
    for (uint32_t i = 0; i < batch->count; ++i)
        memcpy(batch->out + (size_t)i * texture->channels, texture->mean, sizeof(float) * texture->channels);
    return WEFT_OK;
}

#ifdef WEFT_STUB_HOLE
#define TEXTURE_CLOSE NULL
#else
#define TEXTURE_CLOSE texture_close
static void texture_close(weft_backend_texture *texture)
{
    const weft_host *host = texture->device->host;
    host->deallocate(host->self, texture, sizeof *texture, sizeof(void *));
}
#endif

#ifdef WEFT_STUB_NAMELESS
#define NAME NULL
#else
#define NAME WEFT_STUB_NAME
#endif

#define TABLE                                                                                                          \
    {                                                                                                                  \
        WEFT_STUB_MAGIC, WEFT_STUB_SIZE, WEFT_STUB_MAJOR, WEFT_STUB_MINOR, NAME, device_count, device_info,            \
            device_open, device_close, texture_open, texture_render, texture_sample, TEXTURE_CLOSE                     \
    }

#if defined(WEFT_STUB_SYMBOL)
WEFT_BACKEND_VISIBLE extern const weft_backend another_symbol;
const weft_backend another_symbol = TABLE;
#elif defined(WEFT_STUB_LONGER)
/* As a later minor version would lay it out: our table, then entries that today's libweft does not know. */
typedef struct Longer_backend {
    weft_backend known;
    void (*later)(void);
    uint32_t number;
} Longer_backend;
WEFT_BACKEND_VISIBLE extern const Longer_backend longer __asm__("weft_backend_v0");
const Longer_backend longer = {TABLE, abort, 77};
#else
WEFT_BACKEND_EXPORT const weft_backend weft_backend_v0 = TABLE;
#endif
