/* The kernels that evaluate a layer sample by sample, and the one that adds layers. field.h and layout.h come before. */

#pragma OPENCL FP_CONTRACT OFF

typedef struct Position {
    weft_i64 x, y;
    weft_i32 fraction_x, fraction_y;
    float level;
} Position;

/* Pixel i of a window of level L is at (i + 1/2) * 2^L. */
static Position window_position(SamplesLayout samples, weft_u32 column, weft_u32 row)
{
    const weft_i64 unit = (weft_i64)1 << samples.level;
    const weft_i64 half_unit = unit >> 1;
    Position at;
    at.x = (samples.x + column) * unit + half_unit;
    at.y = (samples.y + row) * unit + half_unit;
    at.fraction_x = at.fraction_y = samples.level == 0 ? WEFT_FRACTION_HALF : 0;
    at.level = (float)samples.level;
    return at;
}

static Position position_of(SamplesLayout samples, global const SpotLayout *spots, weft_u32 column, weft_u32 row)
{
    if (samples.spots) {
        Position at;
        at.x = spots[column].cell[0];
        at.y = spots[column].cell[1];
        at.fraction_x = (weft_i32)spots[column].fraction[0];
        at.fraction_y = (weft_i32)spots[column].fraction[1];
        at.level = spots[column].level;
        return at;
    }
    return window_position(samples, column, row);
}

static float4 lerp4(float4 a, float4 b, float t) { return t * (b - a) + a; }

/* TILE ------------------------------------------------------------------------------------------------------------- */

static weft_place locate(weft_i64 x, weft_i32 fraction, weft_u32 period, GridLayout grid)
{
    return weft_locate(x, (weft_u32)fraction, period, grid.span, grid.cells, grid.inverse, grid.step, grid.size);
}

static float4 tile_level(global const LevelLayout *level, global const float4 *texels, weft_place x, weft_place y, weft_i32 whole,
                         weft_u32 group)
{
    const weft_pair px = weft_pair_at(x, whole, level->scale_x, level->width);
    const weft_pair py = weft_pair_at(y, whole, level->scale_y, level->height);
    global const float4 *plane = texels + level->offset + (size_t)group * level->plane_step;
    global const float4 *first = plane + (size_t)py.first * level->stride;
    global const float4 *second = plane + (size_t)py.second * level->stride;
    return lerp4(lerp4(first[px.first], first[px.second], px.t), lerp4(second[px.first], second[px.second], px.t), py.t);
}

static float4 tile_at(global const LayerLayout *layer, global const LevelLayout *levels, global const float4 *texels, Position at,
                      weft_u32 group)
{
    const weft_between between = weft_tile_level(at.level, layer->level, layer->levels);
    const weft_place x = locate(at.x, at.fraction_x, layer->period_x, layer->grid_x);
    const weft_place y = locate(at.y, at.fraction_y, layer->period_y, layer->grid_y);
    global const LevelLayout *level = levels + layer->first_level + between.whole;
    const float4 f = tile_level(level, texels, x, y, between.whole, group);
    return between.t > 0.0f ? lerp4(f, tile_level(level + 1, texels, x, y, between.whole + 1, group), between.t) : f;
}

kernel __attribute__((reqd_work_group_size(64, 1, 1)))
void tile_gather(global const LayerLayout *layers, global const LevelLayout *levels, global const float4 *texels,
                 global const SpotLayout *spots, global float *field, SamplesLayout samples, weft_u32 index)
{
    const weft_u32 column = get_global_id(0), row = get_global_id(1), group = get_global_id(2);
    if (column >= samples.width) return;
    global const LayerLayout *layer = layers + index;
    const Position at = position_of(samples, spots, column, row);
    const float4 f = tile_at(layer, levels, texels, at, group);
    const float values[4] = {f.x, f.y, f.z, f.w};
    global float *to = field + (size_t)(layer->plane_slot + group * 4) * samples.pitch + (size_t)row * samples.stride + column;
    for (weft_u32 p = 0; p < 4 && group * 4 + p < layer->planes; ++p) to[(size_t)p * samples.pitch] = values[p];
}

/* SPLAT ------------------------------------------------------------------------------------------------------------ */

/* One impact over one sample: its first tap in the framed level, and the places after it. */
typedef struct Touch {
    weft_i32 x, y;
    float tx, ty;
    weft_u32 reaches;
} Touch;

