/* What a model holds, drawn: the panels of each method. */
#include "command.h"
#include "sheet.h"
#include "sheet_bilayer.h"
#include "sheet_wavelet.h"

#include <stdlib.h>

/* A part as large as whole pixels allow within a square, its least value black and its greatest white. */
static void show_part(sheet* s, uint32_t index, uint32_t edge)
{
    weft_part_info part = WEFT_PART_INFO_INIT;
    if (s->code == EXIT_FINE) sheet_check(s, weft_model_part(s->model, index, &part));
    if (s->code != EXIT_FINE) return;
    const uint32_t longer = part.width > part.height ? part.width : part.height;
    const uint32_t scale = longer < edge ? edge / longer : 1;
    const tones range = {part.low, part.high};
    const weft_image image = {sheet_memory(s, sizeof(float) * part.width * part.height * part.channels),
                              0,
                              part.width,
                              part.height,
                              part.channels,
                              WEFT_FORMAT_F32};
    if (s->code == EXIT_FINE) sheet_check(s, weft_model_part_read(s->model, index, &image));
    const rectangle at = sheet_panel(s, edge, edge, "%s, %u %%", part.name, scale * 100);
    if (s->code == EXIT_FINE) canvas_image(&s->canvas, at, &image, scale, range);
    free(image.data);
}

/* Some steps of a mixed model, and the texture as it goes from the first to the last. */
static void show_mixture(sheet* s)
{
    enum {
        SHOWN = 7,
        EDGE = (SHEET_CONTENT - (SHOWN - 1) * SHEET_GAP) / SHOWN,
        HEIGHT = 256,
        SPARE = 128,
        MAP = SHEET_CONTENT + 2 * SPARE
    };
    const tones plain = {0, 1};
    const uint32_t last = s->info.parts - 1, shown = last < SHOWN ? last + 1 : SHOWN;
    float ramp[MAP];
    weft_image image = {NULL, 0, 0, 0, 0, 0};
    const weft_image map = {ramp, 0, MAP, 1, 1, WEFT_FORMAT_F32};
    weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    sheet_row(s);
    for (uint32_t i = 0; i < shown; i++) show_part(s, (i * last + (shown - 1) / 2) / (shown - 1), EDGE);
    /* The map repeats: impacts beside the picture find its first step on the left and its last on the right. */
    for (uint32_t x = 0; x < MAP; x++) ramp[x] = x < SHEET_CONTENT ? (float)x / SHEET_CONTENT : x < MAP - SPARE ? 1 : 0;
    options.mix = &map;
    options.seed = 1;
    const rectangle at = sheet_panel(s, SHEET_CONTENT, HEIGHT, "from the first step on the left to the last");
    sheet_render(s, s->model, &options, 0, SHEET_CONTENT, HEIGHT, &image);
    if (s->code == EXIT_FINE) canvas_image(&s->canvas, at, &image, 1, plain);
    free(image.data);
}

/* A further method adds its line. Any other model shows its parts as they are. */
static const struct {
    weft_method method;
    void (*show)(sheet* s);
} methods[] = {{WEFT_METHOD_WAVELET, sheet_wavelet}, {WEFT_METHOD_BILAYER, sheet_bilayer}};

void sheet_model(sheet* s)
{
    for (size_t i = 0; i < sizeof methods / sizeof methods[0]; i++)
        if (methods[i].method == s->info.method) {
            methods[i].show(s);
            return;
        }
    if (sheet_is_mixed(s))
        show_mixture(s);
    else
        for (uint32_t i = 0; i < s->info.parts; i++) show_part(s, i, PANEL);
}
