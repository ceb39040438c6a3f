/* Drawing: pixels, rectangles, lines, images. */
#include "canvas.h"
#include "command.h"
#include "maps.h"
#include "report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int canvas_grow(canvas* c, uint32_t height)
{
    const size_t row = (size_t)c->width * 3;
    if (height > c->room) {
        uint32_t room = height + height / 2;
        uint8_t* larger = realloc(c->rgb, row * room);
        if (!larger) return failed("out of memory");
        memset(larger + row * c->room, 255, row * (room - c->room));
        c->rgb = larger;
        c->room = room;
    }
    if (height > c->height) c->height = height;
    return EXIT_FINE;
}

void canvas_free(canvas* c) { free(c->rgb); }

void canvas_blend(canvas* c, int64_t x, int64_t y, uint32_t colour, float opacity)
{
    if (x < 0 || y < 0 || x >= c->width || y >= c->height) return;
    uint8_t* pixel = c->rgb + ((size_t)y * c->width + (size_t)x) * 3;
    for (int i = 0; i < 3; i++) {
        const float wanted = (float)(colour >> (16 - 8 * i) & 255), old = pixel[i];
        pixel[i] = (uint8_t)lrintf(old + (wanted - old) * opacity);
    }
}

void canvas_fill(canvas* c, rectangle area, uint32_t colour, float opacity)
{
    for (uint32_t y = 0; y < area.height; y++)
        for (uint32_t x = 0; x < area.width; x++) canvas_blend(c, area.x + x, area.y + y, colour, opacity);
}

static float distance_to_segment(float x, float y, float dx, float dy)
{
    const float length = dx * dx + dy * dy;
    float t = length > 0 ? (x * dx + y * dy) / length : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return hypotf(x - t * dx, y - t * dy);
}

void canvas_line(canvas* c, float x0, float y0, float x1, float y1, float thickness, uint32_t colour)
{
    const float reach = thickness / 2 + 1;
    const int64_t left = (int64_t)floorf(fminf(x0, x1) - reach), right = (int64_t)ceilf(fmaxf(x0, x1) + reach);
    const int64_t top = (int64_t)floorf(fminf(y0, y1) - reach), bottom = (int64_t)ceilf(fmaxf(y0, y1) + reach);
    for (int64_t y = top; y <= bottom; y++)
        for (int64_t x = left; x <= right; x++) {
            const float distance = distance_to_segment((float)x + 0.5f - x0, (float)y + 0.5f - y0, x1 - x0, y1 - y0);
            const float cover = thickness / 2 + 0.5f - distance;
            if (cover > 0) canvas_blend(c, x, y, colour, cover < 1 ? cover : 1);
        }
}

static float value_at(const weft_image* image, uint32_t x, uint32_t y, uint32_t channel)
{
    const uint32_t bytes = image->format == WEFT_FORMAT_F32 ? 4 : image->format == WEFT_FORMAT_U16 ? 2 : 1;
    const int64_t stride = image->stride ? image->stride : (int64_t)bytes * image->channels * image->width;
    const char* at = (const char*)image->data + stride * y + (size_t)bytes * ((size_t)x * image->channels + channel);
    uint16_t wide;
    float real;
    memcpy(&wide, at, bytes == 2 ? 2 : 0);
    memcpy(&real, at, bytes == 4 ? 4 : 0);
    return bytes == 4 ? real : bytes == 2 ? (float)wide / 65535 : (float)*(const uint8_t*)at / 255;
}

static uint32_t colour_at(const weft_image* image, uint32_t x, uint32_t y, tones range)
{
    uint32_t colour = 0;
    for (uint32_t i = 0; i < 3; i++) {
        const float value = value_at(image, x, y, image->channels < 3 ? 0 : i);
        const float shown = range.high > range.low ? (value - range.low) / (range.high - range.low) : 0;
        colour = colour << 8 | (uint32_t)lrintf(255 * (shown < 0 ? 0 : shown > 1 ? 1 : shown));
    }
    return colour;
}

void canvas_image(canvas* c, rectangle area, const weft_image* image, uint32_t scale, tones range)
{
    const uint32_t columns = area.width / scale < image->width ? area.width / scale : image->width;
    const uint32_t rows = area.height / scale < image->height ? area.height / scale : image->height;
    const uint32_t from_x = (image->width - columns) / 2, from_y = (image->height - rows) / 2;
    for (uint32_t y = 0; y < rows; y++)
        for (uint32_t x = 0; x < columns; x++) {
            const rectangle dot = {area.x + x * scale, area.y + y * scale, scale, scale};
            canvas_fill(c, dot, colour_at(image, from_x + x, from_y + y, range), 1);
        }
}

int canvas_write(const canvas* c, const char* path)
{
    const uint32_t channels = 3;
    const weft_image image = {c->rgb, (int64_t)c->width * 3, c->width, c->height, channels, WEFT_FORMAT_U8};
    map_files maps;
    int code = maps_open(&maps, path, &channels, 1, &image);
    if (code == EXIT_FINE) code = maps_rows(&maps, &image);
    if (code == EXIT_FINE) code = maps_commit(&maps);
    maps_discard(&maps);
    return code;
}
