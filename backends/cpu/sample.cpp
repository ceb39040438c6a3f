/// Points: every layer in order, spot by spot. Nothing is allocated.
#include "texture.h"

namespace weft {

namespace {

/// What the layers of a program have at one spot.
struct Values {
    float f[most_layers][most_planes];
    float mask[most_layers];
};

void splat(const weft_backend_texture& texture, const Layer& layer, const weft_spot& spot, float* f)
{
    const weft_between between = weft_level(spot.level);
    const uint32_t level = uint32_t(between.whole), planes = layer.splat.planes;
    for (uint32_t p = 0; p < planes; ++p) f[p] = 0.0f;
    if (!splat_has(layer, level)) return;
    texture.rows->splat_point(layer.splat, level, spot, f);
    if (!(between.t > 0)) return;
    float coarse[most_planes] = {0};
    if (splat_has(layer, level + 1)) texture.rows->splat_point(layer.splat, level + 1, spot, coarse);
    for (uint32_t p = 0; p < planes; ++p) f[p] = weft_lerp(f[p], coarse[p], between.t);
}

void mix(const weft_layer& layer, uint32_t channels, const float* f, float mask, float* out)
{
    for (uint32_t o = 0; o < channels; ++o) {
        float sum = layer.mean[o];
        for (uint32_t c = 0; c < layer.channels; ++c) sum = weft_madd(layer.colour[o * layer.channels + c], f[c], sum);
        out[o] = weft_madd(mask, sum, out[o]);
    }
}

void sample(const weft_backend_texture& texture, const weft_spot& spot, Values& values, float* out)
{
    const weft_program& program = *texture.program;
    for (uint32_t o = 0; o < program.channels; ++o) out[o] = 0.0f;
    for (uint32_t i = 0; i < program.layer_count; ++i) {
        const Layer& layer = texture.layers[i];
        const weft_layer& source = *layer.source;
        float* f = values.f[i];
        if (source.kind == WEFT_LAYER_SPLAT)
            splat(texture, layer, spot, f);
        else
            tile_point(layer.tile, spot.cell, spot.fraction, spot.level, 0, source.planes, f);
        if (source.tones)
            for (uint32_t c = 0; c < source.channels; ++c) texture.rows->tone(source.tones[c], 1, f + c);
        const weft_ref mask = source.mask;
        values.mask[i] = layer.masked ? values.f[mask.layer][mask.plane] * values.mask[mask.layer] : 1.0f;
        if (source.channels > 0) mix(source, program.channels, f, values.mask[i], out);
    }
}

} // namespace

weft_status texture_sample(weft_backend_texture* texture, const weft_batch* batch) noexcept
{
    Values values;
    for (uint32_t i = 0; i < batch->count; ++i)
        sample(*texture, batch->spots[i], values, batch->out + size_t(i) * texture->program->channels);
    return WEFT_OK;
}

} // namespace weft
