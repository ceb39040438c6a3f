/* Power spectra and histograms of photo and texture, side by side. */
#include "command.h"
#include "plot.h"
#include "sheet.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST_EDGE = 256, MOST_MEASURED = 3, BINS = 64, PLOT_HEIGHT = 360 };
static const float decibels = 70; /* that spectra show, from the greatest power downwards */

/* The images that are measured, all alike: the photo, the texture; of a mixed model its first and its last step. */
typedef struct measured {
    const weft_image* image[MOST_MEASURED];
    const char* name[MOST_MEASURED];
    float* power[MOST_MEASURED]; /* in decibels, edge x edge, all channels together */
    uint32_t count, edge;
    uint32_t plot_width; /* so that all plots are in one row */
} measured;

static void add(measured* m, const weft_image* image, const char* name)
{
    const uint32_t shorter = image->width < image->height ? image->width : image->height;
    m->image[m->count] = image;
    m->name[m->count++] = name;
    if (shorter < m->edge) m->edge = shorter;
}

static float* power_of(sheet* s, const weft_image* image, uint32_t edge)
{
    const size_t count = (size_t)edge * edge;
    float* values = sheet_memory(s, sizeof(float) * count * image->channels);
    float* power = sheet_memory(s, sizeof(float) * count);
    const weft_image spectrum = {values, 0, edge, edge, image->channels, WEFT_FORMAT_F32};
    if (s->code == EXIT_FINE) sheet_check(s, weft_power_spectrum(s->context, image, &spectrum));
    for (size_t i = 0; i < count && s->code == EXIT_FINE; i++) {
        power[i] = 1e-20f;
        for (uint32_t c = 0; c < image->channels; c++) power[i] += values[i * image->channels + c];
        power[i] = 10 * log10f(power[i] * (float)count); /* a density: white noise of variance v is at v everywhere */
    }
    free(values);
    return power;
}

static float greatest(const measured* m)
{
    float most = -200;
    for (uint32_t i = 0; i < m->count; i++)
        for (size_t k = 0; k < (size_t)m->edge * m->edge; k++) most = fmaxf(most, m->power[i][k]);
    return most;
}

static void show_spectra(sheet* s, const measured* m)
{
    const tones range = {greatest(m) - decibels, greatest(m)};
    const uint32_t scale = m->edge < PANEL ? PANEL / m->edge : 1;
    for (uint32_t i = 0; i < m->count; i++) {
        const weft_image image = {m->power[i], 0, m->edge, m->edge, 1, WEFT_FORMAT_F32};
        const rectangle at =
            sheet_panel(s, PANEL, PANEL, "spectrum: %s, %.0f dB", m->name[i], (double)(range.high - range.low));
        if (s->code == EXIT_FINE) canvas_image(&s->canvas, at, &image, scale, range);
    }
}

/* Mean power of the frequencies about k / edge, in all directions. */
static uint32_t average_around(const float* power, uint32_t edge, float* frequency, float* mean)
{
    const uint32_t count = edge / 2;
    uint32_t hits[MOST_EDGE / 2 + 1] = {0};
    for (uint32_t k = 0; k < count; k++) mean[k] = 0;
    for (uint32_t y = 0; y < edge; y++)
        for (uint32_t x = 0; x < edge; x++) {
            const float dx = (float)x - (float)(edge / 2), dy = (float)y - (float)(edge / 2);
            const uint32_t k = (uint32_t)lrintf(sqrtf(dx * dx + dy * dy));
            if (k == 0 || k >= count) continue;
            mean[k] += powf(10, power[(size_t)y * edge + x] / 10);
            hits[k]++;
        }
    for (uint32_t k = 1; k < count; k++) {
        frequency[k - 1] = log2f((float)k / (float)edge);
        mean[k - 1] = 10 * log10f(mean[k] / (float)hits[k]);
    }
    return count - 1;
}

