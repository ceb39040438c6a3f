/* Parts of models as values; spectra of textons by a plain transform, colours of patches by their hash. */
#include "bilayer_parts.h"
#include "command.h"
#include "report.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int read_part(const weft_model* model, uint32_t index, weft_part_info* part, weft_image* image)
{
    const weft_part_info start = WEFT_PART_INFO_INIT;
    *part = start;
    image->data = NULL;
    weft_status status = weft_model_part(model, index, part);
    if (status != WEFT_OK) return failed_weft(status);
    const weft_image values = {malloc(sizeof(float) * part->width * part->height * part->channels),
                               0,
                               part->width,
                               part->height,
                               part->channels,
                               WEFT_FORMAT_F32};
    *image = values;
    if (!image->data) return failed("out of memory");
    status = weft_model_part_read(model, index, image);
    return status == WEFT_OK ? EXIT_FINE : failed_weft(status);
}

uint32_t find_part(const weft_model* model, const weft_model_info* info, const char* name)
{
    uint32_t index = 0;
    for (; index < info->parts; index++) {
        weft_part_info part = WEFT_PART_INFO_INIT;
        if (weft_model_part(model, index, &part) == WEFT_OK && strcmp(part.name, name) == 0) break;
    }
    return index;
}

int has_spectrum(const weft_model_info* info, const weft_part_info* part)
{
    return info->method == WEFT_METHOD_BILAYER && strncmp(part->name, "texton ", 7) == 0;
}

typedef struct number {
    double re, im;
} number;

/* One line's transform by its definition; roots: the count-th roots of unity. */
static void transform(number* line, size_t step, uint32_t count, const number* roots, number* room)
{
    for (uint32_t k = 0; k < count; k++) {
        number sum = {0, 0};
        for (uint32_t i = 0, turn = 0; i < count; i++, turn = (turn + k) % count) {
            const number v = line[i * step], w = roots[turn];
            sum.re += v.re * w.re - v.im * w.im;
            sum.im += v.re * w.im + v.im * w.re;
        }
        room[k] = sum;
    }
    for (uint32_t k = 0; k < count; k++) line[k * step] = room[k];
}

static void find_roots(number* roots, uint32_t count)
{
    const double turn = 6.283185307179586;
    for (uint32_t i = 0; i < count; i++) {
        roots[i].re = cos(turn * i / count);
        roots[i].im = -sin(turn * i / count);
    }
}

static void transform_both(number* values, uint32_t width, uint32_t height, number* roots, number* room)
{
    find_roots(roots, width);
    for (uint32_t y = 0; y < height; y++) transform(values + (size_t)y * width, 1, width, roots, room);
    find_roots(roots, height);
    for (uint32_t x = 0; x < width; x++) transform(values + x, width, height, roots, room);
}

/* Makes a channel's powers, which become logarithms; no less than a millionth of the greatest. */
static void show_powers(const number* values, uint32_t channel, const weft_image* spectrum)
{
    const uint32_t width = spectrum->width, height = spectrum->height;
    const size_t area = (size_t)width * height;
    double most = 1e-30;
    for (size_t i = 0; i < area; i++) most = fmax(most, values[i].re * values[i].re + values[i].im * values[i].im);
    for (size_t i = 0; i < area; i++) {
        const size_t x = (i % width + width / 2) % width, y = (i / width + height / 2) % height;
        const double power = values[i].re * values[i].re + values[i].im * values[i].im;
        ((float*)spectrum->data)[(y * width + x) * spectrum->channels + channel] =
            (float)log10(fmax(power, most * 1e-6));
    }
}

static void set_range(const weft_image* image, weft_part_info* part)
{
    const float* values = image->data;
    const size_t count = (size_t)image->width * image->height * image->channels;
    part->low = part->high = values[0];
    for (size_t i = 1; i < count; i++) {
        part->low = fminf(part->low, values[i]);
        part->high = fmaxf(part->high, values[i]);
    }
}

int spectrum_of(const weft_image* texton, weft_part_info* part, weft_image* spectrum)
{
    const size_t area = (size_t)texton->width * texton->height, longer = texton->width + texton->height;
    char digits[sizeof part->name];
    *spectrum = *texton;
    spectrum->data = malloc(sizeof(float) * area * texton->channels);
    number* room = malloc(sizeof(number) * (area + 2 * longer));
    if (!spectrum->data || !room) {
        free(room);
        return failed("out of memory");
    }
    for (uint32_t c = 0; c < texton->channels; c++) {
        for (size_t i = 0; i < area; i++) {
            const number value = {(double)((const float*)texton->data)[i * texton->channels + c], 0};
            room[i] = value;
        }
        transform_both(room, texton->width, texton->height, room + area, room + area + longer);
        show_powers(room, c, spectrum);
    }
    free(room);
    snprintf(digits, sizeof digits, "%s", strchr(part->name, ' ') + 1);
    snprintf(part->name, sizeof part->name, "spectrum %.8s", digits);
    set_range(spectrum, part);
    return EXIT_FINE;
}

int colours_of(const weft_image* patches, weft_image* colours)
{
    const size_t area = (size_t)patches->width * patches->height;
    unsigned char* rgb = malloc(area * 3);
    const weft_image made = {rgb, 0, patches->width, patches->height, 3, WEFT_FORMAT_U8};
    *colours = made;
    if (!rgb) return failed("out of memory");
    for (size_t i = 0; i < area; i++) {
        uint32_t hash = ((uint32_t)((const float*)patches->data)[i] + 1) * 0x9e3779b1u;
        hash ^= hash >> 15;
        hash *= 0x85ebca6bu;
        for (uint32_t c = 0; c < 3; c++) rgb[i * 3 + c] = (unsigned char)(64 + (hash >> (8 * c + 4) & 255) * 3 / 4);
    }
    return EXIT_FINE;
}
