/* Stains, and colours by the formulas. */
#include "stained.h"
#include <math.h>
#include <stdlib.h>

static double smooth(double low, double high, double x)
{
    const double t = x <= low ? 0 : x >= high ? 1 : (x - low) / (high - low);
    return t * t * (3 - 2 * t);
}

/* How much of the stain is at a place; u and v are 0..1. */
static double amount(Stain stain, double u, double v, double slow)
{
    switch (stain) {
    case STAIN_BLOB: return 1 - smooth(0.12, 0.3, sqrt((u - 0.4) * (u - 0.4) + (v - 0.55) * (v - 0.55)));
    case STAIN_LIGHT: return 0.5 * u + 0.5 * v;
    case STAIN_HALF: return smooth(0.45, 0.55, u + 0.2 * (v - 0.5));
    default: return smooth(-0.3, 0.6, 10 * slow);
    }
}

weft_image new_stained(Stain stain, uint32_t width, uint32_t height, uint64_t seed)
{
    static const float base[3] = {0.55f, 0.5f, 0.42f}, stained[3] = {0.44f, 0.29f, 0.18f};
    static const Grain grains[STAINS] = {GRAIN_SOFT, GRAIN_STREAKS, GRAIN_BAND, GRAIN_SOFT};
    weft_image fine = new_grain(grains[stain], width, height, 3, seed),
               rough = new_grain(GRAIN_BAND, width, height, 1, seed + 1);
    weft_image coarse = new_grain(GRAIN_SOFT, (width + 31) / 32, (height + 31) / 32, 1, seed + 2);
    weft_image image = new_image(width, height, 3, WEFT_FORMAT_F32);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const double slow = (double)value_at(&coarse, x / 32, y / 32, 0) - 0.5;
            const float share = (float)amount(stain, (double)x / width, (double)y / height, slow);
            for (uint32_t c = 0; c < 3; ++c) {
                const float grain = 0.5f * (1 - share) * (value_at(&fine, x, y, c) - 0.5f) +
                                    0.9f * share * (value_at(&rough, x, y, 0) - 0.5f);
                const float value = base[c] + (stained[c] - base[c]) * share + grain;
                values(&image)[((size_t)y * width + x) * 3 + c] = value < 0 ? 0 : value > 1 ? 1 : value;
            }
        }
    free_image(&fine);
    free_image(&rough);
    free_image(&coarse);
    return image;
}

weft_image new_stained_maps(uint32_t width, uint32_t height, uint32_t channels, uint64_t seed)
{
    weft_image colours = new_stained(STAIN_BLOB, width, height, seed),
               image = new_image(width, height, channels, WEFT_FORMAT_F32);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            for (uint32_t c = 0; c < channels; ++c) {
                const float place = (float)(x + 2 * y) / (float)(width + 2 * height),
                            *pixel = &values(&colours)[((size_t)y * width + x) * 3];
                values(&image)[((size_t)y * width + x) * channels + c] =
                    c < 3 ? pixel[c] : (pixel[c % 3] + (float)(c - 2) * place) / (float)c;
            }
    free_image(&colours);
    return image;
}

weft_model *new_tile(weft_context *context, uint32_t width, uint32_t height, uint32_t channels, uint64_t seed)
{
    weft_image photo = new_stained_maps(24, 20, channels, seed);
    weft_stationary_options options = WEFT_STATIONARY_OPTIONS_INIT;
    weft_model *model = NULL;
    options.width = width;
    options.height = height;
    options.patch = 5;
    options.seed = seed;
    assert_ok(weft_analyze_stationary(context, &photo, &options, NULL, NULL, &model));
    free_image(&photo);
    return model;
}

static double decoded(double v) { return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4); }

static double response(double t) { return t > 216.0 / 24389 ? cbrt(t) : (24389.0 / 27 * t + 16) / 116; }

weft_image new_lab(const weft_image *image)
{
    const uint32_t channels = image->channels >= 3 ? 3 : 1;
    weft_image lab = new_image(image->width, image->height, channels, WEFT_FORMAT_F32);
    for (uint32_t y = 0; y < image->height; ++y)
        for (uint32_t x = 0; x < image->width; ++x) {
            float *to = &values(&lab)[((size_t)y * image->width + x) * channels];
            double rgb[3];
            for (uint32_t c = 0; c < 3; ++c) rgb[c] = decoded((double)value_at(image, x, y, channels == 3 ? c : 0));
            const double fx = response((0.4124564 * rgb[0] + 0.3575761 * rgb[1] + 0.1804375 * rgb[2]) / 0.950470);
            const double fy = response(0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.0721750 * rgb[2]);
            const double fz = response((0.0193339 * rgb[0] + 0.1191920 * rgb[1] + 0.9503041 * rgb[2]) / 1.0888300);
            to[0] = (float)(116 * fy - 16);
            if (channels == 3) {
                to[1] = (float)(500 * (fx - fy));
                to[2] = (float)(200 * (fy - fz));
            }
        }
    return lab;
}

double sharpness(const weft_image *lab)
{
    double sum = 0;
    for (uint32_t y = 1; y + 1 < lab->height; ++y)
        for (uint32_t x = 1; x + 1 < lab->width; ++x)
            sum += fabs((double)(4 * value_at(lab, x, y, 0) - value_at(lab, x - 1, y, 0) - value_at(lab, x + 1, y, 0) -
                                 value_at(lab, x, y - 1, 0) - value_at(lab, x, y + 1, 0)));
    return sum / ((double)(lab->width - 2) * (lab->height - 2));
}

static int ascending(const void *left, const void *right)
{
    const float a = *(const float *)left, b = *(const float *)right;
    return (a > b) - (a < b);
}

static float *sorted(const weft_image *image, uint32_t channel)
{
    const size_t area = (size_t)image->width * image->height;
    float *list = malloc(sizeof *list * area);
    assert_non_null(list);
    for (size_t i = 0; i < area; ++i) list[i] = values(image)[i * image->channels + channel];
    qsort(list, area, sizeof *list, ascending);
    return list;
}

double histogram_difference(const weft_image *lab, const weft_image *other)
{
    enum { QUANTILES = 4096 };
    const size_t area = (size_t)lab->width * lab->height, other_area = (size_t)other->width * other->height;
    double sum = 0;
    for (uint32_t c = 0; c < lab->channels; ++c) {
        float *a = sorted(lab, c), *b = sorted(other, c);
        for (size_t i = 0; i < QUANTILES; ++i)
            sum +=
                fabs((double)(a[area * (2 * i + 1) / (2 * QUANTILES)] - b[other_area * (2 * i + 1) / (2 * QUANTILES)]));
        free(a);
        free(b);
    }
    return sum / QUANTILES;
}
