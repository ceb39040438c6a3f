/// Checks of TILE layers, and of the pictures and references that they share with others.
#include "synthesis/check_parts.h"
#include <cmath>

namespace weft {

namespace {

void check_grid(const weft_grid& grid, std::uint32_t size, std::uint32_t period)
{
    demand(grid.span >= 1 && grid.cells >= 1 && (period == 0 ? grid.cells == 1 : grid.span == period), "a grid of ",
           grid.cells, " cells on ", grid.span, " pixels");
    demand(std::isfinite(grid.inverse) && grid.step > 0 && grid.step < static_cast<float>(size) + 1.0F,
           "a grid of step ", grid.step);
    demand((std::uint64_t{grid.cells} * size == grid.span) == (grid.step == 1.0F), "a stretched grid of step 1");
}

void check_wang(const weft_wang& wang, const weft_tile& tile)
{
    const weft_mips& source = *tile.source;
    demand(within(wang.colours, 2, 16) && within(wang.knots, 2, 254), wang.colours, " colours and ", wang.knots,
           " knots");
    demand(tile.width % 2 == 0 && within(tile.width, 4, source.width) && tile.height % 2 == 0 &&
               within(tile.height, 4, source.height),
           "Wang tiles of ", tile.width, " x ", tile.height);
    demand(wang.unit_x == static_cast<float>(wang.knots) / static_cast<float>(tile.width) &&
               wang.unit_y == static_cast<float>(wang.knots) / static_cast<float>(tile.height),
           "units of ", wang.unit_x, " and ", wang.unit_y);
    demand(wang.diamonds && wang.contours && wang.sharp, "incomplete Wang tiles");
    for (std::uint32_t i = 0; i < 2 * wang.colours; ++i)
        demand(wang.diamonds[i].x >= 0 && static_cast<std::uint32_t>(wang.diamonds[i].x) < source.width &&
                   wang.diamonds[i].y >= 0 && static_cast<std::uint32_t>(wang.diamonds[i].y) < source.height,
               "a diamond outside its source");
    for (std::size_t row = 0; row < std::size_t{4} * wang.colours * wang.colours; ++row)
        for (std::uint32_t k = 0; k <= wang.knots; ++k) {
            const int depth = wang.contours[row * (wang.knots + 1) + k];
            const auto end = static_cast<int>(k < wang.knots - k ? k : wang.knots - k);
            demand(depth <= end && depth >= -end, "a contour ", depth, " deep at knot ", k);
        }
    for (std::size_t i = 0; i < std::size_t{source.levels} * (wang.knots + 1); ++i)
        demand(wang.sharp[i] > 0 && wang.sharp[i] <= 16, "a feather of sharpness ", wang.sharp[i]);
}

void check_content(const weft_content& content, const weft_mips& source)
{
    demand(content.x >= 0 && static_cast<std::uint32_t>(content.x) < source.width && content.y >= 0 &&
               static_cast<std::uint32_t>(content.y) < source.height,
           "a content outside its source");
    for (const float number : content.turn) demand(number >= -2 && number <= 2, "a content turned by ", number);
    demand(content.level >= 0 && content.level <= 1, "a content of level ", content.level);
}

void check_exchange(const weft_exchange& exchange, const weft_tile& tile)
{
    demand(within(exchange.patch_count, 1, WEFT_MAP_PATCH) && exchange.map && exchange.patches && exchange.contents &&
               exchange.contours && exchange.feather,
           exchange.patch_count, " patches");
    const std::size_t views = tile.wang ? 2 * std::size_t{tile.wang->colours} : 1;
    for (std::size_t i = 0; i < views * tile.width * tile.height; ++i) {
        const std::uint32_t entry = exchange.map[i];
        demand((entry & WEFT_MAP_PATCH) < exchange.patch_count, "a map with patch ", entry & WEFT_MAP_PATCH);
        demand((entry >> WEFT_MAP_DEPTH & 255) <= 191, "a map ", entry >> WEFT_MAP_DEPTH & 255, " deep");
        demand(!tile.wang || (entry & (WEFT_MAP_LEFT | WEFT_MAP_ABOVE)) == 0, "a diamond's patch in another cell");
    }
    std::uint32_t next = 0;
    for (std::uint32_t p = 0; p < exchange.patch_count; ++p) {
        const weft_patch& patch = exchange.patches[p];
        demand(patch.x > -(1 << 16) && patch.x < 1 << 16 && patch.y > -(1 << 16) && patch.y < 1 << 16, "an anchor at ",
               patch.x, ", ", patch.y);
        demand(patch.first == next && within(patch.count, 1, 64), "a patch of ", patch.count, " contents");
        next += patch.count;
        for (std::uint32_t i = 0; i < patch.count; ++i) {
            demand(i == 0 || exchange.contents[patch.first + i - 1].until <= exchange.contents[patch.first + i].until,
                   "shares that descend");
            check_content(exchange.contents[patch.first + i], *tile.source);
        }
    }
    for (std::uint32_t l = 0; l < tile.source->levels; ++l)
        demand(exchange.feather[l] > 0 && exchange.feather[l] <= 1, "a feather of ", exchange.feather[l]);
}

} // namespace

void check_ref(const weft_ref& ref, const weft_program& program, std::uint32_t index, const char* what)
{
    if (ref.layer == -1) return;
    demand(ref.layer >= 0 && static_cast<std::uint32_t>(ref.layer) < index, what, " by layer ", ref.layer);
    demand(ref.plane < program.layers[ref.layer]->planes, what, " by plane ", ref.plane);
}

void check_mips(const weft_mips& mips, std::uint32_t planes, bool tile)
{
    demand(within(mips.width, 1, 16384) && within(mips.height, 1, 16384), "a picture of ", mips.width, " x ",
           mips.height);
    demand(mips.planes == planes && within(mips.images, 1, tile ? 1 : 255), mips.planes, " planes and ", mips.images,
           " images");
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

void check_tile(const weft_tile& tile, const weft_program& program, std::uint32_t index)
{
    demand(tile.source && std::isfinite(tile.level), "an incomplete TILE");
    demand((tile.address == WEFT_ADDRESS_WANG) == (tile.wang != nullptr) && tile.address >= WEFT_ADDRESS_CELLS &&
               tile.address <= WEFT_ADDRESS_WANG,
           "address ", tile.address);
    demand(tile.wang || (tile.width == tile.source->width && tile.height == tile.source->height), "cells of ",
           tile.width, " x ", tile.height);
    weft_ref second = tile.displacement;
    second.plane += 1;
    check_ref(tile.displacement, program, index, "a displacement");
    check_ref(second, program, index, "a displacement");
    check_grid(tile.x, tile.width, program.period[0]);
    check_grid(tile.y, tile.height, program.period[1]);
    check_mips(*tile.source, program.layers[index]->planes, true);
    if (tile.wang) check_wang(*tile.wang, tile);
    if (tile.exchange) check_exchange(*tile.exchange, tile);
}

} // namespace weft
