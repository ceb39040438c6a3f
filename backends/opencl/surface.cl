/* SPLAT on surfaces, sample by sample: impacts in space, seen in the sample's frame. */

#pragma OPENCL FP_CONTRACT OFF

/* A sample, and what does not change from impact to impact. */
typedef struct Surface {
    Position at;
    weft_i32 reach;
    weft_u32 whole, taps;
    float frame[9];
    float fade, unit, middle_x, middle_y;
    float half_cell, slack[3]; /* half a cell seen along the frame's vectors, and all rounding */
} Surface;

static Surface surface_at(global const LayerLayout* layer, global const LevelLayout* level, global const float* frame,
                          Position at, weft_u32 whole)
{
    Surface surface;
    surface.at = at;
    surface.reach = (weft_i32)level->reach;
    surface.whole = whole;
    surface.taps = layer->taps;
    for (int i = 0; i < 9; ++i) surface.frame[i] = frame[i];
    surface.fade = 2.0f / (float)max(layer->texton_width, layer->texton_height);
    surface.unit = weft_level_unit(whole);
    surface.middle_x = weft_surface_middle(layer->texton_width, whole);
    surface.middle_y = weft_surface_middle(layer->texton_height, whole);
    surface.half_cell = 0.5f * (float)(1u << layer->cell_log2);
    const float side = surface.half_cell + 1.0f; /* the sample is within its pixel */
    for (int v = 0; v < 9; v += 3) {
        const float size = fabs(frame[v]) + fabs(frame[v + 1]) + fabs(frame[v + 2]);
        surface.slack[v / 3] = size * (side + 0.001f * ((float)surface.reach + 2.0f * side)) + 0.001f;
    }
    return surface;
}

static float along(const float* vector, float3 d)
{
    return weft_surface_along(d.x, d.y, d.z, vector[0], vector[1], vector[2]);
}

/* Whether a cell may have an impact that reaches, by where it begins, seen from the sample. */
static weft_u32 may_reach(const Surface* surface, global const LevelLayout* level, weft_i32 x, weft_i32 y, weft_i32 z)
{
    const float3 d = (float3)(-(float)x, -(float)y, -(float)z) - surface->half_cell;
    const float column = along(surface->frame, d) * surface->unit + surface->middle_x;
    const float row = along(surface->frame + 3, d) * surface->unit + surface->middle_y;
    const float more_x = surface->slack[0] * surface->unit + (float)surface->taps;
    const float more_y = surface->slack[1] * surface->unit + (float)surface->taps;
    const float left = (float)level->x - more_x, right = (float)(level->x + (weft_i32)level->width) + more_x;
    const float top = (float)level->y - more_y, bottom = (float)(level->y + (weft_i32)level->height) + more_y;
    return (fabs(along(surface->frame + 6, d)) - surface->slack[2]) * surface->fade <= 1.0f && column >= left &&
           column <= right && row >= top && row <= bottom;
}

/* Further out an impact adds nothing. */
static weft_u32 is_place(float p) { return p > -1048576.0f && p < 1048576.0f; }

/* One impact over one sample, `d` away; `weight` is above 0 where it has a part. */
static Touch surface_touch(const Surface* surface, global const LevelLayout* level, float3 d, float* weight)
{
    const weft_i32 frame = (weft_i32)surface->taps - 1;
    Touch touch;
    touch.reaches = 0;
    *weight = weft_surface_fade(along(surface->frame + 6, d), surface->fade);
    const float x = weft_surface_place(along(surface->frame, d), surface->unit, surface->middle_x);
    const float y = weft_surface_place(along(surface->frame + 3, d), surface->unit, surface->middle_y);
    if (!(*weight > 0.0f) || !is_place(x) || !is_place(y)) return touch;
    const weft_taps tx = weft_surface_taps(x, surface->taps), ty = weft_surface_taps(y, surface->taps);
    touch.x = (weft_i32)tx.first - level->x + frame;
    touch.y = (weft_i32)ty.first - level->y + frame;
    touch.tx = tx.t;
    touch.ty = ty.t;
    touch.reaches = touch.x >= 0 && touch.x < (weft_i32)level->width + frame && touch.y >= 0 &&
                    touch.y < (weft_i32)level->height + frame;
    return touch;
}

static float4 texels_under(global const float4* texel, weft_u32 stride, Touch touch, weft_u32 taps)
{
    if (taps == 2)
        return lerp4(lerp4(texel[0], texel[1], touch.tx), lerp4(texel[stride], texel[stride + 1], touch.tx), touch.ty);
    const weft_weights wx = weft_spline(touch.tx, taps), wy = weft_spline(touch.ty, taps);
    float4 sum = 0.0f;
    for (weft_u32 i = 0; i < taps; ++i) {
        float4 v = wy.w[0] * texel[i];
        for (weft_u32 j = 1; j < taps; ++j) v = fma((float4)wy.w[j], texel[j * stride + i], v);
        sum = i == 0 ? wx.w[0] * v : fma((float4)wx.w[i], v, sum);
    }
    return sum;
}

