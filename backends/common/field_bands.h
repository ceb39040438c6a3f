/* BANDS, for field.h. */
#ifndef WEFT_FIELD_BANDS_H
#define WEFT_FIELD_BANDS_H

#include "field_numbers.h"

/* BANDS ------------------------------------------------------------------------------------------------------------
 *
 * In the plane: c_b = weft_band_add(weight_b, lattice_b, refine(c_b+1)), from the coarsest band, where refine is +0, to
 * band l of level l + t. A band without lattice is c_b = refine(c_b+1). f is the quadratic B-spline of c_l at
 * weft_band_place; +0 from level `count` on.
 *
 * In space: A_i = weft_band_add(w_i * weight_b, v_i, A_i) for the columns i = 0, 1, 2 of the 27 coefficients, from the
 * coarsest band that has a lattice to band l, each A from +0: v_i are three sums along z, then one along y, by
 * weft_quadratic_sum with weights at weft_band_place of band b, and w_i are those of x. f = A_0 + (A_1 + A_2).
 *
 * The weight of band l is weft_band_weight, and t is for no other.
 *
 * Band b has cells of 2^b pixels: pixel x is in cell j = x >> b, whose coefficients are j, j + 1, j + 2 of the plane.
 * Coefficient j is at weft_band_index in the lattice. refine goes axis by axis, y, x. No c and no A is ever -0. */

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

/* Place in its cell of a band, 0..1: exactly 1/2 in band l at the centres of a window's pixels. */
static inline float weft_band_place(weft_i64 pixel, weft_u32 fraction, weft_u32 band)
{
    const weft_i64 rest = pixel & (((weft_i64)1 << band) - 1);
    return (float)(weft_i32)((rest * 16777216 + (weft_i64)fraction) >> band) * WEFT_FRACTION_UNIT;
}

/* Quadratic B-spline: 1/8, 3/4, 1/8 at t = 1/2. In the plane first the three of each row are summed, then rows. */
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

#endif
