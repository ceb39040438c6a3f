/* The costs of stationarity and of texture against plain evaluations of what weft.h says, and what they tell apart. */
#include "stained.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static weft_context *context;

static int begin(void **state)
{
    (void)state;
    context = new_context("scalar", 2);
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_context_free(context);
    return 0;
}

/* Weights of all pixels at a position, which sum up to 1. */
static void weigh(double *weights, uint32_t width, uint32_t height, double x, double y, double sigma)
{
    double sum = 0;
    for (uint32_t j = 0; j < height; ++j)
        for (uint32_t i = 0; i < width; ++i) {
            double dx = fabs(i + 0.5 - x), dy = fabs(j + 0.5 - y);
            dx = dx < width - dx ? dx : width - dx;
            dy = dy < height - dy ? dy : height - dy;
            sum += weights[j * width + i] = exp(-0.5 * (dx * dx + dy * dy) / (sigma * sigma));
        }
    for (uint32_t i = 0; i < width * height; ++i) weights[i] /= sum;
}

enum { BINS = 64, ORDERS = 4 };

typedef struct Descriptor {
    double cumulated[3][BINS], moments[3][ORDERS];
} Descriptor;

static void range_of(const weft_image *lab, uint32_t c, double *low, double *step)
{
    double high = *low = (double)values(lab)[c];
    for (size_t i = 0; i < (size_t)lab->width * lab->height; ++i) {
        const double value = (double)values(lab)[i * lab->channels + c];
        *low = value < *low ? value : *low;
        high = value > high ? value : high;
    }
    *step = (high - *low) / (BINS - 1);
}

static void describe(const weft_image *lab, const double *weights, Descriptor *to)
{
    memset(to, 0, sizeof *to);
    for (uint32_t c = 0; c < lab->channels; ++c) {
        double low, step, mean = 0, central[5] = {0, 0, 0, 0, 0};
        range_of(lab, c, &low, &step);
        for (uint32_t i = 0; i < lab->width * lab->height; ++i) {
            const double value = (double)values(lab)[i * lab->channels + c], place = (value - low) / step;
            mean += weights[i] * value;
            for (int k = 0; k < BINS; ++k) /* of two neighbours, each the nearer the more */
                to->cumulated[c][k] += weights[i] * fmax(0, fmin(1, k + 1 - place));
        }
        for (uint32_t i = 0; i < lab->width * lab->height; ++i)
            for (int p = 2; p <= 4; ++p)
                central[p] += weights[i] * pow((double)values(lab)[i * lab->channels + c] - mean, p);
        to->moments[c][0] = mean;
        to->moments[c][1] = sqrt(central[2]);
        to->moments[c][2] = cbrt(central[3]);
        to->moments[c][3] = sqrt(sqrt(central[4]));
    }
}

static double distance(const weft_image *lab, const Descriptor *a, const Descriptor *b, weft_stationarity measure,
                       uint32_t moments)
{
    double sum = 0;
    for (uint32_t c = 0; c < lab->channels; ++c) {
        double low, step;
        range_of(lab, c, &low, &step);
        if (measure == WEFT_STATIONARITY_HISTOGRAM)
            for (int k = 0; k < BINS - 1; ++k) sum += step * fabs(a->cumulated[c][k] - b->cumulated[c][k]);
        else
            for (uint32_t k = 0; k < moments; ++k) sum += pow(a->moments[c][k] - b->moments[c][k], 2);
    }
    return sum;
}

