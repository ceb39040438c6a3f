/* Where the panels of a sheet go, and what every panel needs. */
#include "command.h"
#include "font.h"
#include "json.h"
#include "progress.h"
#include "report.h"
#include "sheet.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

enum { LABEL = 28, TEXT_SCALE = 2, TITLE_SCALE = 4, PARAGRAPH = 12 }; /* LABEL: height of a label with the gap below */

void sheet_heading(sheet* s, const char* title, const char* line)
{
    s->x = s->y = SHEET_MARGIN;
    s->bottom = s->y + TITLE_SCALE * FONT_HEIGHT + PARAGRAPH + LABEL + PARAGRAPH;
    s->code = canvas_grow(&s->canvas, s->bottom);
    if (s->code != EXIT_FINE) return;
    font_text(&s->canvas, s->x, s->y, TITLE_SCALE, COLOUR_INK, title);
    font_text(&s->canvas, s->x, s->y + TITLE_SCALE * FONT_HEIGHT + PARAGRAPH, TEXT_SCALE, COLOUR_FAINT, line);
    s->y = s->bottom;
}

void sheet_row(sheet* s)
{
    s->x = SHEET_MARGIN;
    s->y = s->bottom;
}

rectangle sheet_panel(sheet* s, uint32_t width, uint32_t height, const char* format, ...)
{
    char label[160];
    va_list list;
    va_start(list, format);
    vsnprintf(label, sizeof label, format, list);
    va_end(list);
    if (s->x + width > SHEET_MARGIN + SHEET_CONTENT) sheet_row(s);
    const rectangle area = {s->x, s->y + LABEL, width, height};
    s->x += width + SHEET_GAP;
    if (area.y + height + SHEET_GAP > s->bottom) s->bottom = area.y + height + SHEET_GAP;
    if (s->code == EXIT_FINE) s->code = canvas_grow(&s->canvas, s->bottom);
    if (s->code == EXIT_FINE) font_text(&s->canvas, area.x, s->y + 6, TEXT_SCALE, COLOUR_INK, label);
    return area;
}

void sheet_image(sheet* s, const weft_image* image, const char* name)
{
    const tones plain = {0, 1};
    if (s->code != EXIT_FINE) return;
    const int cut = image->width > PANEL || image->height > PANEL;
    const rectangle at = cut ? sheet_panel(s, PANEL, PANEL, "%s, middle of %u x %u", name, image->width, image->height)
                             : sheet_panel(s, PANEL, PANEL, "%s, %u x %u", name, image->width, image->height);
    if (s->code == EXIT_FINE) canvas_image(&s->canvas, at, image, 1, plain);
}

void sheet_render(sheet* s, const weft_model* model, const weft_texture_options* options, uint32_t level,
                  uint32_t width, uint32_t height, weft_image* image)
{
    weft_texture* texture = NULL;
    progress_span whole = {0, 1};
    const weft_image wanted = {
        sheet_memory(s, (size_t)width * height * s->info.channels), 0, width, height, s->info.channels, WEFT_FORMAT_U8};
    *image = wanted;
    if (s->code == EXIT_FINE) sheet_check(s, weft_texture_create(s->context, model, options, &texture));
    if (s->code == EXIT_FINE) sheet_check(s, weft_texture_render(texture, 0, 0, level, progress_step, &whole, image));
    progress_clear();
    weft_texture_free(texture);
}

void sheet_report(const sheet* s, const char* output)
{
    json out = json_begin(stdout);
    json_object(&out, NULL);
    json_text(&out, "output", output);
    json_unsigned(&out, "width", s->canvas.width);
    json_unsigned(&out, "height", s->canvas.height);
    json_end(&out);
}

void sheet_check(sheet* s, weft_status status)
{
    if (s->code == EXIT_FINE && status != WEFT_OK) s->code = failed_weft(status);
}

void* sheet_memory(sheet* s, size_t size)
{
    void* memory = s->code == EXIT_FINE ? malloc(size) : NULL;
    if (s->code == EXIT_FINE && !memory) s->code = failed("out of memory");
    return memory;
}

int sheet_is_mixed(const sheet* s) { return s->info.method == WEFT_METHOD_TEXTON && s->info.parts > 1; }
