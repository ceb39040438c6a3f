/* Stationary tiles, shared by the files of `weft tile`. */
#ifndef WEFT_CLI_TILE_H
#define WEFT_CLI_TILE_H

#include "progress.h"

#include <weft/weft.h>

enum { LEAST_PALETTE = 2, MOST_PALETTE = 16 };

typedef struct tile_result {
    weft_model* model;
    float sigma, texture_cost, stationarity_cost;
    double seconds;
} tile_result;

/* Makes the model of a tile, with a bar and a note over `span`; all but the stationarity cost. An exit code. */
int make_tile(weft_context* context, const weft_image* photo, const weft_stationary_options* options,
              const progress_span* span, tile_result* result);

/* Sets the stationarity cost. An exit code. */
int measure_tile(weft_context* context, const weft_image* tile, tile_result* result);

/* How stationary small tiles of one photo come out, sigma by sigma. */
enum { SCALE_STEPS = 6 };
typedef struct tile_scale {
    double sigma[SCALE_STEPS]; /* descending */
    double cost[SCALE_STEPS];  /* stationarity cost, not ascending */
} tile_scale;

/* Tries out each sigma, with a bar over `span`. An exit code. */
int measure_scale(weft_context* context, const weft_image* photo, const weft_stationary_options* options,
                  const progress_span* span, tile_scale* scale);

/* The sigma of a stationarity in 0..1: equal steps of it are equal steps of the cost. */
float sigma_of(const tile_scale* scale, double stationarity);

/* A column for each of `count` tiles: repeated 2 x 2, and in perspective to the horizon. An exit code. */
int write_palette(weft_context* context, const tile_result* tiles, uint32_t count, const char* path);

void print_tile(const char* output, const weft_stationary_options* options, const tile_result* result);
void json_tile(const char* output, const weft_stationary_options* options, const tile_result* result);
void print_palette(const tile_result* results, uint32_t count);
void json_palette(const char* output, const tile_result* results, uint32_t count);

#endif
