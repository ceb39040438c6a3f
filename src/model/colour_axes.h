/// The principal axes that colours are made along, and the tone curve of each.
#pragma once
#include <cstdint>

namespace weft {

constexpr std::uint32_t most_knots = 32;

/// Only [0, knots) and [0, channels) of each array are used; the rest is 0.
struct Colour_axes {
    std::uint32_t knots = 0;            ///< 0: no tone curves; else 2..32
    float axes[16][16]{};               ///< row p: principal axis p, of unit length, orthogonal to the others
    float knot_x[most_knots][16]{};     ///< [knot][axis], ascending
    float knot_y[most_knots][16]{};     ///< not descending
    float knot_slope[most_knots][16]{}; ///< 0 or more
};

} // namespace weft