static Touch touch_at(global const LevelLayout *level, Position at, weft_i32 dx, weft_i32 dy, weft_i32 fraction_x,
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

static void add_linear(float4 *sum, global const float4 *texel, weft_u32 stride, Touch touch, float sign)
{
    const weft_weights2 w = weft_linear(touch.tx, touch.ty, sign);
    const float4 rho = w.rho;
    sum[0] = fma((float4)w.w0, fma(rho, texel[stride], texel[0]), sum[0]);
    sum[1] = fma((float4)w.w1, fma(rho, texel[stride + 1], texel[1]), sum[1]);
}

static void add_spline(float4 *sum, global const float4 *texel, weft_u32 stride, Touch touch, float sign, weft_u32 taps)
{
    const weft_weights wx = weft_spline(touch.tx, taps), wy = weft_spline(touch.ty, taps);
    for (weft_u32 i = 0; i < taps; ++i) {
        float4 v = wy.w[0] * texel[i];
        for (weft_u32 j = 1; j < taps; ++j) v = fma((float4)wy.w[j], texel[j * stride + i], v);
        sum[i] = fma((float4)(wx.w[i] * sign), v, sum[i]);
    }
}

static float tone(float v, global const weft_u32 *words, global const float *numbers, weft_u32 tones, weft_u32 channel)
{
    const weft_u32 count = words[tones + channel * 2];
    global const float *curve = numbers + words[tones + channel * 2 + 1];
    global const float *piece = curve + 2;
    v = weft_clamp(v, curve[0], curve[1]);
    for (weft_u32 k = 1; k < count && v >= piece[5]; ++k) piece += 5;
    return weft_piece_at(v - piece[0], piece[1], piece[2], piece[3], piece[4]);
}

/* Which image an impact shows: a plane of an earlier TILE, at the centre of the impact's own pixel. */
static weft_u32 chosen_image(global const LayerLayout *layers, global const LayerLayout *layer, global const LevelLayout *levels,
                             global const float4 *texels, global const weft_u32 *words, global const float *numbers, weft_i64 x,
                             weft_i64 y)
{
    global const LayerLayout *tile = layers + layer->choice_layer;
    const weft_u32 plane = layer->choice_plane;
    Position at;
    at.x = x;
    at.y = y;
    at.fraction_x = at.fraction_y = WEFT_FRACTION_HALF;
    at.level = 0.0f;
    const float4 f = tile_at(tile, levels, texels, at, plane / 4);
    const float values[4] = {f.x, f.y, f.z, f.w};
    float v = values[plane % 4];
    if (tile->tones != WEFT_NONE && plane < tile->channels) v = tone(v, words, numbers, tile->tones, plane);
    return weft_choose(v, layer->images);
}

static float4 splat_level(global const LayerLayout *layers, global const LayerLayout *layer, global const LevelLayout *levels,
                          global const float4 *texels, global const weft_u32 *words, global const float *numbers, Position at,
                          weft_u32 whole, weft_u32 group)
{
    if (whole >= layer->levels) return (float4)0.0f;
    global const LevelLayout *level = levels + layer->first_level + whole;
    global const float4 *texton = texels + level->offset + (size_t)group * level->plane_step;
    global const weft_u32 *counts = words + layer->counts;
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
                global const float4 *texel = texton + (size_t)touch.y * level->stride + touch.x;
                if (layer->choice_layer != WEFT_NONE)
                    texel += (size_t)level->image_step *
                             chosen_image(layers, layer, levels, texels, words, numbers, at.x + dx, at.y + dy);
                if (layer->taps == 2) add_linear(sum, texel, level->stride, touch, sign);
                else add_spline(sum, texel, level->stride, touch, sign, layer->taps);
            }
        }
    }
    float4 f = sum[0];
    for (weft_u32 i = 1; i < layer->taps; ++i) f = f + sum[i];
    return f + vload4(group, numbers + layer->offset);
}

kernel __attribute__((reqd_work_group_size(64, 1, 1)))
void splat_gather(global const LayerLayout *layers, global const LevelLayout *levels, global const float4 *texels,
                  global const SpotLayout *spots, global float *field, SamplesLayout samples, weft_u32 index,
                  global const weft_u32 *words, global const float *numbers)
{
    const weft_u32 column = get_global_id(0), row = get_global_id(1), group = get_global_id(2);
    if (column >= samples.width) return;
    global const LayerLayout *layer = layers + index;
    const Position at = position_of(samples, spots, column, row);
    const weft_between between = weft_level(at.level);
    float4 f = splat_level(layers, layer, levels, texels, words, numbers, at, (weft_u32)between.whole, group);
    if (between.t > 0.0f)
        f = lerp4(f, splat_level(layers, layer, levels, texels, words, numbers, at, (weft_u32)between.whole + 1, group), between.t);
    const float values[4] = {f.x, f.y, f.z, f.w};
    global float *to = field + (size_t)(layer->plane_slot + group * 4) * samples.pitch + (size_t)row * samples.stride + column;
    for (weft_u32 p = 0; p < 4 && group * 4 + p < layer->planes; ++p) to[(size_t)p * samples.pitch] = values[p];
}

/* The sum of layers ------------------------------------------------------------------------------------------------ */

static float16 tone16(float16 v, global const weft_u32 *words, global const float *numbers, weft_u32 tones, weft_u32 channel)
{
    float lane[WEFT_SAMPLES];
    vstore16(v, 0, lane);
    for (weft_u32 i = 0; i < WEFT_SAMPLES; ++i) lane[i] = tone(lane[i], words, numbers, tones, channel);
    return vload16(0, lane);
}

