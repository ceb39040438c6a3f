/* Wavelet noise drawn: each band by itself, weights, tone curves, principal axes. */
#include "sheet_wavelet.h"
#include "command.h"
#include "plot.h"
#include "wavelet_json.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const float shown_deviation = 0.16f; /* of a band that is drawn alone */

/* The band alone, Gaussian, about the mean, as strong as all others. */
static weft_wavelet only_band(const weft_wavelet* from, uint32_t band)
{
    weft_wavelet alone = *from;
    float square = 0;
    for (uint32_t p = 0; p < from->channels; p++) square += from->weight[band][p] * from->weight[band][p];
    const float factor = square > 0 ? shown_deviation * sqrtf((float)from->channels / square) : 0;
    alone.knots = 0;
    for (uint32_t b = 0; b < from->bands; b++)
        for (uint32_t p = 0; p < from->channels; p++) alone.weight[b][p] = b == band ? from->weight[b][p] * factor : 0;
    for (uint32_t k = 0; k < 32; k++)
        for (uint32_t p = 0; p < 16; p++) alone.knot_x[k][p] = alone.knot_y[k][p] = alone.knot_slope[k][p] = 0;
    for (uint32_t c = 0; c < from->channels; c++) alone.mean[c] = 0.5f;
    return alone;
}

static void show_band(sheet* s, rectangle at, const weft_wavelet* alone)
{
    const tones plain = {0, 1};
    const weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    weft_model* model = NULL;
    weft_image image = {NULL, 0, 0, 0, 0, 0};
    if (s->code == EXIT_FINE) sheet_check(s, weft_model_from_wavelet(s->context, alone, &model));
    if (s->code == EXIT_FINE) sheet_render(s, model, &options, 0, at.width, at.height, &image);
    if (s->code == EXIT_FINE) canvas_image(&s->canvas, at, &image, 1, plain);
    free(image.data);
    weft_model_free(model);
}

static void show_bands(sheet* s, const weft_wavelet* w)
{
    enum { SEAM = 4 };
    const uint32_t columns = (uint32_t)ceilf(sqrtf((float)w->bands)), edge = (PANEL + SEAM) / columns;
    const rectangle at = sheet_panel(s, PANEL, PANEL, "bands 1 to %u alone, equally strong", w->bands);
    for (uint32_t b = 0; b < w->bands; b++) {
        const weft_wavelet alone = only_band(w, b);
        const rectangle cell = {at.x + b % columns * edge, at.y + b / columns * edge, edge - SEAM, edge - SEAM};
        show_band(s, cell, &alone);
    }
}

static void show_weights(sheet* s, const weft_wavelet* w)
{
    float most = 1e-6f;
    for (uint32_t b = 0; b < w->bands; b++)
        for (uint32_t p = 0; p < w->channels; p++) most = fmaxf(most, w->weight[b][p]);
    const rectangle at = sheet_panel(s, PANEL, PANEL, "weights of the bands");
    const plot_axis x = {0.5f, (float)w->bands + 0.5f, "band, from the finest"}, y = {0, most * 1.3f, "weight"};
    if (s->code != EXIT_FINE) return;
    const plot frame = plot_begin(&s->canvas, at, x, y);
    const float wide = 0.8f / (float)w->channels;
    for (uint32_t p = 0; p < w->channels; p++) {
        char text[16];
        for (uint32_t b = 0; b < w->bands; b++) {
            const float left = (float)b + 0.6f + wide * (float)p;
            plot_bar(&frame, left, left + wide, w->weight[b][p], series_colour(p), 1);
        }
        snprintf(text, sizeof text, "axis %u", p + 1);
        plot_legend(&frame, p, text, series_colour(p));
    }
}

