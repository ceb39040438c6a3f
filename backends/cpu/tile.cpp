/// TILE with WEFT_ADDRESS_CELLS: points, and windows row by row. Columns are located once per block; a row of the
/// source, expanded to the block's columns, serves both rows of pixels that it lies between.
#include "tile.h"

namespace weft {

weft_place Tile::place(uint32_t axis, int64_t pixel, uint32_t fraction) const
{
    const weft_grid& grid = axis == 0 ? tile->x : tile->y;
    return weft_locate(pixel, fraction, period[axis], grid.span, grid.cells, grid.inverse, grid.step,
                       axis == 0 ? tile->width : tile->height);
}

weft_pair Tile::pair(uint32_t axis, const weft_place& place, int32_t level) const
{
    const weft_mip& mip = tile->source->level[level];
    return axis == 0 ? weft_pair_at(place, level, mip.scale_x, mip.width)
                     : weft_pair_at(place, level, mip.scale_y, mip.height);
}

namespace {

float texel(const weft_mip& mip, uint32_t plane, int32_t x, int32_t y)
{
    return mip.data[(size_t(plane) * mip.height + size_t(y)) * mip.width + size_t(x)];
}

float tile_level(const Tile& tile, const weft_place* places, int32_t level, uint32_t plane)
{
    const weft_mip& mip = tile.tile->source->level[level];
    const weft_pair x = tile.pair(0, places[0], level), y = tile.pair(1, places[1], level);
    const float upper = weft_lerp(texel(mip, plane, x.first, y.first), texel(mip, plane, x.second, y.first), x.t);
    const float lower = weft_lerp(texel(mip, plane, x.first, y.second), texel(mip, plane, x.second, y.second), x.t);
    return weft_lerp(upper, lower, y.t);
}

/// Runs shorter than this are not worth a loop of their own.
constexpr uint32_t shortest_run = 16;

} // namespace

void tile_point(const Tile& tile, const int64_t* pixel, const uint32_t* fraction, float level, uint32_t first,
                uint32_t count, float* f)
{
    const weft_between between = tile.level(level);
    const weft_place places[2] = {tile.place(0, pixel[0], fraction[0]), tile.place(1, pixel[1], fraction[1])};
    for (uint32_t p = 0; p < count; ++p) {
        f[p] = tile_level(tile, places, between.whole, first + p);
        if (between.t > 0) f[p] = weft_lerp(f[p], tile_level(tile, places, between.whole + 1, first + p), between.t);
    }
}

bool Tile_block::Level::begin(const Tile& tile, const Block& block, int32_t which)
{
    whole = which;
    stride = (block.width + 15) & ~uint32_t(15);
    size = tile.tile->source->level[which].width;
    if (!indices.reserve(2 * size_t(stride)) || !t.reserve(stride) || !runs.reserve(stride) ||
        !expanded.reserve(2 * size_t(stride)))
        return false;
    const uint32_t fraction = block.level == 0 ? WEFT_FRACTION_HALF : 0;
    const int64_t step = int64_t(1) << block.level;
    int64_t pixel = block.x * step + step / 2;
    for (uint32_t x = 0; x < block.width; ++x, pixel += step) {
        const weft_pair pair = tile.pair(0, tile.place(0, pixel, fraction), which);
        indices.data()[x] = pair.first;
        indices.data()[stride + x] = pair.second;
        t.data()[x] = pair.t;
    }
    find_runs(block.width);
    return true;
}

void Tile_block::Level::find_runs(uint32_t width)
{
    const int32_t* first = indices.data();
    uint32_t count = 0;
    for (uint32_t begin = 0; begin < width;) {
        uint32_t end = begin + 1;
        if (first[begin] + 1 < int32_t(size))
            while (end < width && first[end] == first[end - 1] + 1 && first[end] + 1 < int32_t(size)) ++end;
        const uint32_t scattered = end - begin < shortest_run ? 1 : 0;
        Run& last = runs.data()[count > 0 ? count - 1 : 0];
        if (count > 0 && scattered != 0 && last.scattered != 0)
            last.end = end;
        else
            runs.data()[count++] = {begin, end, first[begin], scattered};
        begin = end;
    }
    columns = {first, first + stride, t.data(), runs.data(), count};
}

const float* Tile_block::Level::row(const Rows& rows, const float* plane, int32_t y, int32_t other)
{
    for (uint32_t i = 0; i < 2; ++i)
        if (held[i] == y) return expanded.data() + i * stride;
    const uint32_t i = held[0] == other ? 1 : 0;
    rows.expand(plane + size_t(y) * size, columns, expanded.data() + i * stride);
    held[i] = y;
    return expanded.data() + i * stride;
}

bool Tile_block::begin(const Rows& rows, const Tile& tile, const Block& block)
{
    rows_ = &rows;
    tile_ = &tile;
    block_ = block;
    const weft_between between = tile.level(float(block.level));
    between_ = between.t;
    if (!chain_[0].begin(tile, block, between.whole)) return false;
    return !(between_ > 0) || (chain_[1].begin(tile, block, between.whole + 1) && blend_.reserve(chain_[0].stride));
}

void Tile_block::plane(Level& level, uint32_t plane, uint32_t y, float* out)
{
    const weft_mip& mip = tile_->tile->source->level[level.whole];
    const int64_t step = int64_t(1) << block_.level;
    const weft_place place =
        tile_->place(1, (block_.y + y) * step + step / 2, block_.level == 0 ? WEFT_FRACTION_HALF : 0);
    const weft_pair pair = tile_->pair(1, place, level.whole);
    const float* data = mip.data + size_t(plane) * mip.width * mip.height;
    const float* upper = level.row(*rows_, data, pair.first, pair.second);
    const float* lower = level.row(*rows_, data, pair.second, pair.first);
    rows_->lerp(upper, lower, pair.t, block_.width, out);
}

void Tile_block::strip(const Strip& strip)
{
    for (uint32_t p = 0; p < tile_->planes; ++p) {
        for (Level& level : chain_) level.held[0] = level.held[1] = -1;
        for (uint32_t y = 0; y < strip.count; ++y) {
            float* out = strip.data + (size_t(p) * strip.count + y) * strip.stride;
            plane(chain_[0], p, strip.first + y, out);
            if (!(between_ > 0)) continue;
            plane(chain_[1], p, strip.first + y, blend_.data());
            rows_->lerp(out, blend_.data(), between_, block_.width, out);
        }
    }
}

} // namespace weft
