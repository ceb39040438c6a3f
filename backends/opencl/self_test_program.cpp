/// In the plane a tile that masks one splat of two taps and chooses the textons of another of four, and bands; on
/// surfaces the splats alone, in space the bands.
#include "opencl/self_test_program.h"

namespace weft::opencl {

void SelfTestProgram::fill(Pictures& pictures, std::uint32_t planes, std::uint32_t images, std::uint32_t size_x,
                           std::uint32_t size_y)
{
    for (std::uint32_t l = 0; l < 2; ++l) {
        const std::uint32_t level_x = (size_x + l) >> l, level_y = (size_y + l) >> l;
        weft_mip& mip = pictures.levels[l];
        mip = {data_ + used_,
               level_x,
               level_y,
               0,
               0,
               static_cast<float>(level_x) / static_cast<float>(size_x),
               static_cast<float>(level_y) / static_cast<float>(size_y)};
        for (std::size_t n = std::size_t{images} * planes * level_x * level_y; n != 0; --n, ++used_)
            data_[used_] = static_cast<float>(static_cast<std::int32_t>(weft_mix(used_) >> 40) - (1 << 23)) * 0x1p-23f;
    }
    pictures.mips = {sizeof(weft_mips), size_x, size_y, planes, images, 2, pictures.levels};
}

weft_splat SelfTestProgram::splat(const Pictures& textons, std::uint32_t taps) const
{
    weft_splat splat = {};
    splat.size = sizeof splat;
    splat.taps = taps;
    splat.cell_log2 = taps;
    splat.count_limit = 4;
    splat.counts = thresholds;
    splat.signs = 1;
    splat.choice = {-1, 0};
    splat.textons = &textons.mips;
    splat.offset = zeros;
    return splat;
}

weft_layer SelfTestProgram::layer(weft_layer_kind kind, std::uint32_t planes, std::int32_t mask_layer) const
{
    weft_layer layer = {};
    layer.size = sizeof layer;
    layer.kind = kind;
    layer.stream = 5;
    layer.planes = layer.channels = planes;
    layer.mask = {mask_layer, 1};
    layer.colour = colours;
    layer.mean = means;
    return layer;
}

/// Sizes that are powers of two and some that are not, shifts, and a band without a lattice.
void SelfTestProgram::fill_bands(weft_use use)
{
    const std::uint32_t depth = use == WEFT_USE_SOLID ? 3 : 1;
    table_[0] = {data_, 8, 4, depth, 3, 1, 1, 0.4f, 0};
    table_[1] = {data_ + 100, 7, 5, depth, 1000, 77, 5, -0.3f, 0};
    table_[2] = {data_ + 200, 8, 8, depth, 0, 0, 0, 0.25f, 0};
    table_[3] = {};
    table_[4] = {data_ + 300, 3, 11, depth, 2, 9, 0, 0.7f, 0};
    table_[5] = {data_ + 400, 1, 2, depth, 0, 1, 2, 0.5f, 0};
}

void SelfTestProgram::add(const weft_layer& layer)
{
    weft_layer& to = layers_[program.layer_count];
    to = layer;
    order_[program.layer_count++] = &to;
}

SelfTestProgram::SelfTestProgram(weft_use use)
{
    const bool plane = use == WEFT_USE_WINDOW || use == WEFT_USE_POINTS;
    fill(source_, 2, 1, 12, 10);
    fill(two_, 2, 1, 9, 7);
    fill(four_, 1, 3, 6, 11);
    fill_bands(use);
    tile_.size = sizeof tile_;
    tile_.width = 12;
    tile_.height = 10;
    tile_.x = {37, 3, 1.0f / 37.0f, 36.0f / 37.0f};
    tile_.y = {41, 4, 1.0f / 41.0f, 40.0f / 41.0f};
    tile_.displacement = {-1, 0};
    tile_.level = 0.25f;
    tile_.source = &source_.mips;
    splats_[0] = splat(two_, 2);
    splats_[1] = splat(four_, 4);
    if (plane) splats_[1].choice = {0, 0};
    weft_layer tile = layer(WEFT_LAYER_TILE, 2, -1), two = layer(WEFT_LAYER_SPLAT, 2, plane ? 0 : -1),
               four = layer(WEFT_LAYER_SPLAT, 1, -1), bands = layer(WEFT_LAYER_BANDS, 2, -1);
    tile.tile = &tile_;
    tile.tones = bands.tones = tones;
    two.splat = &splats_[0];
    four.splat = &splats_[1];
    bands.bands = &bands_;
    if (plane) add(tile);
    if (use != WEFT_USE_SOLID) add(two), add(four);
    if (use != WEFT_USE_SURFACE) add(bands);
    program.size = sizeof program;
    program.use = use;
    program.channels = channels;
    program.seed = 0x1234567890abcdef;
    program.period[0] = 37;
    program.period[1] = 41;
    program.period[2] = plane ? 0 : 43;
    program.layers = order_;
}

} // namespace weft::opencl
