/* weft preview: how a photo splits into structure and noise by each window (Guingo et al. 2017, Figure 14). */
#include "command.h"
#include "file.h"
#include "open.h"
#include "options.h"
#include "progress.h"
#include "report.h"
#include "sheet_bilayer.h"

#include <stdlib.h>
#include <string.h>

static const char notes[] =
    "A row for each T_loc of --window: structure P, noise N around grey, and the texture, structure rearranged\n"
    "without rotation and distortion, noise made anew. Structure should have what has a shape and noise none; what\n"
    "looks the same in the photo and in the texture is well in the noise.";

enum { WINDOWS = 4 };

static void show_texture(sheet* s, uint32_t window)
{
    weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    const tones plain = {0, 1};
    weft_image image = {NULL, 0, 0, 0, 0, 0};
    options.seed = 1;
    options.rotation = WEFT_ROTATION_NONE;
    options.scale_min = 1;
    options.turbulence = -1;
    const rectangle at = sheet_panel(s, PANEL, PANEL, "window %u: structure, noise, texture", window);
    sheet_render(s, s->model, &options, 0, PANEL, PANEL, &image);
    if (s->code == EXIT_FINE) canvas_image(&s->canvas, at, &image, 1, plain);
    free(image.data);
}

static void show_window(sheet* s, weft_bilayer_options options, uint32_t window, double from)
{
    progress_span span = {from, from + 1.0 / WINDOWS};
    const tones plain = {0, 1}, around_zero = {-0.5f, 0.5f};
    const weft_model_info start = WEFT_MODEL_INFO_INIT;
    weft_model* model = NULL;
    options.window = window;
    if (s->code != EXIT_FINE) return;
    sheet_check(s, weft_analyze_bilayer(s->context, &s->photo, &options, progress_step, &span, &model));
    progress_clear();
    s->model = model;
    s->info = start;
    if (s->code == EXIT_FINE) sheet_check(s, weft_model_get(model, &s->info));
    if (s->code == EXIT_FINE) {
        sheet_row(s);
        sheet_named_part(s, "structure", plain);
        sheet_named_part(s, "noise", around_zero);
        show_texture(s, window);
    }
    s->model = NULL;
    weft_model_free(model);
}

static int make_preview(sheet* s, const arguments* common, const weft_bilayer_options* options, const char* output)
{
    static const uint32_t windows[WINDOWS] = {2, 4, 8, 16};
    const char* path = common->operand[0];
    const char* slash = strrchr(path, '/');
    s->code = open_context(common, &s->context);
    if (s->code == EXIT_FINE) s->code = open_photos(&path, 1, &s->photo);
    if (s->code == EXIT_FINE) {
        sheet_heading(s, slash ? slash + 1 : path, "structure, noise and texture by the window of local spectra");
        sheet_image(s, &s->photo, "photo");
    }
    for (uint32_t i = 0; i < WINDOWS; i++) show_window(s, *options, windows[i], (double)i / WINDOWS);
    if (s->code == EXIT_FINE) s->code = canvas_grow(&s->canvas, s->bottom + SHEET_MARGIN);
    if (s->code == EXIT_FINE) s->code = canvas_write(&s->canvas, output);
    if (s->code == EXIT_FINE && common->json) sheet_report(s, output);
    return s->code;
}

int command_preview(int count, char** words)
{
    const char* output = NULL;
    weft_bilayer_options options = WEFT_BILAYER_OPTIONS_INIT;
    const option table[] = {
        {"-o", OPTION_TEXT, &output, "SHEET.png", "where the picture goes", 0, 0},
        {"--noises", OPTION_COUNT, &options.noises, "K", "of different spectra; default what is told apart", 1, 6},
    };
    const command_line line = {
        "preview", "PHOTO -o SHEET.png", "Draws how a photo splits into structure and noise.", notes, table, 2, 1, 1};
    arguments common;
    sheet s;
    memset(&s, 0, sizeof s);
    s.canvas.width = SHEET_CONTENT + 2 * SHEET_MARGIN;
    options.structure = WEFT_STRUCTURE_EXCHANGE;
    int code = parse_arguments(&line, count, words, &common);
    if (code >= 0) return code;
    if (!output) return misused("it needs -o SHEET.png");
    if (check_stdout(common.json, output)) return EXIT_USAGE;
    progress_begin(common.quiet);
    code = make_preview(&s, &common, &options, output);
    weft_context_free(s.context);
    free(s.photo.data);
    canvas_free(&s.canvas);
    return code;
}
