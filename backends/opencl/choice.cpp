/// TILE at a pixel's centre, and the tone curve, as samples.cl and tile.cl have them.
#include "opencl/choice.h"

namespace weft::opencl {

namespace {

weft_place locate(weft_i64 x, weft_u32 period, const weft_grid& grid, weft_u32 size) noexcept
{
    return weft_locate(x, WEFT_FRACTION_HALF, period, grid.span, grid.cells, grid.inverse, grid.step, size);
}

float tone(float v, const weft_tone& curve) noexcept
{
    v = weft_clamp(v, curve.low, curve.high);
    const weft_piece* piece = curve.pieces;
    for (weft_u32 k = 1; k < curve.count && v >= piece[1].x; ++k) ++piece;
    return weft_piece_at(v - piece->x, piece->c0, piece->c1, piece->c2, piece->c3);
}

} // namespace

Choice::Choice(const weft_program& program, const weft_splat& splat) noexcept
    : program_(program), textons_(*splat.textons), plane_(splat.choice.plane)
{
    if (splat.choice.layer < 0) return;
    const weft_layer& layer = *program.layers[splat.choice.layer];
    tile_ = layer.tile;
    if (layer.tones && plane_ < layer.channels) tone_ = layer.tones + plane_;
}

float Choice::tile_level(weft_place x, weft_place y, weft_i32 whole) const noexcept
{
    const weft_mip& mip = tile_->source->level[whole];
    const weft_pair px = weft_pair_at(x, whole, mip.scale_x, mip.width),
                    py = weft_pair_at(y, whole, mip.scale_y, mip.height);
    const auto row = [&](weft_i32 at) {
        const float* texels = mip.data + (std::size_t{plane_} * mip.height + static_cast<std::size_t>(at)) * mip.width;
        return weft_lerp(texels[px.first], texels[px.second], px.t);
    };
    return weft_lerp(row(py.first), row(py.second), py.t);
}

weft_u32 Choice::image(weft_i64 x, weft_i64 y) const noexcept
{
    if (!tile_) return 0;
    const weft_between between = weft_tile_level(0.0f, tile_->level, tile_->source->levels);
    const weft_place at_x = locate(weft_choice_pixel(x, textons_.width), program_.period[0], tile_->x, tile_->width),
                     at_y = locate(weft_choice_pixel(y, textons_.height), program_.period[1], tile_->y, tile_->height);
    float v = tile_level(at_x, at_y, between.whole);
    if (between.t > 0.0f) v = weft_lerp(v, tile_level(at_x, at_y, between.whole + 1), between.t);
    return weft_choose(tone_ ? tone(v, *tone_) : v, textons_.images);
}

} // namespace weft::opencl
