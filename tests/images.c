/* Images of the tests: owned pixels, comparison, synthetic exemplars. */
#include "support.h"
#include <stdlib.h>
#include <string.h>

static size_t bytes_per_value(weft_format format)
{
    return format == WEFT_FORMAT_U8 ? 1 : format == WEFT_FORMAT_U16 ? 2 : 4;
}

weft_image new_image(uint32_t width, uint32_t height, uint32_t channels, weft_format format)
{
    weft_image image = {NULL, 0, width, height, channels, format};
    image.data = calloc(image_bytes(&image), 1);
    assert_non_null(image.data);
    return image;
}

void free_image(weft_image *image)
{
    free(image->data);
    image->data = NULL;
}

size_t image_bytes(const weft_image *image)
{
    return (size_t)image->width * image->height * image->channels * bytes_per_value(image->format);
}

float *values(const weft_image *image) { return image->data; }

float value_at(const weft_image *image, uint32_t x, uint32_t y, uint32_t channel)
{
    return values(image)[((size_t)y * image->width + x) * image->channels + channel];
}

void fill_bytes(const weft_image *image, int byte) { memset(image->data, byte, image_bytes(image)); }

int all_bytes(const weft_image *image, int byte)
{
    const unsigned char *bytes = image->data;
    for (size_t i = 0; i < image_bytes(image); ++i)
        if (bytes[i] != byte) return 0;
    return 1;
}

int same_pixels(const weft_image *a, const weft_image *b)
{
    return image_bytes(a) == image_bytes(b) && memcmp(a->data, b->data, image_bytes(a)) == 0;
}

void assert_same_pixels_at(const weft_image *a, const weft_image *b, const char *what, const char *file, int line)
{
    if (same_pixels(a, b)) return;
    size_t different = 0, first = 0;
    const size_t step = bytes_per_value(a->format), count = image_bytes(a) / step;
    for (size_t i = count; i-- > 0;)
        if (memcmp((const char *)a->data + i * step, (const char *)b->data + i * step, step) != 0) {
            ++different;
            first = i;
        }
    const size_t pixel = first / a->channels;
    print_error("%s: %zu of %zu values differ, first at (%zu, %zu) channel %zu", what, different, count,
                pixel % a->width, pixel / a->width, first % a->channels);
    if (a->format == WEFT_FORMAT_F32)
        print_error(": %.9g and %.9g", (double)values(a)[first], (double)values(b)[first]);
    print_error("\n");
    _fail(file, line);
}

/* One pass of (1, 2, 1) / 4 along an axis of a torus. */
static void soften(float *plane, float *scratch, uint32_t width, uint32_t height, int along_x)
{
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const uint32_t left = along_x ? y * width + (x + width - 1) % width : (y + height - 1) % height * width + x;
            const uint32_t right = along_x ? y * width + (x + 1) % width : (y + 1) % height * width + x;
            scratch[y * width + x] = 0.25f * plane[left] + 0.5f * plane[y * width + x] + 0.25f * plane[right];
        }
    memcpy(plane, scratch, sizeof *plane * width * height);
}

/* Streaks run along x; the band lies between two blurs. */
static void filter_grain(Grain grain, float *plane, float *scratch, float *other, uint32_t width, uint32_t height)
{
    const int along_x = grain == GRAIN_STREAKS ? 12 : grain == GRAIN_WHITE ? 0 : 3;
    const int along_y = grain == GRAIN_STREAKS ? 1 : grain == GRAIN_WHITE ? 0 : 3;
    for (int i = 0; i < along_x; ++i) soften(plane, scratch, width, height, 1);
    for (int i = 0; i < along_y; ++i) soften(plane, scratch, width, height, 0);
    if (grain != GRAIN_BAND) return;
    memcpy(other, plane, sizeof *plane * width * height);
    for (int i = 0; i < 6; ++i) soften(other, scratch, width, height, 1);
    for (int i = 0; i < 6; ++i) soften(other, scratch, width, height, 0);
    for (uint32_t i = 0; i < width * height; ++i) plane[i] -= other[i];
}

/* Newton's iteration: the C library's root is left alone so that exemplars never depend on a flag. */
static double root_of(double square)
{
    double root = square > 1 ? square : 1;
    for (int i = 0; i < 60; ++i) root = 0.5 * (root + square / root);
    return root;
}

static void standardise(float *plane, uint32_t count)
{
    double sum = 0, squares = 0;
    for (uint32_t i = 0; i < count; ++i) sum += (double)plane[i];
    const double mean = sum / count;
    for (uint32_t i = 0; i < count; ++i) squares += ((double)plane[i] - mean) * ((double)plane[i] - mean);
    const double scale = squares > 0 ? 1 / root_of(squares / count) : 0;
    for (uint32_t i = 0; i < count; ++i) plane[i] = (float)(((double)plane[i] - mean) * scale);
}

/* Channel c is 0.8 of the first plane and 0.6 of its own: correlated, as the channels of a photo are. */
weft_image new_grain(Grain grain, uint32_t width, uint32_t height, uint32_t channels, uint64_t seed)
{
    const uint32_t area = width * height;
    weft_image image = new_image(width, height, channels, WEFT_FORMAT_F32);
    float *memory = malloc(sizeof *memory * area * 4), *first = memory, *plane = memory + area,
          *scratch = memory + 2 * (size_t)area;
    assert_non_null(memory);
    Random random = {seed};
    for (uint32_t c = 0; c < channels; ++c) {
        for (uint32_t i = 0; i < area; ++i) plane[i] = (float)random_normal(&random);
        filter_grain(grain, plane, scratch, scratch + area, width, height);
        standardise(plane, area);
        if (c == 0) memcpy(first, plane, sizeof *plane * area);
        for (uint32_t i = 0; i < area; ++i)
            values(&image)[(size_t)i * channels + c] =
                0.5f + 0.1f * (c == 0 ? first[i] : 0.8f * first[i] + 0.6f * plane[i]);
    }
    free(memory);
    return image;
}
