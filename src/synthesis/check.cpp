/// Programs are checked here once, so that no backend need.
#include "synthesis/check.h"
#include "base/error.h"
#include "base/finite.h"
#include <cmath>

namespace weft {

namespace {

template <class... Parts> void demand(bool good, const Parts&... parts)
{
    if (!good) throw Error(WEFT_ERROR_INTERNAL, "a program was made with ", parts...);
}

bool within(std::uint32_t value, std::uint32_t low, std::uint32_t high) noexcept
{
    return value >= low && value <= high;
}

bool all_finite(const float* values, std::size_t count) noexcept { return all_below(values, count, infinity_bits); }

void check_mips(const weft_mips& mips, const weft_layer& layer, bool tile)
{
    demand(within(mips.width, 1, 16384) && within(mips.height, 1, 16384), "a picture of ", mips.width, " x ",
           mips.height);
    demand(mips.planes == layer.planes && within(mips.images, 1, tile ? 1 : 255), mips.planes, " planes and ",
           mips.images, " images");
    demand(within(mips.levels, 1, 15), mips.levels, " levels");
    for (std::uint32_t l = 0; l < mips.levels; ++l) {
        const weft_mip& level = mips.level[l];
        demand(level.data && within(level.width, 1, mips.width + 8) && within(level.height, 1, mips.height + 8),
               "an empty level ", l);
        demand(l > 0 || tile || (level.width >= mips.width && level.height >= mips.height), "a small level 0");
        demand(level.x >= -4 && level.x <= 4 && level.y >= -4 && level.y <= 4 &&
                   (!tile || (level.x == 0 && level.y == 0)),
               "a shifted level");
        demand(!tile || (level.scale_x > 0 && level.scale_y > 0 && level.scale_x <= 1 && level.scale_y <= 1),
               "a level of no scale");
        demand(all_finite(level.data, std::size_t{level.width} * level.height * mips.planes * mips.images),
               "a texel that is not finite");
    }
}

void check_splat(const weft_splat& splat, const weft_layer& layer)
{
    demand(splat.taps == 1 || splat.taps == 2 || splat.taps == 4 || splat.taps == 6, splat.taps, " taps");
    demand(splat.cell_log2 <= 15, "cells of 2^", splat.cell_log2);
    demand(within(splat.count_limit, 1, 255) && splat.counts, splat.count_limit, " counts");
    for (std::uint32_t i = 1; i < splat.count_limit; ++i)
        demand(splat.counts[i - 1] <= splat.counts[i], "counts that descend");
    demand(splat.signs <= 1 && splat.choice.layer == -1 && splat.textons && splat.offset, "an incomplete SPLAT");
    demand(all_finite(splat.offset, layer.planes), "an offset that is not finite");
    for (std::uint32_t p = 0; p < layer.planes; ++p)
        demand(splat.offset[p] != 0 || !std::signbit(splat.offset[p]), "an offset of -0");
    check_mips(*splat.textons, layer, false);
}

void check_grid(const weft_grid& grid, std::uint32_t size, std::uint32_t period)
{
    demand(grid.span >= 1 && grid.cells >= 1 && (period == 0 ? grid.cells == 1 : grid.span == period), "a grid of ",
           grid.cells, " cells on ", grid.span, " pixels");
    demand(std::isfinite(grid.inverse) && grid.step > 0 && grid.step < static_cast<float>(size) + 1.0F,
           "a grid of step ", grid.step);
    demand((std::uint64_t{grid.cells} * size == grid.span) == (grid.step == 1.0F), "a stretched grid of step 1");
}

void check_tile(const weft_tile& tile, const weft_layer& layer, const weft_program& program)
{
    demand(tile.address == WEFT_ADDRESS_CELLS && !tile.wang && !tile.exchange,
           "an address that this libweft does not make");
    demand(tile.source && tile.displacement.layer == -1 && std::isfinite(tile.level), "an incomplete TILE");
    demand(tile.width == tile.source->width && tile.height == tile.source->height, "cells of ", tile.width, " x ",
           tile.height);
    check_grid(tile.x, tile.width, program.period[0]);
    check_grid(tile.y, tile.height, program.period[1]);
    check_mips(*tile.source, layer, true);
}

void check_layer(const weft_layer& layer, const weft_program& program)
{
    demand(within(layer.planes, 1, 40) && layer.channels <= layer.planes && layer.channels <= 16, layer.planes,
           " planes, ", layer.channels, " of them coloured");
    demand(layer.mask.layer == -1 && !layer.tones && !layer.bands, "a part that this libweft does not make");
    demand(layer.colour && layer.mean && all_finite(layer.colour, std::size_t{program.channels} * layer.channels) &&
               all_finite(layer.mean, program.channels),
           "a colour that is not finite");
    demand((layer.kind == WEFT_LAYER_SPLAT) == (layer.splat != nullptr) &&
               (layer.kind == WEFT_LAYER_TILE) == (layer.tile != nullptr) && (layer.splat || layer.tile),
           "a layer of kind ", layer.kind);
    if (layer.splat) check_splat(*layer.splat, layer);
    if (layer.tile) check_tile(*layer.tile, layer, program);
}

} // namespace

void check_program(const weft_program& program)
{
    demand(program.use == WEFT_USE_WINDOW || program.use == WEFT_USE_POINTS, "use ", program.use);
    demand(within(program.channels, 1, 16), program.channels, " channels");
    demand(within(program.layer_count, 1, 32) && program.layers, program.layer_count, " layers");
    for (const std::uint32_t period : program.period) demand(period <= 1U << 24, "a period of ", period);
    for (std::uint32_t i = 0; i < program.layer_count; ++i) check_layer(*program.layers[i], program);
}

} // namespace weft
