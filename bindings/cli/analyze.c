/* weft analyze: photo -> model. */
#include "clock.h"
#include "command.h"
#include "describe.h"
#include "file.h"
#include "json.h"
#include "open.h"
#include "options.h"
#include "progress.h"
#include "report.h"

#include <stdlib.h>
#include <string.h>

static const char notes[] =
    "A photo is a PNG of any colour type and depth. Grey gives a model of 1 channel, colour of 3; alpha is a\n"
    "channel of its own where it is not opaque everywhere. Values are used as they are: no gamma, no colour\n"
    "profile. Several photos are further maps of one surface, in register and of one size: their channels are\n"
    "analysed together. Method texton is texton noise, for textures without structure; wavelet is noise in\n"
    "octaves with a tone curve, for such textures without direction: its models are tiny, can be edited as JSON\n"
    "and fill space; picture repeats the photo as it is; auto takes the one that `weft describe` names. --bands,\n"
    "--knots and --gaussian are of wavelet, --support to --projection of texton. Method stationary makes a tile "
    "of\n256 x 256 pixels that shows no repeats; `weft tile` has its options. Method bilayer takes the photo apart "
    "into\n"
    "structure, which is rearranged, and up to six noises; --noises to --depth are its own, and `weft preview` shows\n"
    "what --window does.";

enum {
    CHOSEN_TEXTON,
    CHOSEN_WAVELET,
    CHOSEN_BILAYER,
    CHOSEN_STATIONARY,
    CHOSEN_PICTURE,
    CHOSEN_AUTO
}; /* in the order of the option's words */

typedef struct analyze_options {
    const char* output;
    uint32_t method, interpolation, projection, masks, structure; /* indices of the words below */
    int gaussian, equalize;
    double from; /* what share of the work has been done before the analysis */
    weft_texton_options texton;
    weft_wavelet_options wavelet;
    weft_bilayer_options bilayer;
    weft_stationary_options stationary;
} analyze_options;

static int parse(analyze_options* o, arguments* common, int count, char** words)
{
    const weft_texton_options texton = WEFT_TEXTON_OPTIONS_INIT;
    const weft_wavelet_options wavelet = WEFT_WAVELET_OPTIONS_INIT;
    const weft_bilayer_options bilayer = WEFT_BILAYER_OPTIONS_INIT;
    const weft_stationary_options stationary = WEFT_STATIONARY_OPTIONS_INIT;
    const option table[] = {
        {"-o", OPTION_TEXT, &o->output, "MODEL", "where the model goes", 0, 0},
        {"--method", OPTION_CHOICE, &o->method, "texton|wavelet|bilayer|stationary|picture|auto", "default texton", 0,
         0},
        {"--support", OPTION_COUNT, &o->texton.support, "N", "edge of the textons in pixels; default 64", 1, 8192},
        {"--iterations", OPTION_COUNT, &o->texton.iterations, "N", "of the projections", 1, 1000000},
        {"--interpolation", OPTION_CHOICE, &o->interpolation, "0|1|3|5", "order of the B-spline; default 1", 0, 0},
        {"--projection", OPTION_CHOICE, &o->projection, "plain|momentum", "Algorithm 1 as published, or accelerated", 0,
         0},
        {"--seed", OPTION_SEED, &o->texton.seed, "N", "what texton, bilayer and stationary start from; default 0", 0,
         0},
        {"--bands", OPTION_COUNT, &o->wavelet.bands, "N", "octaves; default all that the photo holds", 1, 16},
        {"--knots", OPTION_COUNT, &o->wavelet.tone_knots, "N", "of the tone curves; default 10", 2, 32},
        {"--gaussian", OPTION_FLAG, &o->gaussian, NULL, "no tone curves", 0, 0},
        {"--noises", OPTION_COUNT, &o->bilayer.noises, "K", "of different spectra; default what is told apart", 1, 6},
        {"--window", OPTION_COUNT, &o->bilayer.window, "2|4|8|16", "T_loc: coarser is structure; default 4", 2, 16},
        {"--mask-window", OPTION_COUNT, &o->bilayer.mask_window, "2|4|8|16", "T_loc of the masks; default 8", 2, 16},
        {"--masks", OPTION_CHOICE, &o->masks, "binary|barycentric", "default binary", 0, 0},
        {"--structure", OPTION_CHOICE, &o->structure, "auto|wang|exchange|both|none", "default auto", 0, 0},
        {"--border", OPTION_COUNT, &o->bilayer.border, "N", "pixels beside masks' borders without noise", 1, 64},
        {"--equalize", OPTION_FLAG, &o->equalize, NULL, "noises keep their histograms", 0, 0},
        {"--depth", OPTION_COUNT, &o->bilayer.depth, "N", "passes of the filter; default 1", 1, 4},
    };
    const command_line line = {
        "analyze", "PHOTO... -o MODEL", "Learns a model from a photo.", notes, table, sizeof table / sizeof table[0],
        1,         MOST_OPERANDS};
    static const weft_interpolation orders[] = {WEFT_INTERPOLATION_NEAREST, WEFT_INTERPOLATION_LINEAR,
                                                WEFT_INTERPOLATION_CUBIC, WEFT_INTERPOLATION_QUINTIC};
    static const weft_projection projections[] = {WEFT_PROJECTION_PLAIN, WEFT_PROJECTION_MOMENTUM};
    static const weft_masks masks[] = {WEFT_MASKS_BINARY, WEFT_MASKS_BARYCENTRIC};
    static const weft_structure structures[] = {WEFT_STRUCTURE_AUTO, WEFT_STRUCTURE_WANG, WEFT_STRUCTURE_EXCHANGE,
                                                WEFT_STRUCTURE_BOTH, WEFT_STRUCTURE_NONE};
    memset(o, 0, sizeof *o);
    o->texton = texton;
    o->wavelet = wavelet;
    o->bilayer = bilayer;
    o->stationary = stationary;
    o->interpolation = o->projection = UINT32_MAX;
    int code = parse_arguments(&line, count, words, common);
    if (code >= 0) return code;
    if (!o->output) return misused("it needs -o MODEL");
    o->wavelet.gaussian = (uint32_t)o->gaussian;
    o->stationary.seed = o->bilayer.seed = o->texton.seed;
    o->bilayer.support = o->texton.support;
    o->bilayer.masks = masks[o->masks];
    o->bilayer.structure = structures[o->structure];
    o->bilayer.equalize = (uint32_t)o->equalize;
    if (o->interpolation != UINT32_MAX) o->texton.interpolation = orders[o->interpolation];
    if (o->projection != UINT32_MAX) o->texton.projection = projections[o->projection];
    return check_stdout(common->json, o->output) ? EXIT_USAGE : -1;
}

