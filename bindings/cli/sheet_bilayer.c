/* Bi-layer models drawn: the layers, then a row of masks, textons and spectra for each kind. */
#include "sheet_bilayer.h"
#include "bilayer_parts.h"
#include "command.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NOISES = 6, EDGE = (SHEET_CONTENT - (MOST_NOISES - 1) * SHEET_GAP) / MOST_NOISES };

static const weft_image no_image = {NULL, 0, 0, 0, 0, 0};

/* Reads the part of that name; 0 if there is none or reading failed. */
static int read_named(sheet* s, const char* name, weft_part_info* part, weft_image* values)
{
    *values = no_image;
    if (s->code != EXIT_FINE) return 0;
    const uint32_t index = find_part(s->model, &s->info, name);
    if (index == s->info.parts) return 0;
    s->code = read_part(s->model, index, part, values);
    return s->code == EXIT_FINE;
}

void sheet_named_part(sheet* s, const char* name, tones range)
{
    weft_part_info part;
    weft_image values;
    if (read_named(s, name, &part, &values)) {
        const rectangle at = sheet_panel(s, PANEL, PANEL, "%s, %u x %u", name, part.width, part.height);
        if (s->code == EXIT_FINE) canvas_image(&s->canvas, at, &values, 1, range);
    }
    free(values.data);
}

static void show_patches(sheet* s)
{
    const tones plain = {0, 1};
    weft_part_info part;
    weft_image values, colours = no_image;
    if (read_named(s, "patches", &part, &values) && (s->code = colours_of(&values, &colours)) == EXIT_FINE) {
        const rectangle at = sheet_panel(s, PANEL, PANEL, "%.0f patches", (double)part.high + 1);
        if (s->code == EXIT_FINE) canvas_image(&s->canvas, at, &colours, 1, plain);
    }
    free(colours.data);
    free(values.data);
}

/* In a small panel, enlarged as far as whole pixels allow. */
static void show_small(sheet* s, const weft_image* image, const char* name, tones range)
{
    const uint32_t longer = image->width > image->height ? image->width : image->height;
    const rectangle at = sheet_panel(s, EDGE, EDGE, "%s", name);
    if (s->code == EXIT_FINE) canvas_image(&s->canvas, at, image, longer < EDGE ? EDGE / longer : 1, range);
}

static void show_mask(sheet* s, const char* name)
{
    const tones plain = {0, 1};
    weft_part_info part;
    weft_image values;
    if (read_named(s, name, &part, &values)) show_small(s, &values, name, plain);
    free(values.data);
}

static void show_texton(sheet* s, const char* name)
{
    weft_part_info part;
    weft_image values;
    if (read_named(s, name, &part, &values)) {
        const tones range = {part.low, part.high};
        show_small(s, &values, name, range);
    }
    free(values.data);
}

static void show_spectrum(sheet* s, const char* name)
{
    weft_part_info part;
    weft_image values, spectrum = no_image;
    if (read_named(s, name, &part, &values) && (s->code = spectrum_of(&values, &part, &spectrum)) == EXIT_FINE) {
        const tones range = {part.high - 6, part.high};
        show_small(s, &spectrum, part.name, range);
    }
    free(spectrum.data);
    free(values.data);
}

/* A row of what each noise has. */
static void show_row(sheet* s, const char* kind, void (*show)(sheet* s, const char* name))
{
    sheet_row(s);
    for (uint32_t k = 0; k < MOST_NOISES; k++) {
        char name[32];
        snprintf(name, sizeof name, "%s %u", kind, k);
        show(s, name);
    }
}

void sheet_bilayer(sheet* s)
{
    const tones plain = {0, 1}, around_zero = {-0.5f, 0.5f};
    sheet_row(s);
    sheet_named_part(s, "structure", plain);
    sheet_named_part(s, "noise", around_zero);
    show_patches(s);
    show_row(s, "mask", show_mask);
    show_row(s, "texton", show_texton);
    show_row(s, "texton", show_spectrum);
    sheet_row(s);
}
