/* TILE's content exchange, for field.h. */
#ifndef WEFT_FIELD_EXCHANGE_H
#define WEFT_FIELD_EXCHANGE_H

#include "field_numbers.h"
#include "field_tile.h"

#define WEFT_TAG_CONTENTS 2
#define WEFT_CONTOUR_SIDE 24 /* depths on each side of the square around an anchor */

/* An entry of the map, as backend.h's WEFT_MAP_... put it together. */
static inline weft_u32 weft_map_patch(weft_u32 entry) { return entry & 0x3fffff; }
static inline float weft_map_depth(weft_u32 entry) { return (float)(weft_i32)((entry >> 22) & 0xff); }
static inline weft_u32 weft_map_left(weft_u32 entry) { return (entry >> 30) & 1; }
static inline weft_u32 weft_map_above(weft_u32 entry) { return entry >> 31; }

/* Depth of a position: the weft_pair_at of level 0 of both axes of the map, its four entries' depths, rows first. */
static inline float weft_depth(float a, float b, float c, float d, float tx, float ty)
{
    return weft_lerp(weft_lerp(a, b, tx), weft_lerp(c, d, tx), ty);
}

/* A patch takes its first content whose threshold is above this; `key` is weft_key of the tag. */
static inline weft_u32 weft_content_draw(weft_u64 key, weft_i64 cell_x, weft_i64 cell_y, weft_u32 patch)
{
    return weft_high(weft_absorb(weft_absorb(weft_absorb(key, (weft_u64)cell_x), (weft_u64)cell_y), patch));
}

/* One axis of a position as seen from an anchor; `before` is 1 if the patch began in the cell before. */
static inline float weft_from_anchor(weft_i32 texel, float fraction, weft_u32 before, weft_u32 size, weft_i32 anchor)
{
    return (float)(texel + (weft_i32)(before * size) - anchor) + fraction;
}

/* Where the direction of (x, y) crosses the square around an anchor: between two of its depths, at t. */
typedef struct weft_direction {
    weft_u32 first, second;
    float t;
} weft_direction;

static inline weft_direction weft_direction_of(float x, float y)
{
    const float size_x = x < 0.0f ? -x : x, size_y = y < 0.0f ? -y : y;
    const weft_u32 steep = size_y <= size_x ? 0 : 1;
    const weft_u32 back = (steep != 0 ? y : x) >= 0.0f ? 0 : 1;
    const float beside = steep != 0 ? x : y, size = steep != 0 ? size_y : size_x;
    const float ratio = (steep == back ? beside : -beside) / (size > WEFT_FRACTION_UNIT ? size : WEFT_FRACTION_UNIT);
    const float s = (ratio + 1.0f) * (float)(WEFT_CONTOUR_SIDE / 2);
    const weft_i32 whole = (weft_i32)s;
    weft_direction at;
    at.t = s - (float)whole;
    at.first = WEFT_CONTOUR_SIDE * (2 * back + steep) + (weft_u32)whole;
    at.first = at.first >= 4 * WEFT_CONTOUR_SIDE ? at.first - 4 * WEFT_CONTOUR_SIDE : at.first;
    at.second = at.first + 1 == 4 * WEFT_CONTOUR_SIDE ? 0 : at.first + 1;
    return at;
}

/* Share of the content, from the position's depth and the contour's in its direction. 0 at a patch's border for every
 * contour and every feather. */
static inline float weft_content_share(float depth, float contour, float feather)
{
    const float inside = (depth - contour) * feather + 0.5f, below = depth * feather;
    return inside < below ? inside : below;
}

/* One axis of where a content looks: `corner` is the source's texel under the anchor, `s` the position, turned. The
 * texel has to be wrapped. */
static inline weft_place weft_content_place(weft_i32 corner, float s)
{
    const weft_i32 whole = weft_floor(s);
    weft_place at;
    at.cell = 0;
    at.texel = corner + whole;
    at.fraction = s - (float)whole;
    return at;
}

/* Modulo a size: seldom outside it, and divisions are slow. */
static inline weft_i32 weft_wrap(weft_i32 texel, weft_u32 size)
{
    const weft_i32 length = (weft_i32)size;
    if (texel >= 0 && texel < length) return texel;
    texel %= length;
    return texel < 0 ? texel + length : texel;
}

#endif