static void check_cost(const weft_image *image, weft_stationarity measure, uint32_t moments, float sigma)
{
    enum { COLUMNS = 7, ROWS = 5, PLACES = COLUMNS * ROWS };
    static Descriptor descriptors[PLACES];
    weft_image lab = new_lab(image), map = new_image(COLUMNS, ROWS, 1, WEFT_FORMAT_F32);
    const double deviation = (double)sigma * (image->width < image->height ? image->width : image->height);
    double *weights = malloc(sizeof *weights * image->width * image->height), mean = 0;
    assert_non_null(weights);
    for (int i = 0; i < PLACES; ++i) {
        weigh(weights, image->width, image->height, (i % COLUMNS + 0.5) * image->width / COLUMNS,
              (i / COLUMNS + 0.5) * image->height / ROWS, deviation);
        describe(&lab, weights, &descriptors[i]);
    }
    weft_stationarity_options options = WEFT_STATIONARITY_OPTIONS_INIT;
    options.stationarity = measure;
    options.sigma = sigma;
    options.moments = moments;
    float cost = -1;
    assert_ok(weft_stationarity_cost(context, image, &options, NULL, NULL, &map, &cost));
    for (int i = 0; i < PLACES; ++i) {
        double sum = 0;
        for (int j = 0; j < PLACES; ++j) sum += distance(&lab, &descriptors[i], &descriptors[j], measure, moments);
        sum /= PLACES;
        mean += sum / PLACES;
        if (!(fabs((double)values(&map)[i] - sum) <= 0.003 * sum + 1e-4))
            print_error("measure %d at %d: %g, should be %g\n", (int)measure, i, (double)values(&map)[i], sum);
        assert_true(fabs((double)values(&map)[i] - sum) <= 0.003 * sum + 1e-4);
    }
    assert_true(fabs((double)cost - mean) <= 0.003 * mean);
    free(weights);
    free_image(&map);
    free_image(&lab);
}

static void stationarity_is_what_the_header_says(void **state)
{
    (void)state;
    weft_image colours = new_stained(STAIN_HALF, 24, 19, 2), grey = new_stained_maps(17, 30, 2, 3);
    check_cost(&colours, WEFT_STATIONARITY_HISTOGRAM, 2, 0.1f);
    check_cost(&colours, WEFT_STATIONARITY_HISTOGRAM, 2, 0.4f);
    check_cost(&grey, WEFT_STATIONARITY_HISTOGRAM, 2, 0.15f);
    for (uint32_t moments = 1; moments <= 4; ++moments) check_cost(&colours, WEFT_STATIONARITY_MOMENTS, moments, 0.2f);
    check_cost(&grey, WEFT_STATIONARITY_MOMENTS, 4, 0.1f);
    free_image(&colours);
    free_image(&grey);
}

static float cost_of(const weft_image *image, weft_stationarity measure)
{
    weft_stationarity_options options = WEFT_STATIONARITY_OPTIONS_INIT;
    float cost = -1;
    options.stationarity = measure;
    assert_ok(weft_stationarity_cost(context, image, &options, NULL, NULL, NULL, &cost));
    return cost;
}

/* The stripes of one half lie across those of the other: the same histograms everywhere, but not of directions. */
static weft_image striped(int turned)
{
    weft_image image = new_image(64, 64, 1, WEFT_FORMAT_F32);
    for (uint32_t y = 0; y < 64; ++y)
        for (uint32_t x = 0; x < 64; ++x)
            values(&image)[64 * y + x] = (turned && x >= 32 ? y : x) / 4 % 2 ? 0.6f : 0.4f;
    return image;
}

static void measures_see_what_they_promise(void **state)
{
    (void)state;
    weft_image even = striped(0), turned = striped(1), one = new_image(20, 20, 3, WEFT_FORMAT_U8);
    assert_true(cost_of(&even, WEFT_STATIONARITY_HISTOGRAM) < 0.01f);
    assert_true(cost_of(&turned, WEFT_STATIONARITY_HISTOGRAM) < 1); /* stripes are 20 apart; some are cut */
    assert_true(cost_of(&turned, WEFT_STATIONARITY_STEERABLE) > 10 * cost_of(&even, WEFT_STATIONARITY_STEERABLE));
    fill_bytes(&one, 77);
    for (weft_stationarity measure = 0; measure <= 3; ++measure) assert_true(cost_of(&one, measure) == 0);
    free_image(&even);
    free_image(&turned);
    free_image(&one);
}