/* The Hermite spline between its knots. */
static float tone_at(const weft_wavelet* w, uint32_t p, float v)
{
    uint32_t k = 0;
    while (k + 2 < w->knots && v > w->knot_x[k + 1][p]) k++;
    const float wide = w->knot_x[k + 1][p] - w->knot_x[k][p], t = (v - w->knot_x[k][p]) / wide, u = 1 - t;
    return w->knot_y[k][p] * (1 + 2 * t) * u * u + w->knot_slope[k][p] * wide * t * u * u +
           w->knot_y[k + 1][p] * (1 + 2 * u) * t * t - w->knot_slope[k + 1][p] * wide * u * t * t;
}

static void show_curve(const plot* frame, const weft_wavelet* w, uint32_t p)
{
    enum { POINTS = 128 };
    float x[POINTS], y[POINTS];
    const float from = w->knot_x[0][p], to = w->knot_x[w->knots - 1][p];
    if (!(to > from)) return;
    for (uint32_t i = 0; i < POINTS; i++) {
        x[i] = from + (to - from) * (float)i / (POINTS - 1);
        y[i] = tone_at(w, p, x[i]);
    }
    plot_curve(frame, x, y, POINTS, series_colour(p));
    for (uint32_t k = 0; k < w->knots; k++) plot_dot(frame, w->knot_x[k][p], w->knot_y[k][p], series_colour(p));
}

static void show_tones(sheet* s, const weft_wavelet* w)
{
    float reach = 1e-6f;
    for (uint32_t k = 0; k < w->knots; k++)
        for (uint32_t p = 0; p < w->channels; p++)
            reach = fmaxf(reach, fmaxf(fabsf(w->knot_x[k][p]), fabsf(w->knot_y[k][p])));
    reach *= 1.05f;
    const rectangle at = sheet_panel(s, PANEL, PANEL, "tone curves");
    const plot_axis x = {-reach, reach, "noise"}, y = {-reach, reach, "value on the axis"};
    if (s->code != EXIT_FINE) return;
    const plot frame = plot_begin(&s->canvas, at, x, y);
    for (uint32_t p = 0; p < w->channels; p++) {
        char text[16];
        show_curve(&frame, w, p);
        snprintf(text, sizeof text, "axis %u", p + 1);
        plot_legend(&frame, p, text, series_colour(p));
    }
}

/* One row for each axis: the colours from two deviations below the mean to two above it. */
static void show_axes(sheet* s, const weft_wavelet* w)
{
    enum { HEIGHT = 28, SHOWN = 3 };
    const tones plain = {0, 1};
    const uint32_t rows = w->channels < SHOWN ? w->channels : SHOWN;
    const rectangle at = sheet_panel(s, SHEET_CONTENT, rows * HEIGHT,
                                     "principal axes, from two deviations below the mean to two above it");
    float* ramp = sheet_memory(s, sizeof(float) * SHEET_CONTENT * w->channels);
    for (uint32_t p = 0; p < rows && s->code == EXIT_FINE; p++) {
        float square = 0;
        for (uint32_t b = 0; b < w->bands; b++) square += w->weight[b][p] * w->weight[b][p];
        for (uint32_t x = 0; x < SHEET_CONTENT; x++)
            for (uint32_t c = 0; c < w->channels; c++)
                ramp[x * w->channels + c] =
                    w->mean[c] + w->axes[p][c] * sqrtf(square) * (4 * (float)x / (SHEET_CONTENT - 1) - 2);
        const weft_image image = {ramp, 0, SHEET_CONTENT, 1, w->channels, WEFT_FORMAT_F32};
        for (uint32_t y = 0; y + 4 < HEIGHT; y++) {
            const rectangle row = {at.x, at.y + p * HEIGHT + y, SHEET_CONTENT, 1};
            canvas_image(&s->canvas, row, &image, 1, plain);
        }
    }
    free(ramp);
}

void sheet_wavelet(sheet* s)
{
    weft_wavelet wavelet;
    if (s->code != EXIT_FINE) return;
    s->code = get_wavelet(s->model, &wavelet);
    if (s->code != EXIT_FINE) return;
    show_bands(s, &wavelet);
    show_weights(s, &wavelet);
    if (wavelet.knots > 0) show_tones(s, &wavelet);
    show_axes(s, &wavelet);
}
