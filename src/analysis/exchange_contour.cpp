/// Differences gathered by direction and depth; then, for each depth of the first direction, dynamic programming once
/// around (the exact cyclic minimum).
#include "analysis/exchange_contour.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace weft {
namespace {

constexpr std::int32_t rings = 14, first_ring = 2; ///< a texel deep each; below, the feather would be cut off
constexpr std::int32_t steepest = 2;               ///< change of depth between neighbouring directions
constexpr float never = std::numeric_limits<float>::max() / 4;
static_assert(rings * 8 == zone_depth);

/// Which of the depths around an anchor is nearest to a direction, on the square from (1, -1) by (1, 1).
std::uint32_t direction_of(float x, float y) noexcept
{
    const float ax = std::abs(x), ay = std::abs(y);
    const bool across = ay <= ax;
    const float side = across ? (x >= 0 ? 0.0f : 2.0f) : (y >= 0 ? 1.0f : 3.0f);
    const float along = across ? (x >= 0 ? y : -y) : (y >= 0 ? -x : x);
    const float most = std::max(std::max(ax, ay), 0x1p-24f), quarter = contour_knots / 4;
    const float place = side * quarter + (along / most + 1) * (quarter / 2);
    return static_cast<std::uint32_t>(place + 0.5f) % contour_knots;
}

/// Sums of differences, and of texels.
struct Cells {
    float sum[contour_knots][rings] = {}, count[contour_knots][rings] = {};

    void gather(const Search_pictures& pictures, const Patch_shape& shape, const Found& found) noexcept
    {
        const Turning turning(found.turn, offered_scale[found.scale]);
        const Features& features = pictures.scaled[found.scale];
        for (const auto& texel : shape.texels) {
            const std::int32_t ring = texel.depth / 8;
            if (ring >= rings) continue;
            const auto x = found.x + static_cast<std::int32_t>(std::floor(turning.x(texel.dx, texel.dy))),
                       y = found.y + static_cast<std::int32_t>(std::floor(turning.y(texel.dx, texel.dy)));
            const std::uint32_t k = direction_of(texel.dx, texel.dy);
            sum[k][ring] +=
                distance(features.at(static_cast<std::size_t>(x), static_cast<std::size_t>(y)), texel.feature);
            count[k][ring] += 1;
        }
    }
    /// Both pictures are seen in the feather: each ring counts half, its neighbours a quarter.
    float error(std::uint32_t k, std::int32_t ring) const noexcept
    {
        const std::int32_t before = ring - 1, after = std::min(ring + 1, rings - 1);
        const float many = count[k][before] + 2 * count[k][ring] + count[k][after];
        return many > 0 ? (sum[k][before] + 2 * sum[k][ring] + sum[k][after]) / many : mean;
    }
    float mean = 0; ///< where there are no texels
};

struct Costs {
    float across[contour_knots][rings]; ///< of passing a direction at a depth
    float error[contour_knots][rings];  ///< per texel

    explicit Costs(Cells& cells) noexcept
    {
        float sum = 0, count = 0;
        for (std::uint32_t k = 0; k < contour_knots; ++k)
            for (std::int32_t ring = 0; ring < rings; ++ring) {
                sum += cells.sum[k][ring];
                count += cells.count[k][ring];
            }
        cells.mean = count > 0 ? sum / count : 0;
        for (std::uint32_t k = 0; k < contour_knots; ++k)
            for (std::int32_t ring = first_ring; ring < rings; ++ring) {
                error[k][ring] = cells.error(k, ring);
                across[k][ring] = error[k][ring] * cells.count[k][ring];
            }
    }
    float step(std::uint32_t k, std::int32_t from, std::int32_t to) const noexcept
    {
        return static_cast<float>(std::abs(to - from)) * 0.5f * (error[k][from] + error[k][to]);
    }
};

struct Closed_path {
    float cost = never;
    std::uint8_t ring[contour_knots] = {};
};

Closed_path path_from(const Costs& costs, std::int32_t start) noexcept
{
    float cost[2][rings];
    std::uint8_t from[contour_knots + 1][rings] = {};
    std::fill_n(cost[0], rings, never);
    cost[0][start] = 0;
    for (std::uint32_t k = 1; k <= contour_knots; ++k) {
        const std::uint32_t here = k % contour_knots;
        const float* last = cost[(k - 1) % 2];
        float* next = cost[k % 2];
        for (std::int32_t ring = first_ring; ring < rings; ++ring) {
            next[ring] = never;
            for (std::int32_t r = std::max(first_ring, ring - steepest); r <= std::min(rings - 1, ring + steepest);
                 ++r) {
                const float sum = last[r] + costs.step(here, r, ring) + costs.across[here][ring];
                if (sum >= next[ring]) continue;
                next[ring] = sum;
                from[k][ring] = static_cast<std::uint8_t>(r);
            }
        }
    }
    Closed_path path;
    path.cost = cost[contour_knots % 2][start];
    auto ring = static_cast<std::uint8_t>(start);
    for (std::uint32_t k = contour_knots; k > 0; --k) {
        path.ring[k % contour_knots] = ring;
        ring = from[k][ring];
    }
    return path;
}

} // namespace

Content_contour contour_of(const Search_pictures& pictures, const Patch_shape& shape, const Found& found) noexcept
{
    Cells cells;
    cells.gather(pictures, shape, found);
    const Costs costs(cells);
    Closed_path best;
    for (std::int32_t start = first_ring; start < rings; ++start) {
        const Closed_path path = path_from(costs, start);
        if (path.cost < best.cost) best = path;
    }
    Content_contour contour{};
    float length = 0;
    for (std::uint32_t k = 0; k < contour_knots; ++k) {
        const std::int32_t ring = best.ring[k], last = best.ring[(k + contour_knots - 1) % contour_knots];
        contour.depths[k] = static_cast<std::uint8_t>(8 * ring + 4);
        length += cells.count[k][ring] + static_cast<float>(std::abs(ring - last));
    }
    contour.error = length > 0 ? best.cost / length : never;
    return contour;
}

} // namespace weft
