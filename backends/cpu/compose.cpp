/// Where the pixels of windows and the points of a composed TILE lie; the kernels say what is to be seen there.
#include "compose.h"

namespace weft {

bool is_composed(const weft_tile& tile)
{
    return tile.address != WEFT_ADDRESS_CELLS || tile.exchange || tile.displacement.layer >= 0;
}

namespace {

/// Floats of a texel of a copy: its planes, in eights.
uint32_t copied_planes(const weft_mips& source) { return (source.planes + 7) / 8 * 8; }

size_t copied_size(const weft_mips& source, const weft_mip& mip)
{
    return (size_t(mip.width) + 1) * (size_t(mip.height) + 1) * copied_planes(source);
}

/// One column and one row more than there are repeat the first, so that four texels are always neighbours.
void copy_level(const weft_mips& source, const weft_mip& mip, float* to)
{
    const uint32_t planes = copied_planes(source);
    const size_t plane = size_t(mip.width) * mip.height;
    for (uint32_t y = 0; y <= mip.height; ++y)
        for (uint32_t x = 0; x <= mip.width; ++x, to += planes) {
            const float* from = mip.data + size_t(y % mip.height) * mip.width + x % mip.width;
            for (uint32_t p = 0; p < planes; ++p) to[p] = p < source.planes ? from[p * plane] : 0.0f;
        }
}

bool copy_source(const weft_mips& source, Buffer<float>& data, Texels* texels)
{
    size_t total = 0;
    for (uint32_t l = 0; l < source.levels; ++l) total += copied_size(source, source.level[l]);
    if (!data.reserve(total)) return false;
    float* to = data.data();
    for (uint32_t l = 0; l < source.levels; ++l) {
        const weft_mip& mip = source.level[l];
        copy_level(source, mip, to);
        texels[l] = {};
        texels[l].data = to;
        texels[l].row = (int64_t(mip.width) + 1) * copied_planes(source);
        to += copied_size(source, mip);
    }
    return true;
}

bool find_ranges(const weft_exchange& exchange, Buffer<Contour_range>& ranges)
{
    uint32_t count = 0;
    for (uint32_t p = 0; p < exchange.patch_count; ++p) {
        const uint32_t end = exchange.patches[p].first + exchange.patches[p].count;
        count = end > count ? end : count;
    }
    if (!ranges.reserve(count)) return false;
    for (uint32_t i = 0; i < count; ++i) {
        Contour_range range = {UINT8_MAX, 0};
        for (uint32_t k = 0; k < WEFT_CONTOUR; ++k) {
            const uint8_t depth = exchange.contours[size_t(i) * WEFT_CONTOUR + k];
            range.least = depth < range.least ? depth : range.least;
            range.most = depth > range.most ? depth : range.most;
        }
        ranges.data()[i] = range;
    }
    return true;
}

} // namespace

bool open_composed(const weft_layer& layer, const weft_program& program, bool copied, Composed_data& data,
                   Texels* texels, Composed& composed)
{
    const weft_tile& tile = *layer.tile;
    if (tile.exchange && !find_ranges(*tile.exchange, data.ranges)) return false;
    composed = {&tile,
                layer.planes,
                {program.period[0] != 0 ? tile.x.cells : 0, program.period[1] != 0 ? tile.y.cells : 0},
                weft_key(program.seed, layer.stream, WEFT_TAG_NORTH),
                weft_key(program.seed, layer.stream, WEFT_TAG_WEST),
                weft_key(program.seed, layer.stream, WEFT_TAG_CONTENTS),
                data.ranges.data(),
                copied_planes(*tile.source) / 8,
                texels};
    return !copied || copy_source(*tile.source, data.texels, texels);
}

void compose_point(const Rows& rows, const Tile& tile, const weft_spot& spot, const float* displacement, uint32_t first,
                   uint32_t count, float* f)
{
    weft_place at[2];
    Axis_places places[2];
    for (uint32_t axis = 0; axis < 2; ++axis) {
        at[axis] = tile.place(axis, spot.cell[axis], spot.fraction[axis]);
        places[axis] = {&at[axis].cell, &at[axis].texel, &at[axis].fraction, 1,
                        displacement ? displacement + axis : nullptr};
    }
    rows.compose(tile.composed, places, 1, spot.level, first, count, f, 1);
}

bool Composed_block::begin(const Rows& rows, const Tile& tile, const Block& block)
{
    rows_ = &rows;
    tile_ = &tile;
    block_ = block;
    if (!axes_[0].reserve(block.width) || !axes_[1].reserve(block.height)) return false;
    const uint32_t fraction = block.level == 0 ? WEFT_FRACTION_HALF : 0;
    const int64_t step = int64_t(1) << block.level;
    for (uint32_t x = 0; x < block.width; ++x)
        axes_[0].set(x, tile.place(0, (block.x + x) * step + step / 2, fraction));
    for (uint32_t y = 0; y < block.height; ++y)
        axes_[1].set(y, tile.place(1, (block.y + y) * step + step / 2, fraction));
    return true;
}

/// Column by column of squares: what pixels of a square look at, turned as it may be, stays in the nearest cache.
void Composed_block::strip(const Strip& strip, const float* displacement)
{
    constexpr uint32_t square = 32;
    const size_t plane = size_t(strip.count) * strip.stride;
    for (uint32_t begin = 0; begin < strip.width; begin += square) {
        const uint32_t width = strip.width - begin < square ? strip.width - begin : square;
        for (uint32_t y = 0; y < strip.count; ++y) {
            const size_t offset = size_t(y) * strip.stride + begin;
            const float* moved = displacement ? displacement + offset : nullptr;
            const Axis_places places[2] = {axes_[0].from(begin, 1, moved),
                                           axes_[1].from(strip.first + y, 0, moved ? moved + plane : nullptr)};
            rows_->compose(tile_->composed, places, width, float(block_.level), 0, tile_->planes, strip.data + offset,
                           plane);
        }
    }
}

} // namespace weft
