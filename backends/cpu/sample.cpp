/// Points: every layer in order, a few spots at a time. Nothing is allocated.
#include "texture.h"

namespace weft {

namespace {

/// Spots that are evaluated together, and what the layers of a program have at them.
struct Group {
    const weft_spot* spots;
    const float* frames; ///< null: none
    uint32_t count;
    float f[most_layers][most_planes][most_spots];
    float mask[most_layers][most_spots];
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

/// f of a TILE at spot i of a group, which has what the layer's displacement refers to.
void tile(const Rows& rows, const Layer& layer, const Group& group, uint32_t i, float* f)
{
    const weft_spot& spot = group.spots[i];
    const uint32_t planes = layer.source->planes;
    if (!layer.composed) return tile_point(layer.tile, spot.cell, spot.fraction, spot.level, 0, planes, f);
    const weft_ref moved = layer.source->tile->displacement;
    float by[2] = {0, 0};
    for (uint32_t axis = 0; axis < 2 && moved.layer >= 0; ++axis)
        by[axis] = group.f[moved.layer][moved.plane + axis][i];
    compose_point(rows, layer.tile, spot, moved.layer < 0 ? nullptr : by, 0, planes, f);
}

/// Does a layer add nothing but zeros?
bool hidden(const Layer& layer, float mask) { return !layer.referred && mask == 0; }

/// f of one layer at all spots of a group; 0 where it is hidden.
void evaluate(const weft_backend_texture& texture, uint32_t index, Group& group)
{
    const Layer& layer = texture.layers[index];
    const weft_layer& source = *layer.source;
    const Rows& rows = *texture.rows;
    float(&f)[most_planes][most_spots] = group.f[index];
    if (source.kind == WEFT_LAYER_BANDS)
        rows.bands_spots(layer.bands, texture.program->use == WEFT_USE_SOLID ? 3 : 2, group.spots, group.count, f[0],
                         most_spots);
    for (uint32_t i = 0; i < group.count && source.kind != WEFT_LAYER_BANDS; ++i) {
        const weft_spot& spot = group.spots[i];
        float values[most_planes] = {0};
        if (hidden(layer, group.mask[index][i]))
            ; // zeros will do
        else if (source.kind == WEFT_LAYER_SPLAT)
            splat(rows, layer, spot, group.frames ? group.frames + 9 * size_t(i) : nullptr, values);
        else
            tile(rows, layer, group, i, values);
        for (uint32_t p = 0; p < source.planes; ++p) f[p][i] = values[p];
    }
    if (!source.tones) return;
    for (uint32_t c = 0; c < source.channels; ++c) rows.tone(layer.tones.data()[c], group.count, f[c]);
}

void sample(const weft_backend_texture& texture, Group& group, float* out)
{
    const weft_program& program = *texture.program;
    const uint32_t results = program.channels;
    float sums[most_results][most_spots];
    for (uint32_t o = 0; o < results; ++o)
        for (uint32_t i = 0; i < group.count; ++i) sums[o][i] = 0.0f;
    for (uint32_t index = 0; index < program.layer_count; ++index) {
        const Layer& layer = texture.layers[index];
        const weft_layer& source = *layer.source;
        for (uint32_t i = 0; i < group.count; ++i)
            group.mask[index][i] =
                layer.masked ? group.f[source.mask.layer][source.mask.plane][i] * group.mask[source.mask.layer][i]
                             : 1.0f;
        evaluate(texture, index, group);
        if (source.channels == 0) continue; // only referred to
        const Mixture mixture = {false,      results,    source.channels, group.count, group.f[index][0],
                                 most_spots, most_spots, source.colour,   source.mean, group.mask[index]};
        texture.rows->mix(mixture, sums[0]);
    }
    for (uint32_t i = 0; i < group.count; ++i)
        for (uint32_t o = 0; o < results; ++o) *out++ = sums[o][i];
}

} // namespace

weft_status texture_sample(weft_backend_texture* texture, const weft_batch* batch) noexcept
{
    Group group;
    for (uint32_t i = 0; i < batch->count; i += group.count) {
        group.spots = batch->spots + i;
        group.frames = texture->program->use == WEFT_USE_SURFACE ? batch->frames + 9 * size_t(i) : nullptr;
        group.count = batch->count - i < most_spots ? batch->count - i : most_spots;
        sample(*texture, group, batch->out + size_t(i) * texture->program->channels);
    }
    return WEFT_OK;
}

} // namespace weft
