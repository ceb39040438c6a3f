/* The golden views: which models are rendered how. The checksums of their pixels are in data/golden.txt. */
#ifndef WEFT_TESTS_GOLDEN_H
#define WEFT_TESTS_GOLDEN_H

#include "support.h"
#include <stdio.h>
#include <stdlib.h>

static const char *const golden_models[] = {"linear_rgb",   "nearest_grey",    "cubic_rgb", "quintic_grey",
                                            "linear_16",    "picture_rgb",     "picture_5", "tile_rgb",
                                            "bilayer_wang", "bilayer_exchange"};
#define GOLDEN_MODELS (sizeof golden_models / sizeof *golden_models)

typedef struct Golden_view {
    float impacts;
    uint64_t seed;
    uint32_t period; /* in both directions; for a picture in pictures */
    int64_t x, y;
    uint32_t level, width, height;
} Golden_view;

static const Golden_view golden_views[] = {
    {0, 0, 0, 0, 0, 0, 64, 48},
    {1, 7, 0, -37, -91, 0, 33, 21},
    {100, UINT64_C(0xfedcba9876543210), 0, 5, 977, 1, 40, 24},
    {30, 3, 0, INT64_C(1) << 40, -(INT64_C(1) << 40), 0, 50, 30},
    {30, 3, 96, -5, 90, 0, 50, 30},
    {1000, 11, 0, 3, 4, 0, 12, 8},
    {30, 12, 0, -8, 8, 3, 31, 17},
};
#define GOLDEN_VIEWS (sizeof golden_views / sizeof *golden_views)

/* The model of that name from the data folder. */
static inline weft_model *golden_model(weft_context *context, const char *folder, const char *name)
{
    char path[1024];
    size_t size = 0;
    weft_model *model = NULL;
    snprintf(path, sizeof path, "%s/%s.weft", folder, name);
    void *bytes = read_file(path, &size);
    assert_non_null(bytes);
    assert_ok(weft_model_load(context, bytes, size, &model));
    free(bytes);
    return model;
}

/* Checksum of a view's window, and of points at and around its centre whose footprints need probes and two levels. */
static inline uint64_t golden_checksum(weft_context *context, const weft_model *model, const Golden_view *view)
{
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    weft_texture *texture = NULL;
    weft_point points[40];
    float out[40 * 16];
    assert_ok(weft_model_get(model, &info));
    const int picture = info.method == WEFT_METHOD_PICTURE || info.method == WEFT_METHOD_STATIONARY;
    options.impacts = view->impacts;
    options.seed = view->seed;
    options.period_x = picture && view->period ? 2 * info.width : view->period;
    options.period_y = picture && view->period ? 3 * info.height : view->period;
    assert_ok(weft_texture_create(context, model, &options, &texture));
    weft_image image = rendered(texture, view->x, view->y, view->level, view->width, view->height, info.channels);
    const uint64_t pixels = checksum(image.data, image_bytes(&image));
    for (int i = 0; i < 40; ++i) {
        const weft_point point = {(double)view->x + 0.37 * i,
                                  (double)view->y - 0.81 * i,
                                  {0.25f * (float)i, 0.5f},
                                  {-0.125f, 0.0625f * (float)i}};
        points[i] = point;
    }
    assert_ok(weft_texture_sample(texture, 40, points, out));
    weft_texture_free(texture);
    free_image(&image);
    return pixels ^ (checksum(out, sizeof *out * 40 * info.channels) << 1);
}

#endif
