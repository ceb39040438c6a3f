/// Lattices have a high peak of autocorrelation away from 0; what may be turned has gradients of like directions before
/// and after, light and shade apart.
#include "analysis/structure_bearing.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr float lattice_peak = 0.5f;
constexpr double like = 0.1, unlike = 0.2; ///< of histograms
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

/// Of the gradients in a part of the picture.
Histogram histogram_of(const Features& features, std::uint32_t left, std::uint32_t top, std::uint32_t right,
                       std::uint32_t bottom)
{
    Histogram histogram;
    for (std::size_t y = top + 1; y + 1 < bottom; ++y)
        for (std::size_t x = left + 1; x + 1 < right; ++x)
            for (int c = 0; c < 4; ++c) {
                const auto dx = static_cast<double>(features.at(x + 1, y).value[c] - features.at(x - 1, y).value[c]),
                           dy = static_cast<double>(features.at(x, y + 1).value[c] - features.at(x, y - 1).value[c]);
                const double square = dx * dx + dy * dy;
                if (square > 0)
                    histogram.share[static_cast<std::uint32_t>(direction_of(dx, dy)) % directions] += square;
            }
    return histogram;
}

/// Over five directions, its sum 1.
Histogram smoothed(const Histogram& raw) noexcept
{
    Histogram smooth;
    double all = 0;
    for (const double share : raw.share) all += share;
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

struct Turns {
    std::uint32_t borne = 1;
    bool right_angles = false; ///< courses and columns: like themselves after a quarter of a turn, not after an eighth
};

Turns turns_of(Core& core, const Features& features, const Progress& progress)
{
    Features smooth = blurred(core, features, 0.5f); // four times: a deviation of 1.4 pixels
    for (int i = 0; i < 3; ++i) {
        progress.at((i + 1) / 5.0);
        smooth = blurred(core, smooth, 0.5f);
    }
    progress.at(0.8);
    const std::uint32_t w = features.width, h = features.height;
    Histogram quarters[4], whole;
    core.parallel.for_each_index(4, [&](std::uint32_t k) {
        const std::uint32_t left = k % 2 * (w / 2), top = k / 2 * (h / 2);
        quarters[k] = histogram_of(smooth, left, top, left + w / 2, top + h / 2);
    });
    for (const Histogram& quarter : quarters)
        for (std::uint32_t i = 0; i < directions; ++i) whole.share[i] += quarter.share[i];
    whole = smoothed(whole);
    double between = 0; // how much the quarters differ by themselves
    for (const Histogram& quarter : quarters) between += difference_of(whole, smoothed(quarter), 0) / 4;
    double difference[5];
    Turns turns;
    for (std::uint32_t turn = 1; turn <= 4; ++turn) {
        difference[turn] = difference_of(whole, whole, turn);
        if (difference[turn] <= std::max(like, 1.5 * between)) turns.borne |= 1U << turn;
    }
    constexpr std::uint32_t oblique = 0b01110; // what does not bear all of these has directions
    if ((turns.borne & oblique) != oblique) turns.borne &= ~oblique;
    turns.right_angles = difference[1] > std::max(unlike, 1.5 * difference[2]);
    return turns;
}

} // namespace

Bearing bearing_of(Core& core, const Features& features, const Correlation& correlation, const Progress& progress)
{
    Bearing bearing;
    const Turns turns = turns_of(core, features, progress);
    bearing.lattice = turns.right_angles || correlation.far_peak() > lattice_peak;
    if (bearing.lattice) return bearing;
    bearing.turns = turns.borne;
    const bool isotropic = (bearing.turns & 2) != 0;
    bearing.scales = isotropic ? 3 : 2;
    bearing.turbulence = isotropic ? 5 : 3;
    return bearing;
}

} // namespace weft
