/* Frame, grid, curves and bars. */
#include "plot.h"
#include "font.h"

#include <math.h>
#include <stdio.h>

enum { TEXT_SCALE = 2, LEFT = 84, BELOW = 60, ABOVE = 28, RIGHT = 18, GRID_LINES = 5 };

static float across(const plot* p, float x)
{
    return (float)p->area.x + (float)p->area.width * (x - p->x_low) / (p->x_high - p->x_low);
}

static float down(const plot* p, float y)
{
    const float t = (y - p->y_low) / (p->y_high - p->y_low);
    return (float)p->area.y + (float)p->area.height * (1 - (t < 0 ? 0 : t > 1 ? 1 : t));
}

/* A distance of grid lines that people count in: 1, 2 or 5 times a power of ten. */
static float grid_step(float range)
{
    const float rough = range / GRID_LINES, power = powf(10, floorf(log10f(rough)));
    return (rough <= power ? 1.0f : rough <= 2 * power ? 2.0f : rough <= 5 * power ? 5.0f : 10.0f) * power;
}

/* The i-th grid line from low on; 0 when there is none. */
static int grid_line(float low, float high, int i, float* value, char text[24])
{
    const float step = grid_step(high - low);
    *value = (ceilf(low / step - 1e-3f) + (float)i) * step;
    if (*value > high + 1e-3f * step) return 0;
    snprintf(text, 24, "%.4g", fabsf(*value) < 1e-3f * step ? 0.0 : (double)*value);
    return 1;
}

static void draw_grid(const plot* p)
{
    float value;
    char text[24];
    const rectangle a = p->area;
    for (int i = 0; grid_line(p->x_low, p->x_high, i, &value, text); i++) {
        const uint32_t x = (uint32_t)lrintf(across(p, value));
        const rectangle line = {x, a.y, 1, a.height};
        canvas_fill(p->canvas, line, COLOUR_GRID, 1);
        font_text(p->canvas, x - font_width(text, TEXT_SCALE) / 2, a.y + a.height + 10, TEXT_SCALE, COLOUR_INK, text);
    }
    for (int i = 0; grid_line(p->y_low, p->y_high, i, &value, text); i++) {
        const uint32_t y = (uint32_t)lrintf(down(p, value));
        const rectangle line = {a.x, y, a.width, 1};
        canvas_fill(p->canvas, line, COLOUR_GRID, 1);
        font_text(p->canvas, a.x - font_width(text, TEXT_SCALE) - 6, y - TEXT_SCALE * FONT_HEIGHT / 2, TEXT_SCALE,
                  COLOUR_INK, text);
    }
}

plot plot_begin(canvas* c, rectangle outer, plot_axis x, plot_axis y)
{
    const rectangle area = {outer.x + LEFT, outer.y + ABOVE, outer.width - LEFT - RIGHT, outer.height - ABOVE - BELOW};
    const rectangle edges[2] = {{area.x, area.y, 1, area.height}, {area.x, area.y + area.height, area.width, 1}};
    const plot p = {c, area, x.low, x.high, y.low, y.high};
    draw_grid(&p);
    for (int i = 0; i < 2; i++) canvas_fill(c, edges[i], COLOUR_FAINT, 1);
    font_text(c, area.x + (area.width - font_width(x.name, TEXT_SCALE)) / 2, area.y + area.height + 36, TEXT_SCALE,
              COLOUR_FAINT, x.name);
    font_text(c, outer.x, outer.y, TEXT_SCALE, COLOUR_FAINT, y.name);
    return p;
}

void plot_curve(const plot* p, const float* x, const float* y, uint32_t count, uint32_t colour)
{
    for (uint32_t i = 0; i + 1 < count; i++)
        canvas_line(p->canvas, across(p, x[i]), down(p, y[i]), across(p, x[i + 1]), down(p, y[i + 1]), 2, colour);
}

void plot_dot(const plot* p, float x, float y, uint32_t colour)
{
    canvas_line(p->canvas, across(p, x), down(p, y), across(p, x), down(p, y), 7, colour);
}

void plot_bar(const plot* p, float x0, float x1, float y, uint32_t colour, float opacity)
{
    const long left = lrintf(across(p, x0)), right = lrintf(across(p, x1)), top = lrintf(down(p, y));
    const long bottom = (long)(p->area.y + p->area.height);
    const rectangle bar = {(uint32_t)left, (uint32_t)top, (uint32_t)(right - left), (uint32_t)(bottom - top)};
    canvas_fill(p->canvas, bar, colour, opacity);
}

void plot_legend(const plot* p, uint32_t line, const char* text, uint32_t colour)
{
    enum { LINE = 22, SAMPLE = 24, SPACE = 8 };
    const uint32_t width = font_width(text, TEXT_SCALE);
    const uint32_t x = p->area.x + p->area.width - width, y = p->area.y + SPACE + line * LINE;
    const rectangle back = {x - SAMPLE - 2 * SPACE, y - SPACE / 2, width + SAMPLE + 2 * SPACE, LINE};
    const rectangle sample = {x - SAMPLE - SPACE, y + TEXT_SCALE * FONT_HEIGHT / 2 - 2, SAMPLE, 4};
    canvas_fill(p->canvas, back, COLOUR_PAPER, 0.8f);
    canvas_fill(p->canvas, sample, colour, 1);
    font_text(p->canvas, x, y, TEXT_SCALE, COLOUR_INK, text);
}

uint32_t channel_colour(uint32_t channel, uint32_t channels)
{
    static const uint32_t rgb[3] = {0xd2403c, 0x2f9a48, 0x3a66d0};
    return channels < 3 ? COLOUR_FAINT : channel < 3 ? rgb[channel] : series_colour(channel);
}

uint32_t series_colour(uint32_t index)
{
    static const uint32_t colours[6] = {0x2b6cb0, 0xdd7a1f, 0x4f9e4f, 0x8a5fb5, 0xb8453e, 0x7a6a58};
    return colours[index % 6];
}