/* Makes --method auto the method that suits the photo. */
static int choose(weft_context* context, const weft_image* photo, analyze_options* o)
{
    weft_description description;
    progress_span first = {0, 0.5};
    if (o->method != CHOSEN_AUTO) return EXIT_FINE;
    int code = describe_photo(context, photo, &first, &description);
    if (code != EXIT_FINE) return code;
    o->method = description.method == WEFT_METHOD_TEXTON       ? CHOSEN_TEXTON
                : description.method == WEFT_METHOD_WAVELET    ? CHOSEN_WAVELET
                : description.method == WEFT_METHOD_BILAYER    ? CHOSEN_BILAYER
                : description.method == WEFT_METHOD_STATIONARY ? CHOSEN_STATIONARY
                                                               : CHOSEN_PICTURE;
    o->from = first.to;
    return EXIT_FINE;
}

static int analyze(weft_context* context, const weft_image* photo, const analyze_options* o, weft_model** model)
{
    progress_span whole = {o->from, 1};
    weft_status status = WEFT_OK;
    if (o->method == CHOSEN_TEXTON)
        status = weft_analyze_texton(context, photo, &o->texton, progress_step, &whole, model);
    else if (o->method == CHOSEN_BILAYER)
        status = weft_analyze_bilayer(context, photo, &o->bilayer, progress_step, &whole, model);
    else if (o->method == CHOSEN_STATIONARY)
        status = weft_analyze_stationary(context, photo, &o->stationary, progress_step, &whole, model);
    else if (o->method == CHOSEN_WAVELET)
        status = weft_analyze_wavelet(context, photo, &o->wavelet, progress_step, &whole, model);
    else
        status = weft_analyze_picture(context, photo, model);
    progress_clear();
    return status == WEFT_OK ? EXIT_FINE : failed_weft(status);
}

static void report(const weft_model_info* info, const analyze_options* o, const arguments* common, double seconds)
{
    if (common->json) {
        json out = json_begin(stdout);
        json_object(&out, NULL);
        json_text(&out, "model", o->output);
        json_text(&out, "method", method_name(info->method));
        json_unsigned(&out, "channels", info->channels);
        json_unsigned(&out, "width", info->width);
        json_unsigned(&out, "height", info->height);
        if (info->model_error < 0)
            json_null(&out, "model_error");
        else
            json_real(&out, "model_error", (double)info->model_error);
        json_unsigned(&out, "bytes", info->bytes);
        json_real(&out, "seconds", seconds);
        json_end(&out);
    } else if (!common->quiet && strcmp(o->output, "-") != 0) {
        char size[MODEL_SIZE_ROOM];
        printf("%s: %s%s, channels %u, %.*f KiB", o->output, method_name(info->method), model_size(info, size),
               info->channels, info->bytes < 10240 ? 1 : 0, (double)info->bytes / 1024);
        if (info->model_error >= 0) printf(", relative model error %.3f", (double)info->model_error);
        printf(", %.2f s\n", seconds);
    }
}

int command_analyze(int count, char** words)
{
    analyze_options o;
    arguments common;
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    weft_context* context = NULL;
    weft_model* model = NULL;
    weft_image photo = {NULL, 0, 0, 0, 0, 0};
    int code = parse(&o, &common, count, words);
    if (code >= 0) return code;
    progress_begin(common.quiet);
    code = open_context(&common, &context);
    if (code == EXIT_FINE) code = open_photos(common.operand, common.operands, &photo);
    double begin = wall_seconds();
    if (code == EXIT_FINE) code = choose(context, &photo, &o);
    if (code == EXIT_FINE) code = analyze(context, &photo, &o, &model);
    double seconds = wall_seconds() - begin;
    if (code == EXIT_FINE) code = save_model(model, o.output);
    if (code == EXIT_FINE && weft_model_get(model, &info) == WEFT_OK) report(&info, &o, &common, seconds);
    weft_model_free(model);
    weft_context_free(context);
    free(photo.data);
    return code;
}
