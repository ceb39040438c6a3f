/* The even scale of stationarity. The distance between the histograms of results, which the paper takes, hardly changes
 * with sigma where the histogram is held; the stationarity cost at one sigma does. */
#include "command.h"
#include "report.h"
#include "tile.h"

#include <math.h>
#include <stdlib.h>

enum { SEEDS = 2, SMALL_TILE = 128 };
static const double least_stationary = 0.3, most_stationary = 0.05; /* sigma */

/* How often the tile can be halved: a pixel of the small one covers 2^level pixels a side. */
static uint32_t level_of(const weft_image* photo, const weft_stationary_options* options)
{
    uint32_t level = 0;
    uint32_t tile = options->width < options->height ? options->width : options->height;
    uint32_t side = photo->width < photo->height ? photo->width : photo->height;
    while (tile >> (level + 1) >= SMALL_TILE && side >> (level + 1) >= SMALL_TILE) level++;
    return level;
}

/* The photo at that mip level. The caller frees small->data. */
static int reduce(weft_context* context, const weft_image* photo, uint32_t level, weft_image* small)
{
    weft_model* model = NULL;
    weft_texture* texture = NULL;
    *small = *photo;
    small->width = photo->width >> level;
    small->height = photo->height >> level;
    small->format = WEFT_FORMAT_F32;
    small->stride = (int64_t)(sizeof(float) * photo->channels * small->width);
    small->data = malloc((size_t)small->stride * small->height);
    if (!small->data) return failed("out of memory");
    weft_status status = weft_analyze_picture(context, photo, &model);
    if (status == WEFT_OK) status = weft_texture_create(context, model, NULL, &texture);
    if (status == WEFT_OK) status = weft_texture_render(texture, 0, 0, level, NULL, NULL, small);
    weft_texture_free(texture);
    weft_model_free(model);
    return status == WEFT_OK ? EXIT_FINE : failed_weft(status);
}

static int measure_one(weft_context* context, const weft_image* photo, const weft_stationary_options* options,
                       const progress_span* span, double* cost)
{
    tile_result result = {NULL, 0, 0, 0, 0};
    weft_image tile = *photo;
    tile.width = options->width;
    tile.height = options->height;
    tile.stride = 0;
    tile.data = malloc(sizeof(float) * tile.channels * tile.width * tile.height);
    int code = tile.data ? make_tile(context, photo, options, span, &result) : failed("out of memory");
    if (code == EXIT_FINE) {
        weft_status status = weft_model_part_read(result.model, 0, &tile);
        code = status == WEFT_OK ? measure_tile(context, &tile, &result) : failed_weft(status);
    }
    *cost += (double)result.stationarity_cost / SEEDS;
    free(tile.data);
    weft_model_free(result.model);
    return code;
}

/* The nearest costs, by least squares, that do not ascend: neighbours that do are averaged (pool adjacent violators).
 */
static void make_monotone(double cost[SCALE_STEPS])
{
    double mean[SCALE_STEPS];
    int size[SCALE_STEPS], blocks = 0;
    for (int i = 0; i < SCALE_STEPS; i++) {
        mean[blocks] = cost[i];
        size[blocks++] = 1;
        for (; blocks > 1 && mean[blocks - 2] < mean[blocks - 1]; blocks--) {
            int both = size[blocks - 2] + size[blocks - 1];
            mean[blocks - 2] = (mean[blocks - 2] * size[blocks - 2] + mean[blocks - 1] * size[blocks - 1]) / both;
            size[blocks - 2] = both;
        }
    }
    for (int b = 0, i = 0; b < blocks; b++)
        for (int k = 0; k < size[b]; k++) cost[i++] = mean[b];
}

int measure_scale(weft_context* context, const weft_image* photo, const weft_stationary_options* options,
                  const progress_span* span, tile_scale* scale)
{
    weft_image small = {NULL, 0, 0, 0, 0, 0};
    weft_stationary_options tried = *options;
    uint32_t level = level_of(photo, options);
    tried.width >>= level;
    tried.height >>= level;
    int code = reduce(context, photo, level, &small);
    for (int i = 0; i < SCALE_STEPS * SEEDS && code == EXIT_FINE; i++) {
        double width = (span->to - span->from) / (SCALE_STEPS * SEEDS);
        const progress_span part = {span->from + width * i, span->from + width * (i + 1)};
        int step = i / SEEDS;
        if (i % SEEDS == 0) {
            scale->sigma[step] = least_stationary * pow(most_stationary / least_stationary, step / (SCALE_STEPS - 1.0));
            scale->cost[step] = 0;
        }
        tried.sigma = (float)scale->sigma[step];
        tried.seed = options->seed + (uint64_t)(i % SEEDS);
        code = measure_one(context, &small, &tried, &part, &scale->cost[step]);
    }
    if (code == EXIT_FINE) make_monotone(scale->cost);
    free(small.data);
    return code;
}

float sigma_of(const tile_scale* scale, double stationarity)
{
    const double *cost = scale->cost, *sigma = scale->sigma;
    double wanted = cost[0] + (cost[SCALE_STEPS - 1] - cost[0]) * stationarity;
    int i = 0;
    while (i < SCALE_STEPS - 2 && wanted < cost[i + 1]) i++;
    double range = cost[i] - cost[i + 1];
    double share = cost[0] > cost[SCALE_STEPS - 1] ? (range > 0 ? (cost[i] - wanted) / range : 0)
                                                   : stationarity * (SCALE_STEPS - 1) - i; /* a photo that is even */
    return (float)(sigma[i] * pow(sigma[i + 1] / sigma[i], share));
}
