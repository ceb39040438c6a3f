/* weft tile: photo -> a tile that repeats without a seam and without a feature that sticks out. */
#include "tile.h"
#include "apply.h"
#include "clock.h"
#include "command.h"
#include "file.h"
#include "maps.h"
#include "numbers.h"
#include "open.h"
#include "options.h"
#include "report.h"

#include <stdlib.h>
#include <string.h>

static const char notes[] =
    "The tile is put together of the photo's patches, as even as is asked for. --sigma is the size of the\n"
    "neighbourhoods that shall look alike, a share of the tile's shorter side: 0.3 lets large features stay,\n"
    "0.05 leaves none. --stationarity says the same on an even scale, for which small tiles are tried out first:\n"
    "0 is sigma 0.3, 1 as even as sigma 0.05. --sigma-map is a grey picture, stretched over the tile: white is "
    "--sigma, black\n"
    "the least. --scale coarse keeps larger features and looks the most natural, fine is the most even.\n"
    "--palette makes N tiles from 0 to 1 of that scale and lays them side by side: each repeated 2 x 2, and in\n"
    "perspective. Several photos are further maps of one surface, in register: the first three channels are what\n"
    "is compared, the others follow; the %d in TILE is then the map's number. Each map keeps its depth, or that\n"
    "of the deepest. `weft apply` makes the tile of another map from MODEL.";

enum { MEASURES_COUNT = 4 };

typedef struct tile_command {
    const char *output, *model, *sigma_map;
    extent size;
    float stationarity;               /* below 0: not given */
    uint32_t measure, scale, palette; /* indices of the words below; palette 0: none */
    weft_stationary_options options;
} tile_command;

static int check(tile_command* o, const arguments* common)
{
    static const weft_stationarity measures[MEASURES_COUNT] = {WEFT_STATIONARITY_HISTOGRAM, WEFT_STATIONARITY_MOMENTS,
                                                               WEFT_STATIONARITY_STEERABLE, WEFT_STATIONARITY_NONE};
    if (!o->output) return misused("it needs -o TILE.png");
    if (o->options.patch > 0 && o->options.patch % 2 == 0) return misused("--patch takes an odd number");
    if (o->stationarity >= 0 && o->options.sigma > 0) return misused("--sigma and --stationarity exclude each other");
    if (o->palette > 0 && (o->stationarity >= 0 || o->options.sigma > 0 || o->sigma_map || o->model))
        return misused("--palette takes neither --sigma, --sigma-map, --stationarity nor --model");
    o->options.stationarity = measures[o->measure];
    if (o->options.stationarity == WEFT_STATIONARITY_NONE &&
        (o->palette > 0 || o->stationarity >= 0 || o->options.sigma > 0 || o->sigma_map))
        return misused("--measure none knows no stationarity");
    o->options.width = o->size.width;
    o->options.height = o->size.height;
    o->options.start = o->scale == 0 ? 8 : 4;
    if (check_stdout(common->json, o->output)) return EXIT_USAGE;
    return o->model && check_stdout(common->json, o->model) ? EXIT_USAGE : -1;
}

