/* Every formula of PROGRAMS.md that decides a bit, in the common subset of C99, C++17 and OpenCL C 1.2.
 *
 * No pointers, so that no address space is named: a caller loads, these functions compute. Compile with contraction off
 * (-ffp-contract=off; the pragma below for OpenCL C) and without any fast-math option: nothing here may be fused,
 * reordered or flushed to zero. Where a multiply-add is fused, it is written weft_fma. Right shifts of negative
 * integers round down, as those of GCC, clang and OpenCL C do. */
#ifndef WEFT_FIELD_H
#define WEFT_FIELD_H

#if defined(__OPENCL_C_VERSION__) || defined(__OPENCL_VERSION__)
#pragma OPENCL FP_CONTRACT OFF
typedef int weft_i32;
typedef uint weft_u32;
typedef long weft_i64;
typedef ulong weft_u64;
#else
#include <stdint.h>
typedef int32_t weft_i32;
typedef uint32_t weft_u32;
typedef int64_t weft_i64;
typedef uint64_t weft_u64;
#endif

#define WEFT_FRACTION_BITS 24       /* of a position within its pixel */
#define WEFT_FRACTION_HALF 0x800000 /* the centre of a pixel */
#define WEFT_FRACTION_MASK 0xffffff
#define WEFT_FRACTION_UNIT (1.0f / 16777216.0f)

/* Multiply-add with one rounding -------------------------------------------------------------------------------- */

