/* The sum of layers: tone, mask, colour, mean. */

#pragma OPENCL FP_CONTRACT OFF

/* A plane's tone curve, at 16 samples: of all pieces the last one that begins at or below each. */
static float16 tone16(float16 v, global const weft_u32* words, global const float* numbers, weft_u32 tones,
                      weft_u32 channel)
{
    const weft_u32 count = words[tones + channel * 2];
    global const float* curve = numbers + words[tones + channel * 2 + 1];
    global const float* piece = curve + 2;
    v = select(v, (float16)curve[0], v < curve[0]);
    v = select(v, (float16)curve[1], v > curve[1]);
    float16 x = piece[0], c0 = piece[1], c1 = piece[2], c2 = piece[3], c3 = piece[4];
    for (weft_u32 k = 1; k < count; ++k) {
        piece += 5;
        const int16 reached = v >= piece[0];
        x = select(x, (float16)piece[0], reached);
        c0 = select(c0, (float16)piece[1], reached);
        c1 = select(c1, (float16)piece[2], reached);
        c2 = select(c2, (float16)piece[3], reached);
        c3 = select(c3, (float16)piece[4], reached);
    }
    const float16 d = v - x;
    return ((c3 * d + c2) * d + c1) * d + c0; /* weft_piece_at */
}

/* The layer's mask, that of the layer that owns the plane included. */
static float16 mask16(global const LayerLayout* layers, global const LayerLayout* layer, global float* field,
                      weft_u32 pitch, size_t sample)
{
    global const LayerLayout* owner = layers + layer->mask_layer;
    float16 mask = vload16(0, field + (size_t)(owner->plane_slot + layer->mask_plane) * pitch + sample);
    if (owner->mask_layer != WEFT_NONE) mask = mask * vload16(0, field + (size_t)owner->mask_slot * pitch + sample);
    if (layer->mask_slot != WEFT_NONE) vstore16(mask, 0, field + (size_t)layer->mask_slot * pitch + sample);
    return mask;
}

/* What splat_bands left of one plane: the accumulators, each shifted by its tap, and the offset. */
static float16 blocks16(global const float* sums, SumsLayout blocks, weft_u32 taps, weft_u32 plane, weft_u32 row,
                        weft_u32 column, float offset)
{
    global const float* sum = sums + (size_t)plane * taps * blocks.step + (size_t)row * blocks.stride + column;
    float16 f = vload16(0, sum);
    for (weft_u32 i = 1; i < taps; ++i) f = f + vload16(0, sum + (size_t)i * blocks.step + i);
    return f + offset;
}

/* A layer's planes, after tone, at 16 samples; those that are coloured in f. */
static void planes16(float16* f, global const LayerLayout* layer, global const weft_u32* words,
                     global const float* numbers, global float* field, global const float* sums, SamplesLayout samples,
                     SumsLayout blocks, weft_u32 row, weft_u32 column)
{
    const weft_u32 count = layer->kept ? layer->planes : layer->channels;
    global float* plane = field + (size_t)layer->plane_slot * samples.pitch + (size_t)row * samples.stride + column;
    for (weft_u32 p = 0; p < count; ++p, plane += samples.pitch) {
        float16 v = 0.0f;
        if (layer->form != WEFT_SPLAT_BANDS)
            v = vload16(0, plane);
        else if (blocks.level < layer->levels)
            v = blocks16(sums, blocks, layer->taps, p, row, column, numbers[layer->offset + p]);
        if (layer->tones != WEFT_NONE && p < layer->channels) v = tone16(v, words, numbers, layer->tones, p);
        if (layer->kept) vstore16(v, 0, plane);
        if (p < layer->channels) f[p] = v;
    }
}

/* out = mask * s + out, for the first `count` of 16 samples; out begins as 0. */
static void add16(global float* out, float16 mask, float16 s, weft_u32 step, weft_u32 count, weft_u32 begin)
{
    if (step == 1 && count == WEFT_SAMPLES) {
        const float16 before = begin ? 0.0f : vload16(0, out);
        vstore16(mask * s + before, 0, out);
    } else {
        float lane[WEFT_SAMPLES], weight[WEFT_SAMPLES];
        vstore16(s, 0, lane);
        vstore16(mask, 0, weight);
        for (weft_u32 i = 0; i < count; ++i) {
            global float* to = out + (size_t)i * step;
            *to = weft_madd(weight[i], lane[i], begin ? 0.0f : *to);
        }
    }
}

/* Adds a layer to the result. A layer without channels is only referred to. */
kernel __attribute__((reqd_work_group_size(1, 1, 1))) void
layer_sum(global const LayerLayout* layers, global const weft_u32* words, global const float* numbers,
          global float* field, global const float* sums, global float* out, SamplesLayout samples, SumsLayout blocks,
          ResultLayout result, weft_u32 index)
{
    global const LayerLayout* layer = layers + index;
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
        global float* to = out + (size_t)row * result.row + (size_t)column * result.sample;
        global const float* colour = numbers + layer->colour;
        for (weft_u32 o = 0; o < layer->colours; ++o, colour += channels, to += result.channel) {
            float16 s = channels == 0 ? 0.0f : numbers[layer->mean + o];
            for (weft_u32 c = 0; c < channels; ++c) s = colour[c] * f[c] + s;
            add16(to, mask, s, result.sample, count, index == 0);
        }
    }
}
