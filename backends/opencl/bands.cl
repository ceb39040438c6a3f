/* SPLAT with two taps, for windows on devices with few wide cores. A band is WEFT_BLOCK_ROWS rows of the window; its list has
 * the impacts that reach it, in canonical order. A block is WEFT_BLOCK_COLUMNS columns of a band; the two accumulators of
 * all its pixels stay in registers while the block goes through the impacts. The second one belongs to the pixel on the left:
 * layer_sum shifts it once, for all impacts. */

#pragma OPENCL FP_CONTRACT OFF

kernel __attribute__((reqd_work_group_size(1, 1, 1)))
void splat_bands(global const LayerLayout *layers, global const LevelLayout *levels, global const float *texels,
                 global const ImpactLayout *impacts, global const weft_u32 *bands, global float *sums, SumsLayout blocks,
                 weft_u32 index)
{
    const weft_u32 segment = get_global_id(0), band = get_global_id(1), plane = get_global_id(2);
    global const LevelLayout *level = levels + layers[index].first_level + blocks.level;
    global const float *texton = texels + (size_t)level->offset * 4 + (size_t)plane * level->plane_step;
    const weft_u32 stride = level->stride;
    const weft_i32 width = (weft_i32)level->width;
    global const ImpactLayout *first = impacts + bands[band];
    global const ImpactLayout *const end = impacts + bands[band + 1];
    global const ImpactLayout *last = first;
    const weft_u32 stop = min((segment + 1) * blocks.segment, blocks.blocks);
    for (weft_u32 block = segment * blocks.segment; block < stop; ++block) {
        const weft_i32 x = (weft_i32)(block * WEFT_BLOCK_COLUMNS);
        while (first < end && first->column + x >= width) ++first;
        last = last < first ? first : last;
        while (last < end && last->column + x + blocks.jitter > -WEFT_BLOCK_COLUMNS) ++last;
        float8 a[WEFT_BLOCK_ROWS], b[WEFT_BLOCK_ROWS];
#pragma unroll
        for (int r = 0; r < WEFT_BLOCK_ROWS; ++r) a[r] = b[r] = 0.0f;
        for (global const ImpactLayout *impact = first; impact < last; ++impact) {
            /* Impacts beyond the block's sides read zeros of the frame. */
            const weft_i32 k = clamp(impact->column + x, -WEFT_BLOCK_COLUMNS, width);
            global const float *texel = texton + impact->row + k;
            const float8 w0 = impact->w0, w1 = impact->w1, rho = impact->rho;
            float8 above = vload8(0, texel);
#pragma unroll
            for (int r = 0; r < WEFT_BLOCK_ROWS; ++r) {
                const float8 below = vload8(0, texel + (size_t)(r + 1) * stride);
                const float8 v = fma(rho, below, above);
                a[r] = fma(w0, v, a[r]);
                b[r] = fma(w1, v, b[r]);
                above = below;
            }
        }
        global float *to = sums + (size_t)plane * 2 * blocks.step + (size_t)band * WEFT_BLOCK_ROWS * blocks.stride + x;
#pragma unroll
        for (int r = 0; r < WEFT_BLOCK_ROWS; ++r) {
            vstore8(a[r], 0, to + (size_t)r * blocks.stride);
            vstore8(b[r], 0, to + (size_t)r * blocks.stride + blocks.step);
        }
    }
}
