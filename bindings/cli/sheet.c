/* weft sheet: one picture that shows a model, its texture, and how close this is to the photo. */
#include "sheet.h"
#include "command.h"
#include "file.h"
#include "open.h"
#include "options.h"
#include "progress.h"
#include "report.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char notes[] =
    "From the top: the photo if it is given, the texture at several seeds (of a mixed model its first and last\n"
    "step), what the model holds, the texture enlarged and from afar, a period of it repeated 3 x 3, and\n"
    "power spectra and histograms of photo and texture.";

static const weft_image no_image = {NULL, 0, 0, 0, 0, 0};

static void show_heading(sheet* s, const char* path)
{
    const char* slash = strrchr(path, '/');
    char size[MODEL_SIZE_ROOM], line[160];
    int used = snprintf(line, sizeof line, "%s%s, %u channel%s, %llu bytes", method_name(s->info.method),
                        model_size(&s->info, size), s->info.channels, s->info.channels == 1 ? "" : "s",
                        (unsigned long long)s->info.bytes);
    if (sheet_is_mixed(s)) used += snprintf(line + used, sizeof line - (size_t)used, ", %u steps", s->info.parts);
    if (s->info.model_error >= 0)
        used += snprintf(line + used, sizeof line - (size_t)used, ", relative model error %.3f",
                         (double)s->info.model_error);
    if (s->info.channels == 2 || s->info.channels > 3)
        snprintf(line + used, sizeof line - (size_t)used, "; shown %s", s->info.channels == 2 ? "is 1" : "are 1 to 3");
    sheet_heading(s, slash ? slash + 1 : path, line);
}

/* Remembers the texture with a seed, or a step of a mixed model, and shows it. */
static void show_output(sheet* s, uint64_t seed, const weft_image* map, const char* name)
{
    weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    weft_image* image = &s->output[s->outputs];
    options.seed = seed;
    options.mix = map;
    s->name[s->outputs++] = name;
    sheet_render(s, s->model, &options, 0, PANEL, PANEL, image);
    sheet_image(s, image, name);
}

static void show_outputs(sheet* s)
{
    static const char* const seeds[3] = {"texture, seed 1", "texture, seed 2", "texture, seed 3"};
    float places[2] = {0, 1};
    const weft_image ends[2] = {{&places[0], 0, 1, 1, 1, WEFT_FORMAT_F32}, {&places[1], 0, 1, 1, 1, WEFT_FORMAT_F32}};
    if (s->photo.data) sheet_image(s, &s->photo, "photo");
    if (sheet_is_mixed(s)) {
        show_output(s, 1, &ends[0], "first step");
        show_output(s, 1, &ends[1], "last step");
    } else if (s->info.method == WEFT_METHOD_PICTURE) {
        show_output(s, 1, NULL, "texture");
    } else {
        for (uint32_t i = 0; i < (s->photo.data ? 2u : 3u); i++) show_output(s, i + 1, NULL, seeds[i]);
    }
}

static void show_enlarged(sheet* s)
{
    enum { SCALE = 4 };
    const tones plain = {0, 1};
    const rectangle at = sheet_panel(s, PANEL, PANEL, "%s, %d %%", s->name[0], SCALE * 100);
    if (s->code == EXIT_FINE) canvas_image(&s->canvas, at, &s->output[0], SCALE, plain);
}

/* Mip levels below each other. */
static void show_levels(sheet* s)
{
    enum { LEVELS = 4, SEAM = 4 };
    static const uint32_t heights[LEVELS] = {240, 124, 72, 64};
    const tones plain = {0, 1};
    weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    rectangle at = sheet_panel(s, PANEL, PANEL, "from afar: mip levels 1 to %d", LEVELS);
    options.seed = 1;
    for (uint32_t level = 1; level <= LEVELS; level++) {
        weft_image image = no_image;
        at.height = heights[level - 1];
        sheet_render(s, s->model, &options, level, PANEL, at.height, &image);
        if (s->code == EXIT_FINE) canvas_image(&s->canvas, at, &image, 1, plain);
        free(image.data);
        at.y += at.height + SEAM;
    }
}

/* A noise of a small period, what has a picture in it of that one's, at a level that lets it fit three times. */
static void show_repeat(sheet* s)
{
    enum { PERIOD = 160, TIMES = 3 };
    const tones plain = {0, 1};
    weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    const int noise = s->info.method == WEFT_METHOD_TEXTON || s->info.method == WEFT_METHOD_WAVELET;
    uint32_t period_x = noise ? PERIOD : s->info.width, period_y = noise ? PERIOD : s->info.height, level = 0;
    options.seed = 1;
    options.period_x = period_x;
    options.period_y = period_y;
    for (; period_x * TIMES > PANEL || period_y * TIMES > PANEL; level++) period_x /= 2, period_y /= 2;
    weft_image image = no_image;
    const rectangle at = sheet_panel(s, PANEL, PANEL, "3 x 3 periods of %u x %u", options.period_x, options.period_y);
    sheet_render(s, s->model, &options, level, period_x * TIMES, period_y * TIMES, &image);
    if (s->code == EXIT_FINE) canvas_image(&s->canvas, at, &image, 1, plain);
    free(image.data);
}

static void draw(sheet* s, const char* path)
{
    show_heading(s, path);
    show_outputs(s);
    sheet_model(s);
    show_enlarged(s);
    show_levels(s);
    show_repeat(s);
    sheet_measures(s);
    if (s->code == EXIT_FINE) s->code = canvas_grow(&s->canvas, s->bottom + SHEET_MARGIN);
}

static int make_sheet(sheet* s, const arguments* common, const char* photo, const char* output)
{
    weft_model* model = NULL;
    int code = open_context(common, &s->context);
    if (code == EXIT_FINE) code = open_model(s->context, common->operand[0], &model, &s->info);
    if (code == EXIT_FINE && photo) code = open_photos(&photo, 1, &s->photo);
    if (code == EXIT_FINE && photo && s->photo.channels != s->info.channels)
        code = failed("%s has %u channels, the model %u", photo, s->photo.channels, s->info.channels);
    s->model = model;
    s->code = code;
    if (code == EXIT_FINE) draw(s, common->operand[0]);
    if (s->code == EXIT_FINE) s->code = canvas_write(&s->canvas, output);
    if (s->code == EXIT_FINE && common->json) sheet_report(s, output);
    weft_model_free(model);
    weft_context_free(s->context);
    return s->code;
}

int command_sheet(int count, char** words)
{
    const char *output = NULL, *photo = NULL;
    const option table[] = {
        {"-o", OPTION_TEXT, &output, "SHEET.png", "where the picture goes", 0, 0},
        {"--photo", OPTION_TEXT, &photo, "PHOTO", "what the model was learnt from, to compare with", 0, 0},
    };
    const command_line line = {"sheet", "MODEL -o SHEET.png", "Draws what a model holds and gives.", notes, table, 2, 1,
                               1};
    arguments common;
    sheet s;
    memset(&s, 0, sizeof s);
    s.canvas.width = SHEET_CONTENT + 2 * SHEET_MARGIN;
    int code = parse_arguments(&line, count, words, &common);
    if (code >= 0) return code;
    if (!output) return misused("it needs -o SHEET.png");
    if (check_stdout(common.json, output)) return EXIT_USAGE;
    progress_begin(common.quiet);
    code = make_sheet(&s, &common, photo, output);
    for (uint32_t i = 0; i < s.outputs; i++) free(s.output[i].data);
    free(s.photo.data);
    canvas_free(&s.canvas);
    return code;
}
