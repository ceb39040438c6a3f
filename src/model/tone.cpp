/// The polynomials between knots, and their moments by the trapezoidal rule, which is nearly exact under a normal
/// density.
#include "model/tone.h"
#include "base/elementary.h"
#include <algorithm>
#include <cmath>

namespace weft {

Tone_piece tone_piece(const Colour_axes& colours, std::uint32_t axis, std::uint32_t k) noexcept
{
    const double x = static_cast<double>(colours.knot_x[k][axis]), y = static_cast<double>(colours.knot_y[k][axis]);
    const double width = static_cast<double>(colours.knot_x[k + 1][axis]) - x;
    const double slope = (static_cast<double>(colours.knot_y[k + 1][axis]) - y) / width;
    const double begin = static_cast<double>(colours.knot_slope[k][axis]),
                 end = static_cast<double>(colours.knot_slope[k + 1][axis]);
    const double c2 = (3 * slope - 2 * begin - end) / width, c3 = (begin + end - 2 * slope) / (width * width);
    return {colours.knot_x[k][axis], colours.knot_y[k][axis], colours.knot_slope[k][axis], static_cast<float>(c2),
            static_cast<float>(c3)};
}

double tone_at(const Colour_axes& colours, std::uint32_t axis, double v) noexcept
{
    if (colours.knots == 0) return v;
    const std::uint32_t last = colours.knots - 1;
    v = std::clamp(v, static_cast<double>(colours.knot_x[0][axis]), static_cast<double>(colours.knot_x[last][axis]));
    std::uint32_t k = 0;
    while (k + 1 < last && v >= static_cast<double>(colours.knot_x[k + 1][axis])) ++k;
    const Tone_piece piece = tone_piece(colours, axis, k);
    const double d = v - static_cast<double>(piece.x);
    return static_cast<double>(piece.c0) +
           d * (static_cast<double>(piece.c1) +
                d * (static_cast<double>(piece.c2) + d * static_cast<double>(piece.c3)));
}

Tone_moments tone_moments(const Colour_axes& colours, std::uint32_t axis, double variance) noexcept
{
    if (colours.knots == 0) return {0, variance};
    constexpr int half = 2048;
    constexpr double reach = 8, step = reach / half; // in standard deviations
    const double deviation = std::sqrt(variance);
    const double origin = tone_at(colours, axis, 0); // squares are about it, so that little cancels
    double total = 0, first = 0, second = 0;
    for (int i = -half; i <= half; ++i) {
        const double z = i * step, density = exponential_of_minus(0.5 * z * z);
        const double value = tone_at(colours, axis, deviation * z) - origin;
        total += density;
        first += density * value;
        second += density * value * value;
    }
    const double mean = first / total;
    return {origin + mean, std::max(0.0, second / total - mean * mean)};
}

} // namespace weft