/* Where the usual grid is one position a pixel, it is the map of that size. */
static void the_usual_grid(void **state)
{
    (void)state;
    weft_image image = new_stained(STAIN_LIGHT, 30, 20, 5), map = new_image(30, 20, 1, WEFT_FORMAT_F32);
    float cost = -1;
    assert_ok(weft_stationarity_cost(context, &image, NULL, NULL, NULL, &map, &cost));
    assert_true(cost == cost_of(&image, WEFT_STATIONARITY_DEFAULT));
    free_image(&image);
    free_image(&map);
}

/* The squared distance of the nearest patch, over all patches of the output. */
static double mean_nearest(const weft_image *exemplar, const weft_image *output, uint32_t patch)
{
    double sum = 0;
    for (uint32_t y = 0; y < output->height; ++y)
        for (uint32_t x = 0; x < output->width; ++x) {
            double least = HUGE_VAL;
            for (uint32_t v = 0; v + patch <= exemplar->height; ++v)
                for (uint32_t u = 0; u + patch <= exemplar->width; ++u) {
                    double distance = 0;
                    for (uint32_t j = 0; j < patch && distance < least; ++j)
                        for (uint32_t i = 0; i < patch; ++i)
                            for (uint32_t c = 0; c < output->channels; ++c) {
                                const double d =
                                    (double)value_at(exemplar, u + i, v + j, c) -
                                    (double)value_at(output, (x + i) % output->width, (y + j) % output->height, c);
                                distance += d * d;
                            }
                    least = distance < least ? distance : least;
                }
            sum += least;
        }
    return sum / ((double)output->width * output->height * patch * patch);
}

static float texture_cost(const weft_image *exemplar, const weft_image *output, uint32_t patch, uint32_t samples)
{
    weft_texture_cost_options options = WEFT_TEXTURE_COST_OPTIONS_INIT;
    float cost = -1;
    options.patch = patch;
    options.samples = samples;
    assert_ok(weft_texture_cost(context, exemplar, output, &options, NULL, NULL, &cost));
    return cost;
}

/* With many times more samples than there are patches, the random mean is the mean: its error is about 1 % here. */
static void texture_is_what_the_header_says(void **state)
{
    (void)state;
    const uint32_t patches[] = {1, 2, 5, 11};
    weft_image exemplar = new_stained(STAIN_BLOB, 37, 30, 1), output = new_stained(STAIN_LIGHT, 14, 13, 2);
    weft_image lab = new_lab(&exemplar), other = new_lab(&output);
    for (int i = 0; i < 4; ++i) {
        const double expected = mean_nearest(&lab, &other, patches[i]);
        const double cost = (double)texture_cost(&exemplar, &output, patches[i], scaled(1 << 15, 1 << 13));
        if (!(fabs(cost - expected) < 0.02 * expected))
            print_error("patch %u: %g, should be %g\n", patches[i], cost, expected);
        assert_true(fabs(cost - expected) < 0.02 * expected);
    }
    free_image(&lab);
    free_image(&other);
    free_image(&exemplar);
    free_image(&output);
}

/* Every patch of a tile is in four tiles. */
static void copies_cost_nothing(void **state)
{
    (void)state;
    weft_image tile = new_stained(STAIN_HALF, 23, 17, 4), four = new_image(46, 34, 3, WEFT_FORMAT_F32);
    for (uint32_t y = 0; y < 34; ++y)
        for (uint32_t x = 0; x < 46; ++x)
            for (uint32_t c = 0; c < 3; ++c) values(&four)[(y * 46 + x) * 3 + c] = value_at(&tile, x % 23, y % 17, c);
    assert_true(texture_cost(&four, &tile, 0, 0) == 0);
    assert_true(texture_cost(&tile, &tile, 0, 0) > 0);
    free_image(&four);
    free_image(&tile);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stationarity_is_what_the_header_says),
        cmocka_unit_test(measures_see_what_they_promise),
        cmocka_unit_test(the_usual_grid),
        cmocka_unit_test(texture_is_what_the_header_says),
        cmocka_unit_test(copies_cost_nothing),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
