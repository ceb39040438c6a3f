/* SPLAT, sample by sample: every sample draws the impacts that reach it. */

#pragma OPENCL FP_CONTRACT OFF

/* One impact over one sample: its first tap in the framed level, and the places after it. */
typedef struct Touch {
    weft_i32 x, y;
    float tx, ty;
    weft_u32 reaches;
} Touch;

static Touch touch_at(global const LevelLayout* level, Position at, weft_i32 dx, weft_i32 dy, weft_i32 fraction_x,
                      weft_i32 fraction_y, weft_u32 whole, weft_u32 taps)
{
    const weft_taps x = weft_taps_at(weft_distance(-(weft_i64)dx, at.fraction_x, fraction_x, whole), taps);
    const weft_taps y = weft_taps_at(weft_distance(-(weft_i64)dy, at.fraction_y, fraction_y, whole), taps);
    const weft_i32 frame = (weft_i32)taps - 1;
    Touch touch;
    touch.x = (weft_i32)x.first - level->x + frame;
    touch.y = (weft_i32)y.first - level->y + frame;
    touch.tx = x.t;
    touch.ty = y.t;
    touch.reaches = touch.x >= 0 && touch.x < (weft_i32)level->width + frame && touch.y >= 0 &&
                    touch.y < (weft_i32)level->height + frame;
    return touch;
}

static void add_linear(float4* sum, global const float4* texel, weft_u32 stride, Touch touch, float sign)
{
    const weft_weights2 w = weft_linear(touch.tx, touch.ty, sign);
    const float4 rho = w.rho;
    sum[0] = fma((float4)w.w0, fma(rho, texel[stride], texel[0]), sum[0]);
    sum[1] = fma((float4)w.w1, fma(rho, texel[stride + 1], texel[1]), sum[1]);
}

static void add_spline(float4* sum, global const float4* texel, weft_u32 stride, Touch touch, float sign, weft_u32 taps)
{
    const weft_weights wx = weft_spline(touch.tx, taps), wy = weft_spline(touch.ty, taps);
    for (weft_u32 i = 0; i < taps; ++i) {
        float4 v = wy.w[0] * texel[i];
        for (weft_u32 j = 1; j < taps; ++j) v = fma((float4)wy.w[j], texel[j * stride + i], v);
        sum[i] = fma((float4)(wx.w[i] * sign), v, sum[i]);
    }
}

/* Four planes of a TILE without displacement. */
static float4 chosen_at(global const LayerLayout* tile, global const LevelLayout* levels, global const float4* texels,
                        global const weft_u32* words, global const float* numbers, Position at, weft_u32 group)
{
    if (tile->form == WEFT_TILE_GATHER) return tile_at(tile, levels, texels, at, group);
    const weft_place x = locate(at.x, at.fraction_x, tile->period_x, tile->grid_x);
    const weft_place y = locate(at.y, at.fraction_y, tile->period_y, tile->grid_y);
    return composed_at(compose(composer_of(tile, levels, words, numbers, at.level), x, y), levels + tile->first_level,
                       texels, group);
}

/* Which image an impact shows: a plane of an earlier TILE, at the middle of its texton. */
static weft_u32 chosen_image(global const LayerLayout* layers, global const LayerLayout* layer,
                             global const LevelLayout* levels, global const float4* texels,
                             global const weft_u32* words, global const float* numbers, weft_i64 x, weft_i64 y)
{
    global const LayerLayout* tile = layers + layer->choice_layer;
    const weft_u32 plane = layer->choice_plane;
    Position at;
    at.x = weft_choice_pixel(x, layer->texton_width);
    at.y = weft_choice_pixel(y, layer->texton_height);
    at.fraction_x = at.fraction_y = WEFT_FRACTION_HALF;
    at.level = 0.0f;
    const float4 f = chosen_at(tile, levels, texels, words, numbers, at, plane / 4);
    const float values[4] = {f.x, f.y, f.z, f.w};
    float v = values[plane % 4];
    if (tile->tones != WEFT_NONE && plane < tile->channels) v = tone(v, words, numbers, tile->tones, plane);
    return weft_choose(v, layer->images);
}

static float4 splat_level(global const LayerLayout* layers, global const LayerLayout* layer,
                          global const LevelLayout* levels, global const float4* texels, global const weft_u32* words,
                          global const float* numbers, Position at, weft_u32 whole, weft_u32 group)
{
    if (whole >= layer->levels) return (float4)0.0f;
    global const LevelLayout* level = levels + layer->first_level + whole;
    global const float4* texton = texels + level->offset + (size_t)group * level->plane_step;
    global const weft_u32* counts = words + layer->counts;
    const weft_u32 log2 = layer->cell_log2;
    float4 sum[6];
    for (weft_u32 i = 0; i < 6; ++i) sum[i] = 0.0f;
    for (Walk x = walk_from(at.x, level->before_x, layer->period_x, log2); x.start <= level->after_x;
         x = walk_on(x, layer->period_x, log2)) {
        const weft_u64 column_key = weft_absorb(layer->key, (weft_u64)x.cell);
        for (Walk y = walk_from(at.y, level->before_y, layer->period_y, log2); y.start <= level->after_y;
             y = walk_on(y, layer->period_y, log2)) {
            const weft_u64 key = weft_absorb(column_key, (weft_u64)y.cell);
            const weft_u32 probability = weft_high(weft_draw(key, 0));
            for (weft_u32 i = 0; i < layer->count_limit && counts[i] <= probability; ++i) {
                const weft_u64 z = weft_draw(key, i + 1);
                const weft_impact_axis ix = weft_impact_at(weft_low(z), log2), iy = weft_impact_at(weft_high(z), log2);
                if (ix.pixel >= x.size || iy.pixel >= y.size) continue;
                const weft_i32 dx = x.start + ix.pixel, dy = y.start + iy.pixel;
                const Touch touch = touch_at(level, at, dx, dy, ix.fraction, iy.fraction, whole, layer->taps);
                if (!touch.reaches) continue;
                const float sign = weft_impact_sign(z, layer->signs);
                global const float4* texel = texton + (size_t)touch.y * level->stride + touch.x;
                if (layer->choice_layer != WEFT_NONE)
                    texel += (size_t)level->image_step *
                             chosen_image(layers, layer, levels, texels, words, numbers, at.x + dx, at.y + dy);
                if (layer->taps == 2)
                    add_linear(sum, texel, level->stride, touch, sign);
                else
                    add_spline(sum, texel, level->stride, touch, sign, layer->taps);
            }
        }
    }
    float4 f = sum[0];
    for (weft_u32 i = 1; i < layer->taps; ++i) f = f + sum[i];
    return f + vload4(group, numbers + layer->offset);
}

kernel __attribute__((reqd_work_group_size(64, 1, 1))) void
splat_gather(global const LayerLayout* layers, global const LevelLayout* levels, global const float4* texels,
             global const SpotLayout* spots, global float* field, SamplesLayout samples, weft_u32 index,
             global const weft_u32* words, global const float* numbers)
{
    const weft_u32 column = get_global_id(0), row = get_global_id(1), group = get_global_id(2);
    if (column >= samples.width) return;
    global const LayerLayout* layer = layers + index;
    const Position at = position_of(samples, spots, column, row);
    const weft_between between = weft_level(at.level);
    float4 f = splat_level(layers, layer, levels, texels, words, numbers, at, (weft_u32)between.whole, group);
    if (between.t > 0.0f)
        f = lerp4(f, splat_level(layers, layer, levels, texels, words, numbers, at, (weft_u32)between.whole + 1, group),
                  between.t);
    store_group(field, layer, samples, column, row, group, f);
}