static int parse(tile_command* o, arguments* common, int count, char** words)
{
    const weft_stationary_options defaults = WEFT_STATIONARY_OPTIONS_INIT;
    const option table[] = {
        {"-o", OPTION_TEXT, &o->output, "TILE.png", "where the tile goes, or the palette", 0, 0},
        {"--model", OPTION_TEXT, &o->model, "MODEL", "where the model goes", 0, 0},
        {"--size", OPTION_EXTENT, &o->size, "WxH", "of the tile in pixels; default 256x256", 64, 2048},
        {"--sigma", OPTION_REAL, &o->options.sigma, "S", "of the neighbourhoods; default 0.1", 0.02, 1},
        {"--sigma-map", OPTION_TEXT, &o->sigma_map, "MAP.png", "share of --sigma from place to place", 0, 0},
        {"--stationarity", OPTION_REAL, &o->stationarity, "0..1", "in place of --sigma, on an even scale", 0, 1},
        {"--measure", OPTION_CHOICE, &o->measure, "histogram|moments|steerable|none", "default histogram", 0, 0},
        {"--moments", OPTION_COUNT, &o->options.moments, "N", "order of the moments; default 2", 1, 4},
        {"--scale", OPTION_CHOICE, &o->scale, "coarse|fine", "what is made first; default fine", 0, 0},
        {"--patch", OPTION_COUNT, &o->options.patch, "N", "side of the patches in pixels, odd; default 11", 3, 31},
        {"--seed", OPTION_SEED, &o->options.seed, "N", "which of many tiles; default 0", 0, 0},
        {"--palette", OPTION_COUNT, &o->palette, "N", "a sheet of N tiles, from least to most stationary",
         LEAST_PALETTE, MOST_PALETTE},
    };
    const command_line line = {
        "tile", "PHOTO... -o TILE.png", "Makes a tile of a photo.", notes, table, sizeof table / sizeof table[0],
        1,      MOST_OPERANDS};
    memset(o, 0, sizeof *o);
    o->options = defaults;
    o->stationarity = -1;
    o->size.width = o->size.height = 256;
    o->scale = 1;
    int code = parse_arguments(&line, count, words, common);
    return code >= 0 ? code : check(o, common);
}

/* Keeps the texture cost, whose last one is the tile's. */
static void note_step(void* user, const weft_stationary_step* step) WEFT_NOEXCEPT
{
    char text[96], stationarity[32] = "";
    *(float*)user = step->texture_cost;
    if (step->stationarity_cost >= 0)
        snprintf(stationarity, sizeof stationarity, ", stationarity %.2f", (double)step->stationarity_cost);
    snprintf(text, sizeof text, "level %u/%u, %u x %u, iteration %u/%u: texture %.2f%s", step->level + 1, step->levels,
             step->width, step->height, step->iteration + 1, step->iterations, (double)step->texture_cost,
             stationarity);
    progress_note(text);
}

int make_tile(weft_context* context, const weft_image* photo, const weft_stationary_options* options,
              const progress_span* span, tile_result* result)
{
    weft_stationary_options noted = *options;
    progress_span part = *span;
    double begin = wall_seconds();
    result->texture_cost = -1;
    result->sigma = options->sigma > 0 ? options->sigma : 0.1f;
    noted.report = note_step;
    noted.report_user = &result->texture_cost;
    weft_status status = weft_analyze_stationary(context, photo, &noted, progress_step, &part, &result->model);
    progress_clear();
    result->seconds = wall_seconds() - begin;
    return status == WEFT_OK ? EXIT_FINE : failed_weft(status);
}

int measure_tile(weft_context* context, const weft_image* tile, tile_result* result)
{
    weft_status status = weft_stationarity_cost(context, tile, NULL, NULL, NULL, NULL, &result->stationarity_cost);
    return status == WEFT_OK ? EXIT_FINE : failed_weft(status);
}

static int open_sigma_map(tile_command* o, weft_image* map)
{
    if (!o->sigma_map) return EXIT_FINE;
    int code = open_photos(&o->sigma_map, 1, map);
    if (code != EXIT_FINE) return code;
    if (map->channels != 1) return failed("%s has %u channels, which is no grey picture", o->sigma_map, map->channels);
    o->options.sigma_map = map;
    return EXIT_FINE;
}

/* The sigma that --stationarity means; the bar goes on from span->from. */
static int choose_sigma(weft_context* context, tile_command* o, const weft_image* photo, progress_span* span)
{
    tile_scale scale;
    const progress_span first = {0, 0.7};
    if (o->stationarity < 0) return EXIT_FINE;
    int code = measure_scale(context, photo, &o->options, &first, &scale);
    if (code != EXIT_FINE) return code;
    o->options.sigma = sigma_of(&scale, (double)o->stationarity);
    span->from = first.to;
    return EXIT_FINE;
}

