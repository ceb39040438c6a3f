/// Sizes, finite numbers, axes and tone curves.
#include "model/rules.h"
#include "model/tone.h"
#include <cmath>

namespace weft {

void Rules::planes(const Planes& planes, std::uint32_t channels, const char* what) const
{
    demand(planes.width >= 1 && planes.width <= most_side, "the ", what, "'s width is ", planes.width, ", not 1..",
           most_side);
    demand(planes.height >= 1 && planes.height <= most_side, "the ", what, "'s height is ", planes.height, ", not 1..",
           most_side);
    demand(planes.count == channels, "the ", what, " has ", planes.count, " channels, the model has ", channels);
    demand(planes.values.size() == planes.area() * planes.count, "the ", what, " has ", planes.values.size(),
           " values");
    demand(all_finite(planes.values.data(), planes.values.size()), "the ", what,
           " has a value that is not finite, or beyond 2^64");
}

void Rules::rows(const float (*values)[16], std::uint32_t count, std::uint32_t channels, const char* name) const
{
    for (std::uint32_t i = 0; i < count; ++i)
        demand(all_finite(values[i], channels), name, "[", i, "] has a number that is not finite, or beyond 2^64");
}

void Rules::colours(const Colour_axes& colours, std::uint32_t channels) const
{
    demand(colours.knots == 0 || (colours.knots >= 2 && colours.knots <= most_knots), "the model has ", colours.knots,
           " knots, neither 0 nor 2..", most_knots);
    rows(colours.axes, channels, channels, "axes");
    rows(colours.knot_x, colours.knots, channels, "knot_x");
    rows(colours.knot_y, colours.knots, channels, "knot_y");
    rows(colours.knot_slope, colours.knots, channels, "knot_slope");
    axes(colours, channels);
    for (std::uint32_t p = 0; p < channels; ++p) tone(colours, p);
}

void Rules::axes(const Colour_axes& colours, std::uint32_t channels) const
{
    for (std::uint32_t p = 0; p < channels; ++p)
        for (std::uint32_t q = 0; q <= p; ++q) {
            double product = 0;
            for (std::uint32_t o = 0; o < channels; ++o)
                product += static_cast<double>(colours.axes[p][o]) * static_cast<double>(colours.axes[q][o]);
            demand(std::abs(product - (p == q ? 1 : 0)) <= 1e-3, "axes ", p, " and ", q, " have the product ", product,
                   p == q ? ", not 1" : ", not 0");
        }
}

void Rules::tone(const Colour_axes& colours, std::uint32_t axis) const
{
    for (std::uint32_t k = 0; k < colours.knots; ++k) {
        demand(colours.knot_slope[k][axis] >= 0, "knot_slope[", k, "][", axis, "] is ", colours.knot_slope[k][axis],
               ", below 0");
        if (k == 0) continue;
        demand(colours.knot_x[k - 1][axis] < colours.knot_x[k][axis], "knot_x[", k, "][", axis, "] is ",
               colours.knot_x[k][axis], ", not above the knot before");
        demand(colours.knot_y[k - 1][axis] <= colours.knot_y[k][axis], "knot_y[", k, "][", axis, "] is ",
               colours.knot_y[k][axis], ", below the knot before");
        const Tone_piece piece = tone_piece(colours, axis, k - 1);
        demand(all_finite(&piece.c0, 4), "the tone curve of axis ", axis, " is too steep at knot ", k - 1);
    }
}

} // namespace weft
