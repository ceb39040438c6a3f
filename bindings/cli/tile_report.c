/* What `weft tile` made, as text and as JSON. */
#include "json.h"
#include "tile.h"

static int has_sigma(const weft_stationary_options* options) { return options->stationarity != WEFT_STATIONARITY_NONE; }

void print_tile(const char* output, const weft_stationary_options* options, const tile_result* result)
{
    printf("%s: %u x %u", output, options->width, options->height);
    if (has_sigma(options)) printf(", sigma %.3f", (double)result->sigma);
    printf(", stationarity cost %.2f, texture cost %.2f, %.2f s\n", (double)result->stationarity_cost,
           (double)result->texture_cost, result->seconds);
}

static void json_costs(json* out, const tile_result* result)
{
    json_real(out, "stationarity_cost", (double)result->stationarity_cost);
    json_real(out, "texture_cost", (double)result->texture_cost);
    json_real(out, "seconds", result->seconds);
}

void json_tile(const char* output, const weft_stationary_options* options, const tile_result* result)
{
    json out = json_begin(stdout);
    json_object(&out, NULL);
    json_text(&out, "output", output);
    json_unsigned(&out, "width", options->width);
    json_unsigned(&out, "height", options->height);
    if (has_sigma(options))
        json_real(&out, "sigma", (double)result->sigma);
    else
        json_null(&out, "sigma");
    json_unsigned(&out, "seed", options->seed);
    json_costs(&out, result);
    json_end(&out);
}

static double stationarity_of(uint32_t i, uint32_t count) { return (double)i / (count - 1); }

void print_palette(const tile_result* results, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        printf("column %2u: --stationarity %.3f or --sigma %.3f, stationarity cost %.2f, texture cost %.2f\n", i + 1,
               stationarity_of(i, count), (double)results[i].sigma, (double)results[i].stationarity_cost,
               (double)results[i].texture_cost);
}

void json_palette(const char* output, const tile_result* results, uint32_t count)
{
    json out = json_begin(stdout);
    json_object(&out, NULL);
    json_text(&out, "output", output);
    json_array(&out, "tiles");
    for (uint32_t i = 0; i < count; i++) {
        json_object(&out, NULL);
        json_real(&out, "stationarity", stationarity_of(i, count));
        json_real(&out, "sigma", (double)results[i].sigma);
        json_costs(&out, &results[i]);
        json_end(&out);
    }
    json_end(&out);
    json_end(&out);
}
