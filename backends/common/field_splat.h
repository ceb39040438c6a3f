/* SPLAT in the plane, for field.h: impacts and their taps. */
#ifndef WEFT_FIELD_SPLAT_H
#define WEFT_FIELD_SPLAT_H

#include "field_numbers.h"

/* SPLAT: impacts ---------------------------------------------------------------------------------------------------
 *
 * K = absorb(absorb(weft_key(seed, stream, WEFT_TAG_IMPACTS), cell x), cell y). A cell has as many impacts as there are
 * thresholds not above weft_high(weft_draw(K, 0)); impact i is made of z = weft_draw(K, i + 1). */

/* One axis of an impact: its pixel in the cell, and its fraction of 2^24 (an odd multiple of 2^7). */
typedef struct weft_impact_axis {
    weft_i32 pixel;
    weft_i32 fraction;
} weft_impact_axis;

/* `z` is the low half of the impact's number for x, the high half for y. */
static inline weft_impact_axis weft_impact_at(weft_u32 z, weft_u32 cell_log2)
{
    const weft_u32 a = z >> (16 - cell_log2);
    weft_impact_axis axis;
    axis.pixel = (weft_i32)(a >> 16);
    axis.fraction = (weft_i32)(((a & 0xffff) * 2 + 1) << 7);
    return axis;
}

static inline float weft_impact_sign(weft_u64 z, weft_u32 signs) { return (weft_u32)(z & signs) != 0 ? -1.0f : 1.0f; }

/* Where an impact at `pixel` asks which of its layer's textons it shows, of `size` at level 0: at their middle, as its
 * own pixel is their corner, and what a map says of a place is to be seen around it. */
static inline weft_i64 weft_choice_pixel(weft_i64 pixel, weft_u32 size) { return pixel + (weft_i64)(size >> 1); }

/* Which of `images` textons a value of the choice's plane means. */
static inline weft_u32 weft_choose(float value, weft_u32 images)
{
    const weft_u32 image = (weft_u32)(weft_clamp(value, 0.0f, 1.0f) * (float)images);
    return image < images ? image : images - 1;
}

/* SPLAT: taps ------------------------------------------------------------------------------------------------------ */

/* Distance of a sample from an impact along an axis, in 2^-24 of the texels of level l: `pixels` is the sample's pixel
 * minus the impact's, the fractions are of 2^24. */
static inline weft_i64 weft_distance(weft_i64 pixels, weft_i32 sample_fraction, weft_i32 impact_fraction,
                                     weft_u32 level)
{
    return ((pixels * 16777216 + sample_fraction - impact_fraction) >> level) - WEFT_FRACTION_HALF;
}

/* First texel and the place after it: texels first .. first + taps - 1 of an axis are read. */
typedef struct weft_taps {
    weft_i64 first;
    float t;
} weft_taps;

static inline weft_taps weft_taps_at(weft_i64 distance, weft_u32 taps)
{
    weft_taps at;
    if (taps == 1) distance += WEFT_FRACTION_HALF;
    at.first = (distance >> WEFT_FRACTION_BITS) - (taps > 2 ? (weft_i64)(taps / 2 - 1) : 0);
    at.t = (float)(weft_i32)(distance & WEFT_FRACTION_MASK) * WEFT_FRACTION_UNIT;
    return at;
}

/* Two taps: A0 = fma(w0, fma(rho, T[y+1][x], T[y][x]), A0), A1 = fma(w1, fma(rho, T[y+1][x+1], T[y][x+1]), A1),
 * f = (A0 + A1) + offset. The division is the only one in SPLAT and is correctly rounded; tx and ty are below 1. */
typedef struct weft_weights2 {
    float w0, w1, rho;
} weft_weights2;

static inline weft_weights2 weft_linear(float tx, float ty, float sign)
{
    const float sy = 1.0f - ty;
    weft_weights2 w;
    w.rho = ty / sy;
    w.w0 = (1.0f - tx) * sy * sign;
    w.w1 = tx * sy * sign;
    return w;
}

/* Other numbers of taps: v_i = wy_0 * T[y][x+i], then v_i = fma(wy_j, T[y+j][x+i], v_i); A_i = fma(wx_i * sign, v_i,
 * A_i); f = (((A_0 + A_1) + A_2) ...) + offset. One tap: weight 1. */
typedef struct weft_weights {
    float w[6];
} weft_weights;

/* Cubic B-spline, 4 taps. */
static inline weft_weights weft_cubic(float t)
{
    const float s = 1.0f - t, sixth = 1.0f / 6.0f;
    weft_weights b;
    b.w[0] = ((s * s) * s) * sixth;
    b.w[3] = ((t * t) * t) * sixth;
    b.w[1] = (2.0f / 3.0f - t * t) + 0.5f * ((t * t) * t);
    b.w[2] = 1.0f - ((b.w[0] + b.w[1]) + b.w[3]);
    b.w[4] = b.w[5] = 0.0f;
    return b;
}

/* 120 times the quintic B-spline at 1 + t. */
static inline float weft_quintic_far(float t)
{
    return ((((5.0f * t - 20.0f) * t + 20.0f) * t + 20.0f) * t - 50.0f) * t + 26.0f;
}

/* Quintic B-spline, 6 taps. */
static inline weft_weights weft_quintic(float t)
{
    const float s = 1.0f - t, unit = 1.0f / 120.0f;
    const float ss = s * s, tt = t * t;
    weft_weights b;
    b.w[0] = ((ss * ss) * s) * unit;
    b.w[1] = weft_quintic_far(t) * unit;
    b.w[2] = (((30.0f - 10.0f * t) * tt - 60.0f) * tt + 66.0f) * unit;
    b.w[4] = weft_quintic_far(s) * unit;
    b.w[5] = ((tt * tt) * t) * unit;
    b.w[3] = 1.0f - (((b.w[0] + b.w[1]) + b.w[2]) + (b.w[4] + b.w[5]));
    return b;
}

static inline weft_weights weft_spline(float t, weft_u32 taps)
{
    weft_weights one;
    if (taps == 4) return weft_cubic(t);
    if (taps == 6) return weft_quintic(t);
    one.w[0] = 1.0f;
    one.w[1] = one.w[2] = one.w[3] = one.w[4] = one.w[5] = 0.0f;
    return one;
}

#endif
