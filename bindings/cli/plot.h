/* Small plots on a canvas: a frame with numbered grid lines, curves and bars in it. */
#ifndef WEFT_CLI_PLOT_H
#define WEFT_CLI_PLOT_H

#include "canvas.h"

typedef struct plot {
    canvas* canvas;
    rectangle area; /* within the frame */
    float x_low, x_high, y_low, y_high;
} plot;

typedef struct plot_axis {
    float low, high;
    const char* name;
} plot_axis;

/* Draws frame, grid and numbers within `outer`. */
plot plot_begin(canvas* c, rectangle outer, plot_axis x, plot_axis y);

void plot_curve(const plot* p, const float* x, const float* y, uint32_t count, uint32_t colour);
void plot_dot(const plot* p, float x, float y, uint32_t colour);

/* A bar from the lower edge up to y, from x0 to x1. */
void plot_bar(const plot* p, float x0, float x1, float y, uint32_t colour, float opacity);

/* Names a colour: line by line in the upper right corner. */
void plot_legend(const plot* p, uint32_t line, const char* text, uint32_t colour);

/* Colours that are told apart easily: of channels (red, green and blue for three) and of other things. */
uint32_t channel_colour(uint32_t channel, uint32_t channels);
uint32_t series_colour(uint32_t index);

#endif
