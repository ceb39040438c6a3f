/// A tile that masks one splat of two taps and chooses the textons of another of four.
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

SelfTestProgram::SelfTestProgram(weft_use use)
{
    fill(source_, 2, 1, 12, 10);
    fill(two_, 2, 1, 9, 7);
    fill(four_, 1, 3, 6, 11);
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
    splats_[1].choice = {0, 1};
    layers_[0] = layer(WEFT_LAYER_TILE, 2, -1);
    layers_[0].tile = &tile_;
    layers_[0].tones = tones;
    layers_[1] = layer(WEFT_LAYER_SPLAT, 2, 0);
    layers_[1].splat = &splats_[0];
    layers_[2] = layer(WEFT_LAYER_SPLAT, 1, -1);
    layers_[2].splat = &splats_[1];
    for (int i = 0; i < 3; ++i) order_[i] = &layers_[i];
    program.size = sizeof program;
    program.use = use;
    program.channels = channels;
    program.layer_count = 3;
    program.seed = 0x1234567890abcdef;
    program.period[0] = 37;
    program.period[1] = 41;
    program.layers = order_;
}

} // namespace weft::opencl