static void show_profiles(sheet* s, const measured* m)
{
    float frequency[MOST_EDGE / 2], mean[MOST_MEASURED][MOST_EDGE / 2];
    float low = 200, high = -200;
    uint32_t count = 0;
    for (uint32_t i = 0; i < m->count; i++) {
        count = average_around(m->power[i], m->edge, frequency, mean[i]);
        for (uint32_t k = 0; k < count; k++) low = fminf(low, mean[i][k]), high = fmaxf(high, mean[i][k]);
    }
    const rectangle at = sheet_panel(s, m->plot_width, PLOT_HEIGHT, "power by frequency");
    if (s->code != EXIT_FINE || count < 2) return;
    const plot_axis x = {frequency[0], -1, "log2 cycles per pixel"}, y = {low - 2, high + 4, "dB"};
    const plot frame = plot_begin(&s->canvas, at, x, y);
    for (uint32_t i = 0; i < m->count; i++) {
        plot_curve(&frame, frequency, mean[i], count, series_colour(i));
        plot_legend(&frame, i, m->name[i], series_colour(i));
    }
}

/* Percent of the pixels in each bin, channel by channel; the caller frees them. */
static float* shares_of(sheet* s, const weft_image* image)
{
    const size_t count = (size_t)BINS * image->channels;
    uint64_t* hits = sheet_memory(s, sizeof *hits * count);
    float* shares = sheet_memory(s, sizeof *shares * count);
    if (s->code == EXIT_FINE) sheet_check(s, weft_histogram(s->context, image, 0, 1, BINS, hits));
    const float pixels = (float)image->width * (float)image->height;
    for (size_t i = 0; i < count && s->code == EXIT_FINE; i++) shares[i] = 100 * (float)hits[i] / pixels;
    free(hits);
    return shares;
}

static void draw_histogram(canvas* c, rectangle at, const float* shares, uint32_t channels, float most)
{
    const plot_axis x = {0, 1, "value"}, y = {0, most * 1.05f, "% of the pixels"};
    const plot frame = plot_begin(c, at, x, y);
    for (uint32_t channel = 0; channel < channels; channel++) {
        float edges[2 * BINS], values[2 * BINS];
        for (uint32_t i = 0; i < 2 * BINS; i++) {
            edges[i] = (float)((i + 1) / 2) / BINS;
            values[i] = shares[channel * BINS + i / 2];
            if (i % 2 == 0)
                plot_bar(&frame, edges[i], (float)(i / 2 + 1) / BINS, values[i], channel_colour(channel, channels),
                         0.25f);
        }
        plot_curve(&frame, edges, values, 2 * BINS, channel_colour(channel, channels));
    }
}

static void show_histograms(sheet* s, const measured* m)
{
    float *shares[MOST_MEASURED] = {NULL}, most = 0;
    const uint32_t channels = s->info.channels == 2 ? 1 : s->info.channels > 3 ? 3 : s->info.channels;
    for (uint32_t i = 0; i < m->count; i++) shares[i] = shares_of(s, m->image[i]);
    for (uint32_t i = 0; i < m->count && s->code == EXIT_FINE; i++)
        for (uint32_t k = 0; k < BINS * channels; k++) most = fmaxf(most, shares[i][k]);
    for (uint32_t i = 0; i < m->count && s->code == EXIT_FINE; i++) {
        const rectangle at = sheet_panel(s, m->plot_width, PLOT_HEIGHT, "histogram: %s", m->name[i]);
        if (s->code == EXIT_FINE) draw_histogram(&s->canvas, at, shares[i], channels, most);
    }
    for (uint32_t i = 0; i < m->count; i++) free(shares[i]);
}

void sheet_measures(sheet* s)
{
    measured m = {{NULL}, {NULL}, {NULL}, 0, MOST_EDGE, PANEL};
    if (s->code != EXIT_FINE) return;
    if (s->photo.data) add(&m, &s->photo, "photo");
    add(&m, &s->output[0], s->name[0]);
    if (sheet_is_mixed(s)) add(&m, &s->output[1], s->name[1]);
    if (m.count == 3) m.plot_width = (SHEET_CONTENT - 3 * SHEET_GAP) / 4;
    for (uint32_t i = 0; i < m.count; i++) m.power[i] = power_of(s, m.image[i], m.edge);
    if (s->code == EXIT_FINE) {
        show_spectra(s, &m);
        if (m.count > 1) sheet_row(s);
        show_profiles(s, &m);
        show_histograms(s, &m);
    }
    for (uint32_t i = 0; i < m.count; i++) free(m.power[i]);
}
