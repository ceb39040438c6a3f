/* TILE with WEFT_ADDRESS_WANG, for field.h: a cell composed of the diamonds of its four edges. */
#ifndef WEFT_FIELD_WANG_H
#define WEFT_FIELD_WANG_H

#include "field_numbers.h"
#include "field_tile.h"

#define WEFT_TAG_NORTH 0
#define WEFT_TAG_WEST 1

/* Colour of the edge of a cell; `key` is weft_key of one of the two tags. */
static inline weft_u32 weft_wang_colour(weft_u64 key, weft_i64 cell_x, weft_i64 cell_y, weft_u32 colours)
{
    const weft_u64 hash = weft_absorb(weft_absorb(key, (weft_u64)cell_x), (weft_u64)cell_y);
    return (weft_u32)(((weft_u64)weft_high(hash) * colours) >> 32);
}

/* One axis of a position: which half of the cell, the texel as seen from an edge across this axis (in a rectangle as
 * large as the cell and centred on that edge), and the distance from the nearer such edge in intervals of a contour. */
typedef struct weft_half {
    weft_u32 second;
    weft_i32 texel;
    float distance;
} weft_half;

static inline weft_half weft_half_at(weft_place at, weft_u32 size, float unit)
{
    const weft_i32 length = (weft_i32)size, middle = length / 2;
    weft_half part;
    part.second = at.texel >= middle ? 1 : 0;
    part.texel = part.second != 0 ? at.texel - middle : at.texel + middle;
    part.distance = part.second != 0 ? (float)(length - at.texel) - at.fraction : (float)at.texel + at.fraction;
    part.distance = part.distance * unit;
    return part;
}

/* Texel of a source of `size`, in the diamond that begins at `corner`. */
static inline weft_i32 weft_wang_texel(weft_i32 corner, weft_i32 texel, weft_u32 size)
{
    const weft_i32 sum = corner + texel;
    return sum >= (weft_i32)size ? sum - (weft_i32)size : sum;
}

/* Which contour parts the two views of a quarter: rows of knots + 1 depths. */
static inline weft_u32 weft_wang_contour(weft_u32 south, weft_u32 east, weft_u32 north_colour, weft_u32 west_colour,
                                         weft_u32 colours)
{
    return ((2 * south + east) * colours + north_colour) * colours + west_colour;
}

/* A position along and across the line from a cell's corner to its centre: between knots k and k + 1, at t. */
typedef struct weft_knot {
    weft_i32 k;
    float t, across;
} weft_knot;

static inline weft_knot weft_wang_knot(float distance_x, float distance_y, weft_u32 knots)
{
    const float along = distance_x + distance_y;
    const weft_i32 whole = (weft_i32)along, last = (weft_i32)knots - 1;
    weft_knot at;
    at.k = whole < last ? whole : last;
    at.t = along - (float)at.k;
    at.across = distance_x - distance_y;
    return at;
}

/* Share of the north or south edge's view, from depths and sharpnesses of the two knots. 0: the other view; 1: this
 * one; else weft_lerp(other, this, share). */
static inline float weft_wang_share(weft_knot at, float depth, float next_depth, float sharp, float next_sharp)
{
    const float inside = at.across - weft_lerp(depth, next_depth, at.t);
    return weft_clamp(inside * weft_lerp(sharp, next_sharp, at.t) + 0.5f, 0.0f, 1.0f);
}

#endif
