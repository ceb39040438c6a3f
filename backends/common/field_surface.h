/* SPLAT on surfaces, for field.h. */
#ifndef WEFT_FIELD_SURFACE_H
#define WEFT_FIELD_SURFACE_H

#include "field_splat.h"

/* SPLAT: surfaces ---------------------------------------------------------------------------------------------------
 *
 * Cells have three axes: K = absorb(absorb(absorb(weft_key(seed, stream, WEFT_TAG_IMPACTS), cell x), cell y), cell z).
 * Impact i is made of z = weft_draw(K, i + 1) as in the plane; its z axis of weft_low(weft_third(z)). Impacts whose
 * pixel is further than weft_surface_reach from the spot's on any axis are dropped. An impact adds, where
 * weft_surface_fade is above 0: A = weft_madd(fade * sign, v, A), and f = A + offset. Two taps: v is the weft_lerp of
 * two rows, each the weft_lerp of two texels; other numbers as in the plane, the columns by fma, then v_i by fma: v =
 * wx_0 * v_0, then v = fma(wx_i, v_i, v). */

static inline weft_u64 weft_third(weft_u64 z) { return weft_mix(z + WEFT_GOLDEN); }

/* Twice the furthest that an axis of a texton reaches from its middle: `size` texels at level 0; `first` and `count`
 * are of the level. */
static inline weft_i64 weft_surface_extent(weft_u32 size, weft_i32 first, weft_u32 count, weft_u32 taps, weft_u32 level)
{
    const weft_i64 texel = (weft_i64)1 << level, twice = 2 * (weft_i64)first;
    const weft_i64 low = (weft_i64)size - (twice + 1 - (weft_i64)taps) * texel;
    const weft_i64 high = (twice + 2 * (weft_i64)count - 1 + (weft_i64)taps) * texel - (weft_i64)size;
    return low > high ? low : high;
}

/* Half the side, in pixels, of the cube that holds all impacts that reach a spot however its frame is turned.
 * `thickness` is the larger of the sizes at level 0. */
static inline weft_i64 weft_surface_reach(weft_i64 extent_x, weft_i64 extent_y, weft_u32 thickness)
{
    const weft_i64 square = extent_x * extent_x + extent_y * extent_y + (weft_i64)thickness * (weft_i64)thickness;
    weft_i64 low = 0, high = (weft_i64)1 << 30;
    while (low < high) {
        const weft_i64 middle = (low + high) >> 1;
        if (4 * middle * middle >= square)
            high = middle;
        else
            low = middle + 1;
    }
    return low + 2;
}

/* An axis of the difference between a spot and an impact, both with fractions of 2^24, in pixels. */
static inline float weft_surface_difference(weft_i64 pixels, weft_i32 spot_fraction, weft_i32 impact_fraction)
{
    return (float)(pixels * 16777216 + spot_fraction - impact_fraction) * WEFT_FRACTION_UNIT;
}

/* Along a vector of the frame. */
static inline float weft_surface_along(float x, float y, float z, float frame_x, float frame_y, float frame_z)
{
    return (x * frame_x + y * frame_y) + z * frame_z;
}

/* `unit` is 2.0f / (float)thickness; `normal` is weft_surface_along the frame's third vector. */
static inline float weft_surface_fade(float normal, float unit)
{
    return 1.0f - (normal < 0.0f ? -normal : normal) * unit;
}

/* 2^-level. */
static inline float weft_level_unit(weft_u32 level) { return 1.0f / (float)((weft_u32)1 << level); }

/* Where the middle of an axis of `size` texels lies in the texels of a level: exact. */
static inline float weft_surface_middle(weft_u32 size, weft_u32 level)
{
    return 0.5f * (float)size * weft_level_unit(level) - 0.5f;
}

/* First texel of an axis and the place after it; `along` is weft_surface_along the frame's first or second vector,
 * `unit` weft_level_unit. Only where -2^20 < along * unit + middle < 2^20; further out an impact adds nothing. */
static inline float weft_surface_place(float along, float unit, float middle) { return along * unit + middle; }

static inline weft_taps weft_surface_taps(float place, weft_u32 taps)
{
    const weft_i32 whole = weft_floor(taps == 1 ? place + 0.5f : place);
    weft_taps at;
    at.first = (weft_i64)whole - (taps > 2 ? (weft_i64)(taps / 2 - 1) : 0);
    at.t = place - (float)whole;
    return at;
}

#endif
