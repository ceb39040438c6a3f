/// Sizes, selection, and the contours of all pairs at full resolution.
#include "analysis/wang_tiles.h"
#include "analysis/compare_pair.h"
#include "analysis/wang_cut.h"
#include "analysis/wang_selection.h"
#include <algorithm>

namespace weft {
namespace {

constexpr std::uint32_t most_knots_of_contour = 254;

/// Of a cell: of less than half the structure diamonds have more room, and less in common.
std::uint32_t side_of(std::uint32_t size) noexcept { return std::max(4U, (size * 27 / 64) & ~1U); }

} // namespace

Wang wang_tiles_of(Core& core, const Features& features, std::uint32_t colours, std::uint64_t seed,
                   const Progress& progress)
{
    Wang wang;
    wang.colours = colours;
    wang.width = side_of(features.width);
    wang.height = side_of(features.height);
    wang.knots = std::clamp(std::max(wang.width, wang.height) / 2, 2u, most_knots_of_contour);
    wang.diamonds = Array<Wang::Diamond>(&core.memory, 2 * std::size_t{colours});
    select_diamonds(core, features, seed, wang, progress.part(0, 0.8));
    const std::uint32_t cuts = 4 * colours * colours;
    wang.contours = Array<std::int8_t>(&core.memory, std::size_t{cuts} * (wang.knots + 1));
    for_each_step(core, cuts, 20.0 * wang.knots * wang.knots, progress.part(0.8, 1), [&](std::uint32_t i) {
        const std::uint32_t quarter = i / (colours * colours), north = i / colours % colours, west = i % colours;
        cut_quarter(&core.memory, features, {wang.width, wang.height, wang.knots, quarter / 2, quarter % 2},
                    wang.diamonds[north], wang.diamonds[colours + west],
                    wang.contours.data() + std::size_t{i} * (wang.knots + 1));
    });
    return wang;
}

} // namespace weft
