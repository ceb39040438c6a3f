/// Singular values of the Jacobian, probes along the major axis (Galerne et al. 2017, section 5), a level for each.
#include "synthesis/footprint.h"
#include "base/elementary.h"
#include <algorithm>
#include <cmath>

namespace weft {

namespace {

constexpr double most_scale = 1073741824.0; // 2^30, the last level

struct Axes {
    double longer, shorter; ///< singular values of the Jacobian
    double x, y;            ///< unit vector along the longer axis
};

/// In double the squares of squares of floats do not overflow.
Axes axes_of(const weft_point& point) noexcept
{
    const double x0 = static_cast<double>(point.dx[0]), x1 = static_cast<double>(point.dx[1]);
    const double y0 = static_cast<double>(point.dy[0]), y1 = static_cast<double>(point.dy[1]);
    const double a = x0 * x0 + x1 * x1, b = x0 * y0 + x1 * y1, c = y0 * y0 + y1 * y1;
    const double half = (a + c) * 0.5, difference = (a - c) * 0.5, root = std::sqrt(difference * difference + b * b);
    const double longer = std::sqrt(half + root);
    if (!(longer > 0)) return {0, 0, 1, 0};
    // The eigenvector of [a b; b c], from the row that cancels less.
    const double u = difference >= 0 ? difference + root : b, v = difference >= 0 ? b : root - difference;
    const double length = std::sqrt(u * u + v * v);
    if (!(length > 0)) return {longer, longer, 1, 0};
    return {longer, std::abs(x0 * y1 - x1 * y0) / longer, u / length, v / length};
}

void place(double position, std::int64_t& cell, std::uint32_t& fraction) noexcept
{
    cell = static_cast<std::int64_t>(position);
    if (position < static_cast<double>(cell)) --cell;
    fraction = std::min(static_cast<std::uint32_t>((position - static_cast<double>(cell)) * 16777216.0), 16777215U);
}

weft_spot spot_at(double x, double y, float level) noexcept
{
    weft_spot spot{};
    place(x, spot.cell[0], spot.fraction[0]);
    place(y, spot.cell[1], spot.fraction[1]);
    spot.level = level;
    return spot;
}

} // namespace

bool is_good(const weft_point& point) noexcept
{
    return std::abs(point.x) < most_coordinate && std::abs(point.y) < most_coordinate && std::isfinite(point.dx[0]) &&
           std::isfinite(point.dx[1]) && std::isfinite(point.dy[0]) && std::isfinite(point.dy[1]);
}

weft_spot spot_in_space(const double* position, float level) noexcept
{
    weft_spot spot{};
    for (int axis = 0; axis < 3; ++axis) place(position[axis], spot.cell[axis], spot.fraction[axis]);
    spot.level = level;
    return spot;
}

float level_of(float width) noexcept
{
    return width > 1 ? static_cast<float>(log2_of(std::min(static_cast<double>(width), most_scale))) : 0.0F;
}

std::uint32_t make_spots(const weft_point& point, weft_spot* spots) noexcept
{
    const Axes axes = axes_of(point);
    if (axes.longer <= 1) {
        spots[0] = spot_at(point.x, point.y, 0);
        return 1;
    }
    const double probes = std::min<double>(most_probes, std::ceil(axes.longer / std::max(axes.shorter, 1.0)));
    const double scale = std::min(std::max({1.0, axes.shorter, axes.longer / probes}), most_scale);
    const auto level = static_cast<float>(log2_of(scale));
    const double step = std::min(axes.longer / probes, most_scale);
    for (int i = 0; i < static_cast<int>(probes); ++i) {
        const double along = (i - (probes - 1) * 0.5) * step;
        spots[i] = spot_at(point.x + along * axes.x, point.y + along * axes.y, level);
    }
    return static_cast<std::uint32_t>(probes);
}

} // namespace weft
