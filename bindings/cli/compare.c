/* weft compare: how close an output is to its exemplar. */
#include "command.h"
#include "json.h"
#include "open.h"
#include "options.h"
#include "progress.h"
#include "report.h"

#include <stdlib.h>
#include <string.h>

static const char notes[] =
    "Two PNGs of the same channels; weft.h says how each measure is computed.\n"
    "  model_error           distance of the Gaussian textures that have the two spectra\n"
    "  histogram_distance    how far values must move, in standard deviations of the exemplar\n"
    "  autocovariance_error  difference of the autocovariances at lags up to 32 pixels\n"
    "  patch_distance        the same for whitened patches of three sizes: structure\n"
    "  repetition            highest far peak of the autocovariance, against a noise that never repeats\n"
    "  verbatim_copy         share of windows whose neighbours are copied along with them\n"
    "  seam_score            how much the output's borders stand out when it is laid beside itself\n"
    "  stationarity_cost     how much places of the output differ from one another, in Lab units; the exemplar's\n"
    "                        is beside it\n"
    "  texture_cost          squared distance of the output's 11 x 11 patches to the exemplar's, in Lab units\n"
    "What a method does not promise it may miss: texton noise promises mean, covariance and spectrum, and\n"
    "neither the histogram nor the patches of a photo with structure. A measure that is not defined for\n"
    "images this small or this constant is `-`, null in JSON.";

typedef struct measure {
    const char* key;
    float value;
    const char* good;
} measure;

enum { MEASURES = 13 };

typedef struct tile_costs {
    float exemplar, output, texture;
} tile_costs;

static void list_measures(const weft_comparison* c, const tile_costs* costs, measure list[MEASURES])
{
    const measure all[MEASURES] = {
        {"model_error", c->model_error, "below 0.15"},
        {"histogram_distance", c->histogram_distance, "below 0.15"},
        {"autocovariance_error", c->autocovariance_error, "0.2 to 0.5 is usual between two samples of one texture"},
        {"patch_distance", c->patch_distance, "below 0.10"},
        {"patch_distance_level_0", c->patch_distance_level[0], NULL},
        {"patch_distance_level_1", c->patch_distance_level[1], NULL},
        {"patch_distance_level_2", c->patch_distance_level[2], NULL},
        {"repetition", c->repetition, "below 1.6; 1 is a noise that never repeats"},
        {"verbatim_copy", c->verbatim_copy, "below 0.5; about 0.3 is chance"},
        {"seam_score", c->seam_score, "between -2 and 2, if the output is to tile"},
        {"stationarity_cost", costs->output, NULL},
        {"exemplar_stationarity_cost", costs->exemplar, NULL},
        {"texture_cost", costs->texture, NULL},
    };
    memcpy(list, all, sizeof all);
}

static void write_json(const measure list[MEASURES])
{
    json out = json_begin(stdout);
    json_object(&out, NULL);
    for (int i = 0; i < MEASURES; i++) {
        if (list[i].value == -1.0f)
            json_null(&out, list[i].key);
        else
            json_real(&out, list[i].key, (double)list[i].value);
    }
    json_end(&out);
}

static void write_text(const measure list[MEASURES])
{
    for (int i = 0; i < MEASURES; i++) {
        char value[32] = "-";
        if (list[i].value != -1.0f) snprintf(value, sizeof value, "%.4f", (double)list[i].value);
        printf("%-26s %10s%s%s\n", list[i].key, value, list[i].good ? "   good: " : "",
               list[i].good ? list[i].good : "");
    }
}

/* Fewer patches are looked for in an exemplar beyond a megapixel. */
static int measure_costs(weft_context* context, const weft_image images[2], uint64_t seed, tile_costs* costs)
{
    weft_texture_cost_options options = WEFT_TEXTURE_COST_OPTIONS_INIT;
    uint64_t area = (uint64_t)images[0].width * images[0].height, samples = ((uint64_t)256 << 20) / area;
    progress_span whole = {0.5, 1};
    options.samples = (uint32_t)(samples > 256 ? 256 : samples < 16 ? 16 : samples);
    options.seed = seed;
    weft_status status =
        weft_texture_cost(context, &images[0], &images[1], &options, progress_step, &whole, &costs->texture);
    if (status == WEFT_OK)
        status = weft_stationarity_cost(context, &images[0], NULL, NULL, NULL, NULL, &costs->exemplar);
    if (status == WEFT_OK) status = weft_stationarity_cost(context, &images[1], NULL, NULL, NULL, NULL, &costs->output);
    progress_clear();
    return status == WEFT_OK ? EXIT_FINE : failed_weft(status);
}

static int compare(weft_context* context, const weft_image images[2], const weft_compare_options* options, int as_json)
{
    weft_comparison comparison = WEFT_COMPARISON_INIT;
    tile_costs costs;
    measure list[MEASURES];
    progress_span half = {0, 0.5};
    weft_status status = weft_compare(context, &images[0], &images[1], options, progress_step, &half, &comparison);
    progress_clear();
    if (status != WEFT_OK) return failed_weft(status);
    int code = measure_costs(context, images, options->seed, &costs);
    if (code != EXIT_FINE) return code;
    list_measures(&comparison, &costs, list);
    if (as_json)
        write_json(list);
    else
        write_text(list);
    return EXIT_FINE;
}

int command_compare(int count, char** words)
{
    weft_compare_options options = WEFT_COMPARE_OPTIONS_INIT;
    const option table[] = {
        {"--seed", OPTION_SEED, &options.seed, "N", "of directions, windows and null textures", 0, 0}};
    const command_line line = {
        "compare", "EXEMPLAR OUTPUT", "Measures how close an output is to its exemplar.", notes, table, 1, 2, 2};
    arguments common;
    weft_context* context = NULL;
    weft_image images[2] = {{NULL, 0, 0, 0, 0, 0}, {NULL, 0, 0, 0, 0, 0}};
    int code = parse_arguments(&line, count, words, &common);
    if (code >= 0) return code;
    progress_begin(common.quiet);
    code = open_context(&common, &context);
    if (code == EXIT_FINE) code = open_photos(&common.operand[0], 1, &images[0]);
    if (code == EXIT_FINE) code = open_photos(&common.operand[1], 1, &images[1]);
    if (code == EXIT_FINE) code = compare(context, images, &options, common.json);
    weft_context_free(context);
    free(images[0].data);
    free(images[1].data);
    return code;
}
