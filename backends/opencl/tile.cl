/* TILE, sample by sample: a periodic picture. */

#pragma OPENCL FP_CONTRACT OFF

static weft_place locate(weft_i64 x, weft_i32 fraction, weft_u32 period, GridLayout grid)
{
    return weft_locate(x, (weft_u32)fraction, period, grid.span, grid.cells, grid.inverse, grid.step, grid.size);
}

static float4 tile_level(global const LevelLayout* level, global const float4* texels, weft_place x, weft_place y,
                         weft_i32 whole, weft_u32 group)
{
    const weft_pair px = weft_pair_at(x, whole, level->scale_x, level->width);
    const weft_pair py = weft_pair_at(y, whole, level->scale_y, level->height);
    global const float4* plane = texels + level->offset + (size_t)group * level->plane_step;
    global const float4* first = plane + (size_t)py.first * level->stride;
    global const float4* second = plane + (size_t)py.second * level->stride;
    return lerp4(lerp4(first[px.first], first[px.second], px.t), lerp4(second[px.first], second[px.second], px.t),
                 py.t);
}

static float4 tile_at(global const LayerLayout* layer, global const LevelLayout* levels, global const float4* texels,
                      Position at, weft_u32 group)
{
    const weft_between between = weft_tile_level(at.level, layer->level, layer->levels);
    const weft_place x = locate(at.x, at.fraction_x, layer->period_x, layer->grid_x);
    const weft_place y = locate(at.y, at.fraction_y, layer->period_y, layer->grid_y);
    global const LevelLayout* level = levels + layer->first_level + between.whole;
    const float4 f = tile_level(level, texels, x, y, between.whole, group);
    return between.t > 0.0f ? lerp4(f, tile_level(level + 1, texels, x, y, between.whole + 1, group), between.t) : f;
}

kernel __attribute__((reqd_work_group_size(64, 1, 1))) void
tile_gather(global const LayerLayout* layers, global const LevelLayout* levels, global const float4* texels,
            global const SpotLayout* spots, global float* field, SamplesLayout samples, weft_u32 index)
{
    const weft_u32 column = get_global_id(0), row = get_global_id(1), group = get_global_id(2);
    if (column >= samples.width) return;
    global const LayerLayout* layer = layers + index;
    const Position at = position_of(samples, spots, column, row);
    const float4 f = tile_at(layer, levels, texels, at, group);
    store_group(field, layer, samples, column, row, group, f);
}
