/* SPLAT for windows on devices with few wide cores. A band is a few rows of the window; its list has the impacts that
 * reach it, in canonical order. A block is WEFT_BLOCK_COLUMNS columns of a band; the accumulators of all its pixels,
 * one per tap, stay in registers while the block goes through the impacts. That of tap i belongs to the pixel i columns
 * to the left: layer_sum shifts it once, for all impacts. */

#pragma OPENCL FP_CONTRACT OFF

/* The impacts that may reach a block: the list is in the order of columns but for `jitter`; blocks go to the right. */
typedef struct Range {
    weft_u32 first, last;
} Range;

static inline Range range_on(Range range, global const weft_i32* impacts, weft_u32 end, weft_i32 x, weft_i32 width,
                             weft_i32 jitter, size_t words)
{
    while (range.first < end && impacts[range.first * words] + x >= width) ++range.first;
    range.last = max(range.last, range.first);
    while (range.last < end && impacts[range.last * words] + x + jitter > -WEFT_BLOCK_COLUMNS) ++range.last;
    return range;
}

/* All functions below are unrolled: `taps` and `rows` are constants in each kernel, and `sum`, rows * taps vectors, is
 * registers. */

static inline void add_linear8(float8* sum, global const float* texel, size_t stride, global const float* weight,
                               int rows)
{
    const float8 rho = weight[2], w0 = weight[0], w1 = weight[1];
    float8 above = vload8(0, texel);
#pragma unroll
    for (int r = 0; r < rows; ++r) {
        const float8 below = vload8(0, texel + (r + 1) * stride);
        const float8 v = fma(rho, below, above);
        sum[r * 2] = fma(w0, v, sum[r * 2]);
        sum[r * 2 + 1] = fma(w1, v, sum[r * 2 + 1]);
        above = below;
    }
}

static inline void add_spline8(float8* sum, global const float* texel, size_t stride, global const float* weight,
                               int rows, int taps)
{
#pragma unroll
    for (int r = 0; r < rows; ++r) {
        float8 v = weight[taps] * vload8(0, texel + r * stride);
#pragma unroll
        for (int j = 1; j < taps; ++j) v = fma((float8)weight[taps + j], vload8(0, texel + (r + j) * stride), v);
#pragma unroll
        for (int i = 0; i < taps; ++i) sum[r * taps + i] = fma((float8)weight[i], v, sum[r * taps + i]);
    }
}

static inline void store_block(global float* to, const float8* sum, SumsLayout blocks, int rows, int taps)
{
#pragma unroll
    for (int r = 0; r < rows; ++r)
#pragma unroll
        for (int i = 0; i < taps; ++i)
            vstore8(sum[r * taps + i], 0, to + r * (size_t)blocks.stride + i * (size_t)blocks.step);
}

static inline void splat_segment(global const LevelLayout* level, global const float* texels,
                                 global const weft_i32* impacts, global const weft_u32* bands, global float* sums, SumsLayout blocks, int rows,
                                 int taps)
{
    const weft_u32 segment = get_global_id(0), band = get_global_id(1), plane = get_global_id(2);
    const weft_u32 stop = min((segment + 1) * blocks.segment, blocks.blocks), end = bands[band + 1];
    const weft_i32 width = (weft_i32)level->width;
    const size_t stride = level->stride, words = WEFT_IMPACT_WORDS(taps);
    global const float* texton = texels + (size_t)level->offset * 4 + (size_t)plane * level->plane_step;
    global float* to = sums + (size_t)plane * taps * blocks.step + (size_t)band * rows * blocks.stride;
    Range range = {bands[band], bands[band]};
    for (weft_u32 block = segment * blocks.segment; block < stop; ++block) {
        const weft_i32 x = (weft_i32)(block * WEFT_BLOCK_COLUMNS);
        range = range_on(range, impacts, end, x, width, blocks.jitter, words);
        float8 sum[12];
#pragma unroll
        for (int i = 0; i < rows * taps; ++i) sum[i] = 0.0f;
        for (weft_u32 i = range.first; i < range.last; ++i) {
            /* Impacts beyond the block's sides read the zeros between rows. */
            global const weft_i32* impact = impacts + i * words;
            const weft_i32 k = clamp(impact[0] + x, -WEFT_BLOCK_COLUMNS, width);
            global const float* texel = texton + impact[1] + k;
            global const float* weight = (global const float*)(impact + 2);
            if (taps == 2)
                add_linear8(sum, texel, stride, weight, rows);
            else
                add_spline8(sum, texel, stride, weight, rows, taps);
        }
        store_block(to + x, sum, blocks, rows, taps);
    }
}

#define SPLAT_BANDS(taps)                                                                                              \
    kernel __attribute__((reqd_work_group_size(1, 1, 1))) void splat_bands_##taps(                                     \
        global const LevelLayout* levels, global const float* texels, global const weft_i32* impacts,                  \
        global const weft_u32* bands, global float* sums, SumsLayout blocks)                                           \
    {                                                                                                                  \
        splat_segment(levels + blocks.index, texels, impacts, bands, sums, blocks, WEFT_BLOCK_ROWS(taps), taps);       \
    }

SPLAT_BANDS(1)
SPLAT_BANDS(2)
SPLAT_BANDS(4)
SPLAT_BANDS(6)
