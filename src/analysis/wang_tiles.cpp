/// Sizes, selection, and the contours of all pairs at full resolution.
#include "analysis/wang_tiles.h"
#include "analysis/compare_pair.h"
#include "analysis/wang_cut.h"
#include "analysis/wang_selection.h"
#include <algorithm>

namespace weft {
namespace {

constexpr std::uint32_t most_knots_of_contour = 254;
constexpr float least_likeness = 0.05f; ///< that is worth another size

/// Of a cell. Of less than half the structure diamonds have room to differ; of sizes near that, one by which the
/// structure resembles itself most keeps courses and columns whole.
std::uint32_t side_of(const Correlation& correlation, std::uint32_t size, bool down) noexcept
{
    const auto even = [size](std::uint32_t share) { return std::max(4U, (size * share / 64) & ~1U); };
    std::uint32_t best = even(27);
    float most = least_likeness;
    for (std::uint32_t side = even(22); side <= even(32); side += 2) {
        const auto lag = static_cast<std::int32_t>(side);
        const float likeness = down ? correlation.at(0, lag) : correlation.at(lag, 0);
        if (likeness <= most) continue;
        most = likeness;
        best = side;
    }
    return best;
}

} // namespace

Wang wang_tiles_of(Core& core, const Features& features, const Correlation& correlation, std::uint32_t colours,
                   std::uint64_t seed, const Progress& progress)
{
    Wang wang;
    wang.colours = colours;
    wang.width = side_of(correlation, features.width, false);
    wang.height = side_of(correlation, features.height, true);
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