/* The layer's mask, that of the layer that owns the plane included. */
static float16 mask16(global const LayerLayout *layers, global const LayerLayout *layer, global float *field, weft_u32 pitch,
                      size_t sample)
{
    global const LayerLayout *owner = layers + layer->mask_layer;
    float16 mask = vload16(0, field + (size_t)(owner->plane_slot + layer->mask_plane) * pitch + sample);
    if (owner->mask_layer != WEFT_NONE) mask = mask * vload16(0, field + (size_t)owner->mask_slot * pitch + sample);
    if (layer->mask_slot != WEFT_NONE) vstore16(mask, 0, field + (size_t)layer->mask_slot * pitch + sample);
    return mask;
}

/* What splat_bands left of one plane: the accumulators, each shifted by its tap, and the offset. */
static float16 blocks16(global const float *sums, SumsLayout blocks, weft_u32 taps, weft_u32 plane, weft_u32 row, weft_u32 column,
                        float offset)
{
    global const float *sum = sums + (size_t)plane * taps * blocks.step + (size_t)row * blocks.stride + column;
    float16 f = vload16(0, sum);
    for (weft_u32 i = 1; i < taps; ++i) f = f + vload16(0, sum + (size_t)i * blocks.step + i);
    return f + offset;
}

/* A layer's planes, after tone, at 16 samples; those that are coloured in f. */
static void planes16(float16 *f, global const LayerLayout *layer, global const weft_u32 *words, global const float *numbers,
                     global float *field, global const float *sums, SamplesLayout samples, SumsLayout blocks, weft_u32 row,
                     weft_u32 column)
{
    const weft_u32 count = layer->kept ? layer->planes : layer->channels;
    global float *plane = field + (size_t)layer->plane_slot * samples.pitch + (size_t)row * samples.stride + column;
    for (weft_u32 p = 0; p < count; ++p, plane += samples.pitch) {
        float16 v = 0.0f;
        if (layer->form != WEFT_SPLAT_BANDS) v = vload16(0, plane);
        else if (blocks.level < layer->levels) v = blocks16(sums, blocks, layer->taps, p, row, column, numbers[layer->offset + p]);
        if (layer->tones != WEFT_NONE && p < layer->channels) v = tone16(v, words, numbers, layer->tones, p);
        if (layer->kept) vstore16(v, 0, plane);
        if (p < layer->channels) f[p] = v;
    }
}

/* out = mask * s + out, for the first `count` of 16 samples; out begins as 0. */
static void add16(global float *out, float16 mask, float16 s, weft_u32 step, weft_u32 count, weft_u32 begin)
{
    if (step == 1 && count == WEFT_SAMPLES) {
        const float16 before = begin ? 0.0f : vload16(0, out);
        vstore16(mask * s + before, 0, out);
    } else {
        float lane[WEFT_SAMPLES], weight[WEFT_SAMPLES];
        vstore16(s, 0, lane);
        vstore16(mask, 0, weight);
        for (weft_u32 i = 0; i < count; ++i) {
            global float *to = out + (size_t)i * step;
            *to = weft_madd(weight[i], lane[i], begin ? 0.0f : *to);
        }
    }
}

/* Adds a layer to the result. A layer without channels is only referred to. */
kernel __attribute__((reqd_work_group_size(1, 1, 1)))
void layer_sum(global const LayerLayout *layers, global const weft_u32 *words, global const float *numbers, global float *field,
               global const float *sums, global float *out, SamplesLayout samples, SumsLayout blocks, ResultLayout result,
               weft_u32 index)
{
    global const LayerLayout *layer = layers + index;
    const weft_u32 row = get_global_id(1), start = get_global_id(0) * samples.span;
    const weft_u32 channels = layer->channels, stop = min(start + samples.span, samples.width);
    float16 f[16];
    for (weft_u32 column = start; column < stop; column += WEFT_SAMPLES) {
        float16 mask = 1.0f;
        if (layer->mask_layer != WEFT_NONE)
            mask = mask16(layers, layer, field, samples.pitch, (size_t)row * samples.stride + column);
        planes16(f, layer, words, numbers, field, sums, samples, blocks, row, column);
        if (channels == 0 && index != 0) continue;
        const weft_u32 count = min(samples.width - column, (weft_u32)WEFT_SAMPLES);
        global float *to = out + (size_t)row * result.row + (size_t)column * result.sample;
        global const float *colour = numbers + layer->colour;
        for (weft_u32 o = 0; o < layer->colours; ++o, colour += channels, to += result.channel) {
            float16 s = channels == 0 ? 0.0f : numbers[layer->mean + o];
            for (weft_u32 c = 0; c < channels; ++c) s = colour[c] * f[c] + s;
            add16(to, mask, s, result.sample, count, index == 0);
        }
    }
}