/* Pixel and fraction of a half of an impact's number, seen from the sample; false: there is none. */
static weft_u32 surface_axis(weft_u32 half_number, Walk walk, weft_u32 cell_log2, weft_i32 reach, weft_i32 fraction,
                             float* d)
{
    const weft_impact_axis axis = weft_impact_at(half_number, cell_log2);
    const weft_i32 pixels = walk.start + axis.pixel;
    if (axis.pixel >= walk.size || pixels < -reach || pixels > reach) return 0;
    *d = weft_surface_difference(-(weft_i64)pixels, fraction, axis.fraction);
    return 1;
}

static float4 add_cell(global const LayerLayout* layer, global const LevelLayout* level, global const float4* texton,
                       global const weft_u32* counts, const Surface* surface, Walk x, Walk y, Walk z, weft_u64 key,
                       float4 sum)
{
    const weft_u32 probability = weft_high(weft_draw(key, 0)), log2 = layer->cell_log2;
    for (weft_u32 i = 0; i < layer->count_limit && counts[i] <= probability; ++i) {
        const weft_u64 n = weft_draw(key, i + 1);
        float dx, dy, dz, weight;
        if (!surface_axis(weft_low(n), x, log2, surface->reach, surface->at.fraction_x, &dx) ||
            !surface_axis(weft_high(n), y, log2, surface->reach, surface->at.fraction_y, &dy) ||
            !surface_axis(weft_low(weft_third(n)), z, log2, surface->reach, surface->at.fraction_z, &dz))
            continue;
        const Touch touch = surface_touch(surface, level, (float3)(dx, dy, dz), &weight);
        if (!touch.reaches) continue;
        global const float4* texel = texton + (size_t)touch.y * level->stride + touch.x;
        sum = (weight * weft_impact_sign(n, layer->signs)) * texels_under(texel, level->stride, touch, layer->taps) +
              sum;
    }
    return sum;
}

static inline float4 surface_level(global const LayerLayout* layer, global const LevelLayout* levels,
                            global const float4* texels, global const weft_u32* words, global const float* numbers,
                            global const float* frame, Position at, weft_u32 whole, weft_u32 group)
{
    if (whole >= layer->levels) return (float4)0.0f;
    global const LevelLayout* level = levels + layer->first_level + whole;
    global const float4* texton = texels + level->offset + (size_t)group * level->plane_step;
    global const weft_u32* counts = words + layer->counts;
    const Surface surface = surface_at(layer, level, frame, at, whole);
    const weft_i32 reach = surface.reach;
    const weft_u32 log2 = layer->cell_log2;
    float4 sum = 0.0f;
    for (Walk x = walk_from(at.x, reach, layer->period_x, log2); x.start <= reach;
         x = walk_on(x, layer->period_x, log2)) {
        const weft_u64 key_x = weft_absorb(layer->key, (weft_u64)x.cell);
        for (Walk y = walk_from(at.y, reach, layer->period_y, log2); y.start <= reach;
             y = walk_on(y, layer->period_y, log2)) {
            const weft_u64 key_y = weft_absorb(key_x, (weft_u64)y.cell);
            for (Walk z = walk_from(at.z, reach, layer->period_z, log2); z.start <= reach;
                 z = walk_on(z, layer->period_z, log2))
                if (may_reach(&surface, level, x.start, y.start, z.start))
                    sum = add_cell(layer, level, texton, counts, &surface, x, y, z,
                                   weft_absorb(key_y, (weft_u64)z.cell), sum);
        }
    }
    return sum + vload4(group, numbers + layer->offset);
}

kernel __attribute__((reqd_work_group_size(64, 1, 1))) void
surface_gather(global const LayerLayout* layers, global const LevelLayout* levels, global const float4* texels,
               global const SpotLayout* spots, global const float* frames, global float* field, SamplesLayout samples,
               weft_u32 index, global const weft_u32* words, global const float* numbers)
{
    const weft_u32 column = get_global_id(0), row = get_global_id(1), group = get_global_id(2);
    if (column >= samples.width) return;
    global const LayerLayout* layer = layers + index;
    global const float* frame = frames + (size_t)column * 9;
    const Position at = position_of(samples, spots, column, row);
    const weft_between between = weft_level(at.level);
    const weft_u32 whole = (weft_u32)between.whole;
    float4 f = surface_level(layer, levels, texels, words, numbers, frame, at, whole, group);
    if (between.t > 0.0f)
        f = lerp4(f, surface_level(layer, levels, texels, words, numbers, frame, at, whole + 1, group), between.t);
    store_group(field, layer, samples, column, row, group, f);
}
