/* A sheet that shows a model: labelled panels that fill rows from left to right. */
#ifndef WEFT_CLI_SHEET_H
#define WEFT_CLI_SHEET_H

#include "canvas.h"

#include <weft/weft.h>

enum { SHEET_MARGIN = 24, SHEET_GAP = 16, PANEL = 512, SHEET_CONTENT = 3 * PANEL + 2 * SHEET_GAP };

typedef struct sheet {
    canvas canvas;
    uint32_t x, y, bottom; /* where the next panel goes; where the next row begins */
    int code;              /* EXIT_FINE, or that of the first failure: nothing is drawn after it */
    weft_context* context;
    const weft_model* model;
    weft_model_info info;
    weft_image photo;     /* data NULL: none */
    weft_image output[3]; /* what is shown of the texture, 8 bits */
    const char* name[3];  /* of these */
    uint32_t outputs;
} sheet;

/* Room for a panel with its label above: in this row if it fits, else in a new one. */
rectangle sheet_panel(sheet* s, uint32_t width, uint32_t height, const char* format, ...)
    __attribute__((format(printf, 4, 5)));

/* The next panel begins a row. */
void sheet_row(sheet* s);

void sheet_heading(sheet* s, const char* title, const char* line);

/* An image at 100 %, its middle where it is larger than a panel. */
void sheet_image(sheet* s, const weft_image* image, const char* name);

/* A window of a texture in 8 bits, its middle at the middle of the panel at level 0; the caller frees the image's data.
 */
void sheet_render(sheet* s, const weft_model* model, const weft_texture_options* options, uint32_t level,
                  uint32_t width, uint32_t height, weft_image* image);

/* Remembers what went wrong. */
void sheet_check(sheet* s, weft_status status);

/* Memory of that many bytes, or NULL and a failure. */
void* sheet_memory(sheet* s, size_t size);

/* Where the sheet lies and how large it is, as JSON. */
void sheet_report(const sheet* s, const char* output);

int sheet_is_mixed(const sheet* s);

/* What a model holds, method by method. */
void sheet_model(sheet* s);

/* Spectra and histograms of photo and output. */
void sheet_measures(sheet* s);

#endif
