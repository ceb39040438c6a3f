/* TILE, for field.h. */
#ifndef WEFT_FIELD_TILE_H
#define WEFT_FIELD_TILE_H

#include "field_numbers.h"

/* TILE ------------------------------------------------------------------------------------------------------------- */

/* `added` is tile.level; the last level lasts for ever. */
static inline weft_between weft_tile_level(float level, float added, weft_u32 levels)
{
    return weft_level(weft_clamp(level + added, 0.0f, (float)(levels - 1)));
}

/* One axis of a position in a cell: texel and fraction of `size` texels. */
typedef struct weft_place {
    weft_i64 cell;
    weft_i32 texel;
    float fraction;
} weft_place;

/* Pixel x with fraction of 2^24, on a grid of `cells` cells on `span` pixels; period 0: none. */
static inline weft_place weft_locate(weft_i64 x, weft_u32 fraction, weft_u32 period, weft_u32 span, weft_u32 cells,
                                     float inverse, float step, weft_u32 size)
{
    const weft_i64 pixel = period != 0 ? x - weft_divide_down(x, period) * (weft_i64)period : x;
    const weft_i64 n = pixel * (weft_i64)cells;
    const weft_i64 cell = weft_divide_down(n, span);
    const weft_i64 scaled = (n - cell * (weft_i64)span) * (weft_i64)size;
    const weft_i64 texel = scaled / (weft_i64)span;
    const float rest = (float)(scaled - texel * (weft_i64)span);
    const float s = ((float)(weft_i32)fraction * WEFT_FRACTION_UNIT) * step + rest * inverse;
    const weft_i32 whole = weft_floor(s);
    weft_place at;
    at.cell = cell;
    at.texel = (weft_i32)texel + whole;
    at.fraction = s - (float)whole;
    if (at.texel >= (weft_i32)size) {
        at.texel -= (weft_i32)size;
        at.cell += 1;
        if (period != 0 && at.cell == (weft_i64)cells) at.cell = 0;
    }
    return at;
}

/* The cells beside a cell; `cells` of them to a period, 0: endless. */
static inline weft_i64 weft_cell_after(weft_i64 cell, weft_u32 cells)
{
    return cells != 0 && cell + 1 == (weft_i64)cells ? 0 : cell + 1;
}

static inline weft_i64 weft_cell_before(weft_i64 cell, weft_u32 cells)
{
    return cells != 0 && cell == 0 ? (weft_i64)cells - 1 : cell - 1;
}

/* Moved by a displacement in pixels. What is not a number counts as the lower bound, so that texels stay in bounds. */
static inline weft_place weft_displace(weft_place at, float pixels, float step, weft_u32 size, weft_u32 cells)
{
    const weft_i32 length = (weft_i32)size;
    const float limit = (float)(length - 1), wanted = pixels * step;
    const float above = wanted > -limit ? wanted : -limit;
    const float s = at.fraction + (above < limit ? above : limit);
    const weft_i32 whole = weft_floor(s);
    at.fraction = s - (float)whole;
    at.texel += whole;
    if (at.texel < 0) {
        at.texel += length;
        at.cell = weft_cell_before(at.cell, cells);
    } else if (at.texel >= length) {
        at.texel -= length;
        at.cell = weft_cell_after(at.cell, cells);
    }
    return at;
}

/* The two texels of an axis around a place, in a level of `size` texels, and the weight of the second. */
typedef struct weft_pair {
    weft_i32 first, second;
    float t;
} weft_pair;

/* `scale` is the level's scale, read above level 0 only. f = lerp of two rows, each a lerp of two texels. */
static inline weft_pair weft_pair_at(weft_place at, weft_i32 level, float scale, weft_u32 size)
{
    const float s = level == 0 ? at.fraction - 0.5f : ((float)at.texel + at.fraction) * scale - 0.5f;
    const weft_i32 whole = weft_floor(s), length = (weft_i32)size;
    weft_pair pair;
    pair.t = s - (float)whole;
    pair.first = level == 0 ? at.texel + whole : whole;
    pair.first = pair.first < 0 ? pair.first + length : pair.first;
    pair.first = pair.first >= length ? pair.first - length : pair.first;
    pair.second = pair.first + 1 == length ? 0 : pair.first + 1;
    return pair;
}

#endif
