/* Poisson cells in canonical order, for kernels and host: the common subset of C++17 and OpenCL C 1.2. */
#ifndef WEFT_OPENCL_WALK_H
#define WEFT_OPENCL_WALK_H

#include "common/field.h"

/* A walk along the cells of one axis, in the unwrapped plane. */
typedef struct Walk {
    weft_i64 cell;  /* number that is hashed */
    weft_i32 start; /* first pixel of the cell, minus the sample's */
    weft_i32 size;  /* pixels of the cell: the last one of a period is cut */
} Walk;

static inline weft_i32 cell_size(weft_i64 cell, weft_u32 period, weft_u32 cell_log2)
{
    const weft_i64 whole = (weft_i64)1 << cell_log2;
    const weft_i64 left = (weft_i64)period - cell * whole;
    return (weft_i32)(period == 0 || whole < left ? whole : left);
}

/* From the cell of the pixel `before` pixels before x. */
static inline Walk walk_from(weft_i64 x, weft_i32 before, weft_u32 period, weft_u32 cell_log2)
{
    const weft_i64 begin = x - before;
    const weft_i64 origin = period == 0 ? 0 : weft_divide_down(begin, period) * (weft_i64)period;
    Walk walk;
    walk.cell = (begin - origin) >> cell_log2;
    walk.start = (weft_i32)(origin + walk.cell * ((weft_i64)1 << cell_log2) - x);
    walk.size = cell_size(walk.cell, period, cell_log2);
    return walk;
}

static inline Walk walk_on(Walk walk, weft_u32 period, weft_u32 cell_log2)
{
    walk.start += walk.size;
    walk.cell += 1;
    if (period != 0 && walk.cell * ((weft_i64)1 << cell_log2) >= (weft_i64)period) walk.cell = 0;
    walk.size = cell_size(walk.cell, period, cell_log2);
    return walk;
}

#endif