static int make_one(weft_context* context, tile_command* o, const arguments* common, const weft_image* photo,
                    const uint32_t* groups)
{
    progress_span span = {0, 1};
    tile_result result = {NULL, 0, 0, 0, 0};
    weft_image tile = {NULL, 0, 0, 0, 0, 0};
    int code = choose_sigma(context, o, photo, &span);
    if (code == EXIT_FINE) code = make_tile(context, photo, &o->options, &span, &result);
    if (code == EXIT_FINE) code = apply_model(result.model, photo, &tile);
    if (code == EXIT_FINE) code = measure_tile(context, &tile, &result);
    if (code == EXIT_FINE) code = maps_write(o->output, &tile, groups, common->operands);
    if (code == EXIT_FINE && o->model) code = save_model(result.model, o->model);
    if (code == EXIT_FINE && common->json)
        json_tile(o->output, &o->options, &result);
    else if (code == EXIT_FINE && !common->quiet && strcmp(o->output, "-") != 0)
        print_tile(o->output, &o->options, &result);
    free(tile.data);
    weft_model_free(result.model);
    return code;
}

/* Tile `i` of a palette. */
static int make_swatch(weft_context* context, tile_command* o, const weft_image* photo, const tile_scale* scale,
                       uint32_t i, tile_result* result)
{
    const progress_span span = {0.5 + 0.5 * i / o->palette, 0.5 + 0.5 * (i + 1) / o->palette};
    weft_image tile = {NULL, 0, 0, 0, 0, 0};
    o->options.sigma = sigma_of(scale, (double)i / (o->palette - 1));
    int code = make_tile(context, photo, &o->options, &span, result);
    if (code == EXIT_FINE) code = apply_model(result->model, photo, &tile);
    if (code == EXIT_FINE) code = measure_tile(context, &tile, result);
    free(tile.data);
    return code;
}

static int make_palette(weft_context* context, tile_command* o, const arguments* common, const weft_image* photo)
{
    tile_result results[MOST_PALETTE];
    tile_scale scale;
    const progress_span first = {0, 0.5};
    memset(results, 0, sizeof results);
    int code = measure_scale(context, photo, &o->options, &first, &scale);
    for (uint32_t i = 0; i < o->palette && code == EXIT_FINE; i++)
        code = make_swatch(context, o, photo, &scale, i, &results[i]);
    if (code == EXIT_FINE) code = write_palette(context, results, o->palette, o->output);
    if (code == EXIT_FINE && common->json)
        json_palette(o->output, results, o->palette);
    else if (code == EXIT_FINE && !common->quiet && strcmp(o->output, "-") != 0)
        print_palette(results, o->palette);
    for (uint32_t i = 0; i < o->palette; i++) weft_model_free(results[i].model);
    return code;
}

int command_tile(int count, char** words)
{
    tile_command o;
    arguments common;
    weft_context* context = NULL;
    weft_image photo = {NULL, 0, 0, 0, 0, 0}, map = {NULL, 0, 0, 0, 0, 0};
    uint32_t groups[MOST_OPERANDS];
    int code = parse(&o, &common, count, words);
    if (code >= 0) return code;
    progress_begin(common.quiet);
    code = open_context(&common, &context);
    if (code == EXIT_FINE) code = open_maps(common.operand, common.operands, &photo, groups);
    if (code == EXIT_FINE) code = open_sigma_map(&o, &map);
    if (code == EXIT_FINE && o.palette > 0)
        code = make_palette(context, &o, &common, &photo);
    else if (code == EXIT_FINE)
        code = make_one(context, &o, &common, &photo, groups);
    weft_context_free(context);
    free(map.data);
    free(photo.data);
    return code;
}
