/// Grids: integers that say how often a picture lies on a span of pixels.
#include "synthesis/grid.h"
#include "base/elementary.h"
#include <algorithm>

namespace weft {

namespace {

weft_grid grid_of(std::uint32_t size, std::uint32_t scale, std::uint32_t period) noexcept
{
    const std::uint32_t natural = size * scale; // at most 2^14 * 2^16
    const std::uint32_t cells = period == 0 ? 1 : std::max(1U, (period + natural / 2) / natural),
                        span = period == 0 ? natural : period;
    const std::uint64_t texels = std::uint64_t{cells} * size;
    auto step = static_cast<float>(static_cast<double>(texels) / span);
    if (step == 1.0F && texels != span) step = 0x1.000002p0F; // 1 says that they are equal
    return {span, cells, 1.0F / static_cast<float>(span), step};
}

} // namespace

weft_tile repeated_tile(const weft_mips& picture, std::uint32_t width, std::uint32_t height, std::uint32_t scale,
                        std::uint32_t period_x, std::uint32_t period_y) noexcept
{
    weft_tile tile{};
    tile.size = sizeof tile;
    tile.address = WEFT_ADDRESS_CELLS;
    tile.width = width;
    tile.height = height;
    tile.x = grid_of(width, scale, period_x);
    tile.y = grid_of(height, scale, period_y);
    tile.displacement = nobody;
    tile.level = static_cast<float>(log2_of(static_cast<double>(std::max(tile.x.step, tile.y.step))));
    tile.source = &picture;
    return tile;
}

} // namespace weft
