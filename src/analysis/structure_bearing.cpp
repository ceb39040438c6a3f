/// Lattices have a high peak of autocorrelation away from 0; what may be turned has gradients of like directions before
/// and after, light and shade apart.
#include "analysis/structure_bearing.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr float lattice_peak = 0.5f;
constexpr std::uint32_t directions = 64, octant = directions / 8;

struct Histogram {
    double share[directions] = {};
};

/// Sixty-fourths of a turn; the arc tangent is right to 0.004.
double direction_of(double x, double y) noexcept
{
    const double ax = std::abs(x), ay = std::abs(y), ratio = std::min(ax, ay) / std::max(ax, ay);
    double eighths = ratio * (1 + 0.273 / 0.7853982 * (1 - ratio));
    if (ay > ax) eighths = 2 - eighths;
    if (x < 0) eighths = 4 - eighths;
    if (y < 0) eighths = 8 - eighths;
    return eighths * octant;
}

/// Of the gradients in a part of the picture, smoothed over five directions.
Histogram histogram_of(const Features& features, std::uint32_t left, std::uint32_t top, std::uint32_t right,
                       std::uint32_t bottom)
{
    Histogram raw, smooth;
    double all = 0;
    for (std::size_t y = top + 1; y + 1 < bottom; ++y)
        for (std::size_t x = left + 1; x + 1 < right; ++x)
            for (int c = 0; c < 4; ++c) {
                const auto dx = static_cast<double>(features.at(x + 1, y).value[c] - features.at(x - 1, y).value[c]),
                           dy = static_cast<double>(features.at(x, y + 1).value[c] - features.at(x, y - 1).value[c]);
                const double square = dx * dx + dy * dy;
                if (square <= 0) continue;
                raw.share[static_cast<std::uint32_t>(direction_of(dx, dy)) % directions] += square;
                all += square;
            }
    for (std::uint32_t i = 0; i < directions && all > 0; ++i)
        for (std::uint32_t k = 0; k < 5; ++k)
            smooth.share[i] += raw.share[(i + k + directions - 2) % directions] / (5 * all);
    return smooth;
}

/// Half the sum of differences between one histogram and the other turned: 0 alike, 1 nothing in common.
double difference_of(const Histogram& a, const Histogram& b, std::uint32_t eighths) noexcept
{
    double sum = 0;
    for (std::uint32_t i = 0; i < directions; ++i)
        sum += 0.5 * std::abs(a.share[i] - b.share[(i + eighths * octant) % directions]);
    return sum;
}

std::uint32_t turns_of(Core& core, const Features& features)
{
    Features smooth = blurred(core, features, 0.5f); // four times: a deviation of 1.4 pixels
    for (int i = 0; i < 3; ++i) smooth = blurred(core, smooth, 0.5f);
    const std::uint32_t w = features.width, h = features.height;
    const Histogram whole = histogram_of(smooth, 0, 0, w, h);
    double between = 0; // how much four parts of it differ by themselves
    for (std::uint32_t k = 0; k < 4; ++k) {
        const std::uint32_t left = k % 2 * (w / 2), top = k / 2 * (h / 2);
        between += difference_of(whole, histogram_of(smooth, left, top, left + w / 2, top + h / 2), 0) / 4;
    }
    std::uint32_t turns = 1;
    for (std::uint32_t turn = 1; turn <= 4; ++turn)
        if (difference_of(whole, whole, turn) <= std::max(0.1, 1.5 * between)) turns |= 1U << turn;
    constexpr std::uint32_t oblique = 0b01110; // what does not bear all of these has directions
    return (turns & oblique) == oblique ? turns : turns & ~oblique;
}

} // namespace

Bearing bearing_of(Core& core, const Features& features, const Correlation& correlation)
{
    Bearing bearing;
    bearing.lattice = correlation.far_peak() > lattice_peak;
    if (bearing.lattice) return bearing;
    bearing.turns = turns_of(core, features);
    const bool isotropic = (bearing.turns & 2) != 0;
    bearing.scales = isotropic ? 3 : 2;
    bearing.turbulence = isotropic ? 5 : 3;
    return bearing;
}

} // namespace weft
