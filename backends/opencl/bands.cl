/* SPLAT for windows on devices with few wide cores. A band is a few rows of the window; its list has the impacts that reach
 * it, in canonical order. A block is WEFT_BLOCK_COLUMNS columns of a band; the accumulators of all its pixels, one per tap,
 * stay in registers while the block goes through the impacts. That of tap i belongs to the pixel i columns to the left:
 * layer_sum shifts it once, for all impacts. */

#pragma OPENCL FP_CONTRACT OFF

/* The impacts that may reach a block: the list is in the order of columns but for `jitter`, and blocks go to the right. */
typedef struct Range {
    weft_u32 first, last;
} Range;

static Range range_on(Range range, global const ImpactLayout *impacts, weft_u32 end, weft_i32 x, weft_i32 width, weft_i32 jitter)
{
    while (range.first < end && impacts[range.first].column + x >= width) ++range.first;
    range.last = max(range.last, range.first);
    while (range.last < end && impacts[range.last].column + x + jitter > -WEFT_BLOCK_COLUMNS) ++range.last;
    return range;
}

/* One kernel per number of taps. Impacts beyond the block's sides read the zeros between rows. */
#define SPLAT_BANDS(taps, add)                                                                                                  \
    kernel __attribute__((reqd_work_group_size(1, 1, 1)))                                                                       \
    void splat_bands_##taps(global const LevelLayout *levels, global const float *texels, global const ImpactLayout *impacts,   \
                            global const float *weights, global const weft_u32 *bands, global float *sums, SumsLayout blocks)   \
    {                                                                                                                           \
        const weft_u32 segment = get_global_id(0), band = get_global_id(1), plane = get_global_id(2);                           \
        global const LevelLayout *level = levels + blocks.index;                                                                \
        global const float *texton = texels + (size_t)level->offset * 4 + (size_t)plane * level->plane_step;                    \
        const weft_u32 stop = min((segment + 1) * blocks.segment, blocks.blocks), end = bands[band + 1];                        \
        const weft_i32 width = (weft_i32)level->width;                                                                          \
        const size_t stride = level->stride;                                                                                    \
        Range range = {bands[band], bands[band]};                                                                               \
        for (weft_u32 block = segment * blocks.segment; block < stop; ++block) {                                                \
            const weft_i32 x = (weft_i32)(block * WEFT_BLOCK_COLUMNS);                                                          \
            range = range_on(range, impacts, end, x, width, blocks.jitter);                                                     \
            float8 sum[WEFT_BLOCK_ROWS(taps)][taps];                                                                            \
            _Pragma("unroll") for (int r = 0; r < WEFT_BLOCK_ROWS(taps); ++r)                                                   \
                _Pragma("unroll") for (int i = 0; i < taps; ++i) sum[r][i] = 0.0f;                                              \
            for (weft_u32 i = range.first; i < range.last; ++i) {                                                               \
                const weft_i32 k = clamp(impacts[i].column + x, -WEFT_BLOCK_COLUMNS, width);                                    \
                global const float *texel = texton + impacts[i].row + k;                                                        \
                global const float *weight = weights + (size_t)i * WEFT_BLOCK_WEIGHTS(taps);                                    \
                add(taps)                                                                                                       \
            }                                                                                                                   \
            global float *to = sums + (size_t)plane * taps * blocks.step + (size_t)band * WEFT_BLOCK_ROWS(taps) * blocks.stride + x; \
            _Pragma("unroll") for (int r = 0; r < WEFT_BLOCK_ROWS(taps); ++r)                                                   \
                _Pragma("unroll") for (int i = 0; i < taps; ++i)                                                                \
                    vstore8(sum[r][i], 0, to + r * (size_t)blocks.stride + i * (size_t)blocks.step);                            \
        }                                                                                                                       \
    }

/* One product with the sign. */
#define ADD_NEAREST(taps)                                                                                                       \
    const float8 sign = weight[0];                                                                                              \
    _Pragma("unroll") for (int r = 0; r < WEFT_BLOCK_ROWS(1); ++r) sum[r][0] = fma(sign, vload8(0, texel + r * stride), sum[r][0]);

#define ADD_LINEAR(taps)                                                                                                        \
    const float8 w0 = weight[0], w1 = weight[1], rho = weight[2];                                                               \
    float8 above = vload8(0, texel);                                                                                            \
    _Pragma("unroll") for (int r = 0; r < WEFT_BLOCK_ROWS(2); ++r) {                                                            \
        const float8 below = vload8(0, texel + (r + 1) * stride);                                                               \
        const float8 v = fma(rho, below, above);                                                                                \
        sum[r][0] = fma(w0, v, sum[r][0]);                                                                                      \
        sum[r][1] = fma(w1, v, sum[r][1]);                                                                                      \
        above = below;                                                                                                          \
    }

#define ADD_SPLINE(taps)                                                                                                        \
    _Pragma("unroll") for (int r = 0; r < WEFT_BLOCK_ROWS(taps); ++r) {                                                         \
        float8 v = weight[taps] * vload8(0, texel + r * stride);                                                                \
        _Pragma("unroll") for (int j = 1; j < taps; ++j)                                                                        \
            v = fma((float8)weight[taps + j], vload8(0, texel + (r + j) * stride), v);                                          \
        _Pragma("unroll") for (int j = 0; j < taps; ++j) sum[r][j] = fma((float8)weight[j], v, sum[r][j]);                      \
    }

SPLAT_BANDS(1, ADD_NEAREST)
SPLAT_BANDS(2, ADD_LINEAR)
SPLAT_BANDS(4, ADD_SPLINE)
SPLAT_BANDS(6, ADD_SPLINE)