#if defined(__OPENCL_C_VERSION__) || defined(__OPENCL_VERSION__)
#define weft_fma(a, b, c) fma((a), (b), (c))
#elif defined(__FMA__) || defined(__aarch64__)
static inline float weft_fma(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
#else
/* The product is exact in binary64. The sum is rounded to odd: its last bit is set if anything was lost, and then the
 * second rounding, to binary32, is that of the exact value (Boldo and Melquiond 2008). */
static inline float weft_fma(float a, float b, float c)
{
    const double product = (double)a * (double)b;
    const double addend = (double)c;
    double sum = product + addend;
    const double part = sum - product;
    const double lost = (product - (sum - part)) + (addend - part);
    weft_u64 bits;
    __builtin_memcpy(&bits, &sum, sizeof bits);
    if ((lost < 0 || lost > 0) && (bits & 1) == 0) bits += (lost > 0) == (sum > 0) ? (weft_u64)1 : ~(weft_u64)0;
    __builtin_memcpy(&sum, &bits, sizeof sum);
    return (float)sum;
}
#endif

/* b from a by t. Where a rule says "if t > 0", it is weft_lerp_if: that decides the sign of zero. */
static inline float weft_lerp(float a, float b, float t) { return t * (b - a) + a; }
static inline float weft_lerp_if(float a, float b, float t) { return t > 0.0f ? t * (b - a) + a : a; }

static inline float weft_clamp(float v, float low, float high)
{
    v = v < low ? low : v;
    return v > high ? high : v;
}

/* Largest integer not above s, for |s| < 2^31. */
static inline weft_i32 weft_floor(float s)
{
    const weft_i32 k = (weft_i32)s;
    return k - (s < (float)k ? 1 : 0);
}

/* Largest integer not above n / d; n below 2^63 in size. */
static inline weft_i64 weft_divide_down(weft_i64 n, weft_u32 d)
{
    const weft_i64 q = n / (weft_i64)d;
    return q - (n - q * (weft_i64)d < 0 ? 1 : 0);
}

/* Random numbers: counter-based, 64 bits (the finaliser of splitmix64) ----------------------------------------------
 */

#define WEFT_GOLDEN ((weft_u64)0x9e3779b97f4a7c15)

/* Tags of keys: what a hash is for. */
#define WEFT_TAG_IMPACTS 3

static inline weft_u64 weft_mix(weft_u64 z)
{
    z = (z ^ (z >> 30)) * (weft_u64)0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * (weft_u64)0x94d049bb133111eb;
    return z ^ (z >> 31);
}

static inline weft_u64 weft_absorb(weft_u64 h, weft_u64 v) { return weft_mix((h ^ v) + WEFT_GOLDEN); }

/* The i-th number of a key's sequence. */
static inline weft_u64 weft_draw(weft_u64 key, weft_u32 i) { return weft_mix(key + ((weft_u64)i + 1) * WEFT_GOLDEN); }

/* key(tag, v...) = absorb(... absorb(weft_key(seed, stream, tag), v) ...). */
static inline weft_u64 weft_key(weft_u64 seed, weft_u32 stream, weft_u32 tag)
{
    return weft_absorb(weft_absorb(seed, stream), tag);
}

static inline weft_u32 weft_low(weft_u64 z) { return (weft_u32)(z & (weft_u64)0xffffffff); }
static inline weft_u32 weft_high(weft_u64 z) { return (weft_u32)(z >> 32); }

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

/* Levels ----------------------------------------------------------------------------------------------------------- */

/* A level between two of a mip chain: the chain's level `whole`, and if t > 0 the next one by lerp. */
typedef struct weft_between {
    weft_i32 whole;
    float t;
} weft_between;

/* SPLAT, where f is 0 from level `levels` on. */
static inline weft_between weft_level(float level)
{
    weft_between at;
    at.whole = (weft_i32)level;
    at.t = level - (float)at.whole;
    return at;
}

/* TILE: `added` is tile.level; the last level lasts for ever. */
static inline weft_between weft_tile_level(float level, float added, weft_u32 levels)
{
    return weft_level(weft_clamp(level + added, 0.0f, (float)(levels - 1)));
}

/* BANDS ------------------------------------------------------------------------------------------------------------
 *
 * c_b = weft_band_add(weight_b, lattice_b, refine(c_b+1)), from the coarsest band, where refine is +0, to band l of
 * level l + t; the weight of band l is weft_band_weight, and t is for no other. A band without lattice is c_b =
 * refine(c_b+1). f is the quadratic B-spline of c_l at weft_band_place; +0 from level `count` on.
 *
 * Band b has cells of 2^b pixels: pixel x is in cell j = x >> b, whose coefficients are j, j + 1, j + 2 of the plane.
 * Coefficient j is at weft_band_index in the lattice. refine goes axis by axis, (z,) y, x. No sum is ever -0. */

static inline weft_i64 weft_band_cell(weft_i64 pixel, weft_u32 band) { return pixel >> band; }

/* Of a lattice of `size` on this axis, for a cell below 2^62 in size. */
static inline weft_u32 weft_band_index(weft_i64 cell, weft_u32 shift, weft_u32 size)
{
    const weft_i64 shifted = cell + (weft_i64)shift;
    return (weft_u32)(shifted - weft_divide_down(shifted, size) * (weft_i64)size);
}

/* Coefficients 2m and 2m + 1 of the finer band, from m and m + 1 of the coarser. */
static inline float weft_refine_even(float a, float b) { return 0.75f * a + 0.25f * b; }
static inline float weft_refine_odd(float a, float b) { return 0.25f * a + 0.75f * b; }

static inline float weft_band_add(float weight, float lattice, float refined) { return weight * lattice + refined; }

static inline float weft_band_weight(float weight, float t) { return weight * (1.0f - t); }

/* Place in its cell of band l, 0..1: exactly 1/2 at the centres of a window's pixels. */
static inline float weft_band_place(weft_i64 pixel, weft_u32 fraction, weft_u32 band)
{
    const weft_i64 rest = pixel & (((weft_i64)1 << band) - 1);
    return (float)(weft_i32)((rest * 16777216 + (weft_i64)fraction) >> band) * WEFT_FRACTION_UNIT;
}

/* Quadratic B-spline: 1/8, 3/4, 1/8 at t = 1/2. Axes in the order x, y, z: the three of a row, then rows, then planes.
 */
typedef struct weft_quadratic {
    float w0, w1, w2;
} weft_quadratic;

static inline weft_quadratic weft_quadratic_weights(float t)
{
    const float s = 1.0f - t;
    weft_quadratic w;
    w.w0 = 0.5f * (s * s);
    w.w2 = 0.5f * (t * t);
    w.w1 = 1.0f - (w.w0 + w.w2);
    return w;
}

static inline float weft_quadratic_sum(float w0, float w1, float w2, float a, float b, float c)
{
    return w0 * a + (w1 * b + w2 * c);
}

/* TILE ------------------------------------------------------------------------------------------------------------- */

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

/* Tone curve and sum of layers --------------------------------------------------------------------------------------
 *
 * v clamped to [low, high]; the piece is the last one with x not above v; then this with d = v - x. */
static inline float weft_piece_at(float d, float c0, float c1, float c2, float c3)
{
    return ((c3 * d + c2) * d + c1) * d + c0;
}

/* s = mean; s = weft_madd(colour, f, s) channel by channel; out = weft_madd(mask, s, out), and out begins as +0. */
static inline float weft_madd(float a, float b, float c) { return a * b + c; }

#endif
