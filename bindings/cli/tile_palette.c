/* The sheet of `weft tile --palette`, sampled as a renderer would. */
#include "command.h"
#include "maps.h"
#include "report.h"
#include "tile.h"

#include <math.h>
#include <stdlib.h>

enum { PANEL = 384, GROUND = 224, GAP = 8, SHEET_HEIGHT = PANEL + GROUND + 3 * GAP };

/* Two by two tiles in a square of PANEL, the longer side filling it; what is beside the shorter one repeats. */
static weft_point flat_point(const weft_model_info* info, int i, int j)
{
    double scale = 2.0 * (info->width > info->height ? info->width : info->height) / PANEL;
    const weft_point point = {(i + 0.5) * scale, (j + 0.5) * scale, {(float)scale, 0}, {0, (float)scale}};
    return point;
}

/* A level plane seen from above: the horizon is the upper edge, and two and a half tiles fill the lower one. */
static weft_point ground_point(const weft_model_info* info, int i, int j)
{
    const double focal = 0.9 * PANEL, height = 2.5 * info->width * GROUND / PANEL;
    double u = i + 0.5 - 0.5 * PANEL, v = j + 0.5;
    const weft_point point = {u * height / v,
                              -focal * height / v,
                              {(float)(height / v), (float)(-u * height / (v * v))},
                              {0, (float)(focal * height / (v * v))}};
    return point;
}

static unsigned char pixel_value(float value)
{
    return (unsigned char)(value <= 0 ? 0 : value >= 1 ? 255 : lroundf(value * 255));
}

/* A row of one panel, `channels` of each value being the texture's. */
static int sample_row(const weft_texture* texture, const weft_point* points, uint32_t channels, float* values,
                      unsigned char* to)
{
    weft_status status = weft_texture_sample(texture, PANEL, points, values);
    if (status != WEFT_OK) return failed_weft(status);
    for (uint32_t i = 0; i < PANEL; i++)
        for (uint32_t c = 0; c < 3; c++) to[3 * i + c] = pixel_value(values[channels * i + (channels >= 3 ? c : 0)]);
    return EXIT_FINE;
}

static int draw_column(const weft_texture* texture, const weft_model_info* info, unsigned char* to, size_t stride)
{
    weft_point points[PANEL];
    float* values = malloc(sizeof(float) * PANEL * info->channels);
    int code = values ? EXIT_FINE : failed("out of memory");
    for (int j = 0; j < PANEL + GROUND && code == EXIT_FINE; j++) {
        int ground = j >= PANEL;
        for (int i = 0; i < PANEL; i++) points[i] = ground ? ground_point(info, i, j - PANEL) : flat_point(info, i, j);
        code = sample_row(texture, points, info->channels, values, to + stride * (size_t)(j + (ground ? 2 : 1) * GAP));
    }
    free(values);
    return code;
}

static int draw_tile(weft_context* context, const weft_model* model, unsigned char* to, size_t stride)
{
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    weft_texture* texture = NULL;
    weft_status status = weft_model_get(model, &info);
    if (status == WEFT_OK) status = weft_texture_create(context, model, NULL, &texture);
    int code = status == WEFT_OK ? draw_column(texture, &info, to, stride) : failed_weft(status);
    weft_texture_free(texture);
    return code;
}

int write_palette(weft_context* context, const tile_result* tiles, uint32_t count, const char* path)
{
    weft_image sheet = {NULL, 0, count * (PANEL + GAP) + GAP, SHEET_HEIGHT, 3, WEFT_FORMAT_U8};
    sheet.stride = 3 * (int64_t)sheet.width;
    sheet.data = calloc((size_t)sheet.stride, sheet.height);
    int code = sheet.data ? EXIT_FINE : failed("out of memory");
    for (uint32_t i = 0; i < count && code == EXIT_FINE; i++)
        code = draw_tile(context, tiles[i].model, (unsigned char*)sheet.data + 3 * (i * (PANEL + GAP) + GAP),
                         (size_t)sheet.stride);
    if (code == EXIT_FINE) code = maps_write(path, &sheet, &sheet.channels, 1);
    free(sheet.data);
    return code;
}
