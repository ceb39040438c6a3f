/* Every formula of PROGRAMS.md that decides a bit, in the common subset of C99, C++17 and OpenCL C 1.2.
 *
 * No pointers, so that no address space is named: a caller loads, these functions compute. Compile with contraction off
 * (-ffp-contract=off; a pragma for OpenCL C) and without any fast-math option: nothing here may be fused, reordered or
 * flushed to zero. Where a multiply-add is fused, it is written weft_fma. Right shifts of negative integers round down,
 * as those of GCC, clang and OpenCL C do. */
#ifndef WEFT_FIELD_H
#define WEFT_FIELD_H

#include "field_bands.h"
#include "field_exchange.h"
#include "field_numbers.h"
#include "field_splat.h"
#include "field_surface.h"
#include "field_tile.h"
#include "field_wang.h"

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
