/// In the plane a tile that masks one splat of two taps and chooses the textons of another of four, and bands; on
/// surfaces the splats alone, in space the bands. The bands displace a second tile, of Wang tiles with exchange.
#include "opencl/self_test_program.h"
#include <algorithm>

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

/// Every view is one patch, deeper towards its middle, with a content that is turned and scaled and one that is not.
void SelfTestProgram::compose()
{
    const auto random = [](std::size_t i, std::uint32_t count) {
        return static_cast<std::int32_t>(weft_high(weft_mix(i + 1)) % count);
    };
    for (std::size_t i = 0; i < sizeof edges_; ++i)
        edges_[i] = static_cast<std::int8_t>(i % (knots + 1) == knots / 2 ? random(i, 3) - 1 : 0);
    for (std::size_t i = 0; i < sizeof sharp_ / sizeof *sharp_; ++i) sharp_[i] = i % (knots + 1) == 2 ? 1.25f : 2.5f;
    for (std::uint32_t i = 0; i < views * cell_y * cell_x; ++i) {
        const std::uint32_t x = i % cell_x, y = i / cell_x % cell_y;
        const std::uint32_t depth = std::min({x, y, cell_x - 1 - x, cell_y - 1 - y});
        map_[i] = i / (cell_x * cell_y) | (depth * 12) << WEFT_MAP_DEPTH;
    }
    for (std::uint32_t i = 0; i < views; ++i) {
        diamonds_[i] = {random(i, 12), random(i + 9, 10)};
        patches_[i] = {4, 2, 2 * i, 2};
        contents_[2 * i] = {0x90000000, random(i + 20, 12), random(i + 30, 10), {0.0f, -1.5f, 1.5f, 0.0f}, 0.585f};
        contents_[2 * i + 1] = {0, random(i + 40, 12), random(i + 50, 10), {1.0f, 0.0f, 0.0f, 1.0f}, 0.0f};
    }
    for (std::size_t i = 0; i < sizeof contours_; ++i) contours_[i] = static_cast<std::uint8_t>(random(i + 60, 12));
    wang_ = {sizeof wang_,
             colours_of_edges,
             knots,
             static_cast<float>(knots) / cell_x,
             static_cast<float>(knots) / cell_y,
             0,
             diamonds_,
             edges_,
             sharp_};
    exchange_ = {sizeof exchange_, views, map_, patches_, contents_, contours_, feathers};
    composed_ = tile_;
    composed_.address = WEFT_ADDRESS_WANG;
    composed_.width = cell_x;
    composed_.height = cell_y;
    composed_.x = {37, 5, 1.0f / 37.0f, 40.0f / 37.0f};
    composed_.y = {41, 7, 1.0f / 41.0f, 42.0f / 41.0f};
    composed_.wang = &wang_;
    composed_.exchange = &exchange_;
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
    compose();
    splats_[0] = splat(two_, 2);
    splats_[1] = splat(four_, 4);
    if (plane) splats_[1].choice = {0, 0};
    weft_layer tile = layer(WEFT_LAYER_TILE, 2, -1), two = layer(WEFT_LAYER_SPLAT, 2, plane ? 0 : -1),
               four = layer(WEFT_LAYER_SPLAT, 1, -1), bands = layer(WEFT_LAYER_BANDS, 2, -1),
               composed = layer(WEFT_LAYER_TILE, 2, plane ? 0 : -1);
    composed.tile = &composed_;
    tile.tile = &tile_;
    tile.tones = bands.tones = tones;
    two.splat = &splats_[0];
    four.splat = &splats_[1];
    bands.bands = &bands_;
    if (plane) add(tile);
    if (use != WEFT_USE_SOLID) add(two), add(four);
    if (use != WEFT_USE_SURFACE) add(bands);
    composed_.displacement = {static_cast<std::int32_t>(program.layer_count) - 1, 0};
    if (plane) add(composed);
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
