/// Points: every layer in order, a few spots at a time. Nothing is allocated.
#include "texture.h"

namespace weft {

namespace {

/// What the layers of a program have at one spot.
struct Values {
    float f[most_layers][most_planes];
    float mask[most_layers];
};

/// f at a whole level: in the plane, or on a surface if there is a frame.
void splat_at(const Rows& rows, const Splat& splat, uint32_t level, const weft_spot& spot, const float* frame, float* f)
{
    if (frame)
        rows.splat_surface(splat, level, spot, frame, f);
    else
        rows.splat_point(splat, level, spot, f);
}

void splat(const Rows& rows, const Layer& layer, const weft_spot& spot, const float* frame, float* f)
{
    const weft_between between = weft_level(spot.level);
    const uint32_t level = uint32_t(between.whole), planes = layer.splat.planes;
    for (uint32_t p = 0; p < planes; ++p) f[p] = 0.0f;
    if (!splat_has(layer, level)) return;
    splat_at(rows, layer.splat, level, spot, frame, f);
    if (!(between.t > 0)) return;
    float coarse[most_planes] = {0};
    if (splat_has(layer, level + 1)) splat_at(rows, layer.splat, level + 1, spot, frame, coarse);
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

/// Spots that are evaluated together.
struct Group {
    const weft_spot* spots;
    const float* frames; ///< null: none
    uint32_t count;
    Values values[most_spots];
};

/// `values` has what the layer's displacement refers to.
void tile(const Rows& rows, const Layer& layer, const weft_spot& spot, const Values& values, float* f)
{
    const weft_ref moved = layer.source->tile->displacement;
    const uint32_t planes = layer.source->planes;
    if (layer.composed)
        compose_point(rows, layer.tile, spot, moved.layer < 0 ? nullptr : values.f[moved.layer] + moved.plane, 0,
                      planes, f);
    else
        tile_point(layer.tile, spot.cell, spot.fraction, spot.level, 0, planes, f);
}

/// Does a layer add nothing but zeros?
bool hidden(const Layer& layer, float mask) { return !layer.referred && mask == 0; }

/// f of one layer at all spots of a group where it is not hidden.
void evaluate(const weft_backend_texture& texture, uint32_t index, Group& group)
{
    const Layer& layer = texture.layers[index];
    const Rows& rows = *texture.rows;
    if (layer.source->kind == WEFT_LAYER_BANDS)
        rows.bands_spots(layer.bands, texture.program->use == WEFT_USE_SOLID ? 3 : 2, group.spots, group.count,
                         group.values[0].f[index], sizeof(Values) / sizeof(float));
    for (uint32_t i = 0; i < group.count; ++i) {
        const weft_spot& spot = group.spots[i];
        float* f = group.values[i].f[index];
        if (hidden(layer, group.values[i].mask[index])) continue;
        if (layer.source->kind == WEFT_LAYER_SPLAT)
            splat(rows, layer, spot, group.frames ? group.frames + 9 * size_t(i) : nullptr, f);
        else if (layer.source->kind == WEFT_LAYER_TILE)
            tile(rows, layer, spot, group.values[i], f);
        if (!layer.source->tones) continue;
        for (uint32_t c = 0; c < layer.source->channels; ++c) rows.tone(layer.source->tones[c], 1, f + c);
    }
}

void sample(const weft_backend_texture& texture, Group& group, float* out)
{
    const weft_program& program = *texture.program;
    for (uint32_t o = 0; o < group.count * program.channels; ++o) out[o] = 0.0f;
    for (uint32_t index = 0; index < program.layer_count; ++index) {
        const Layer& layer = texture.layers[index];
        const weft_ref ref = layer.source->mask;
        for (uint32_t i = 0; i < group.count; ++i) {
            Values& values = group.values[i];
            values.mask[index] = layer.masked ? values.f[ref.layer][ref.plane] * values.mask[ref.layer] : 1.0f;
        }
        evaluate(texture, index, group);
        for (uint32_t i = 0; i < group.count; ++i) {
            Values& values = group.values[i];
            if (hidden(layer, values.mask[index]) || layer.source->channels == 0) continue; // only referred to
            mix(*layer.source, program.channels, values.f[index], values.mask[index], out + i * program.channels);
        }
    }
}

} // namespace

weft_status texture_sample(weft_backend_texture* texture, const weft_batch* batch) noexcept
{
    Group group;
    const uint32_t most = texture->rows->spots;
    for (uint32_t i = 0; i < batch->count; i += group.count) {
        group.spots = batch->spots + i;
        group.frames = texture->program->use == WEFT_USE_SURFACE ? batch->frames + 9 * size_t(i) : nullptr;
        group.count = batch->count - i < most ? batch->count - i : most;
        sample(*texture, group, batch->out + size_t(i) * texture->program->channels);
    }
    return WEFT_OK;
}

} // namespace weft
