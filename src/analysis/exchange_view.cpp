/// A diamond lies where the position is beyond the contours with all colours of the other edge.
#include "analysis/exchange_view.h"
#include <algorithm>

namespace weft {
namespace {

constexpr float half_feather = 2.5f; ///< in texels of (x - y) / 2

/// For each knot the contour that leaves least of a diamond: of north edges the deepest, of west edges the shallowest.
void narrowest(const Wang& wang, std::uint32_t quarter, std::uint32_t edge, float* depths)
{
    const std::uint32_t n = wang.colours;
    const bool west = edge >= n;
    for (std::uint32_t knot = 0; knot <= wang.knots; ++knot)
        for (std::uint32_t other = 0; other < n; ++other) {
            const std::uint32_t row = (quarter * n + (west ? other : edge)) * n + (west ? edge - n : other);
            const float depth = wang.contours[std::size_t{row} * (wang.knots + 1) + knot];
            if (other == 0 || (west ? depth < depths[knot] : depth > depths[knot])) depths[knot] = depth;
        }
}

} // namespace

View torus_view(std::pmr::memory_resource* memory, const Features& features)
{
    View view{features.width, features.height, 0, 0, true, Array<std::uint8_t>(memory, features.pixels.size())};
    std::fill(view.domain.begin(), view.domain.end(), std::uint8_t{1});
    return view;
}

View diamond_view(std::pmr::memory_resource* memory, const Wang& wang, std::uint32_t edge)
{
    const bool west = edge >= wang.colours;
    View view{wang.width,
              wang.height,
              wang.diamonds[edge].x,
              wang.diamonds[edge].y,
              false,
              Array<std::uint8_t>(memory, std::size_t{wang.width} * wang.height)};
    const float unit_x = static_cast<float>(wang.knots) / static_cast<float>(wang.width),
                unit_y = static_cast<float>(wang.knots) / static_cast<float>(wang.height);
    const float margin = half_feather * (unit_x + unit_y);
    Array<float> depths(memory, wang.knots + 1);
    for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
        narrowest(wang, quarter, edge, depths.data());
        for (std::uint32_t j = 0; j < wang.height / 2; ++j)
            for (std::uint32_t i = 0; i < wang.width / 2; ++i) { // texels from the corner of the cell
                const float u = (static_cast<float>(i) + 0.5f) * unit_x, v = (static_cast<float>(j) + 0.5f) * unit_y;
                const auto knot = std::min(static_cast<std::uint32_t>(u + v), wang.knots - 1);
                const float t = u + v - static_cast<float>(knot);
                const float beyond = u - v - (depths[knot] + t * (depths[knot + 1] - depths[knot]));
                const std::uint32_t x = quarter % 2 != 0 ? wang.width - 1 - i : i,
                                    y = quarter / 2 != 0 ? wang.height - 1 - j : j; // in the cell
                const std::uint32_t view_x = west ? (x + wang.width / 2) % wang.width : x,
                                    view_y = west ? y : (y + wang.height / 2) % wang.height;
                view.domain[std::size_t{view_y} * wang.width + view_x] = (west ? -beyond : beyond) >= margin;
            }
    }
    return view;
}

} // namespace weft
