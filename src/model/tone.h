/// Tone curves of principal axes: cubic Hermite splines through knots, constant beyond them.
#pragma once
#include "model/colour_axes.h"

namespace weft {

/// Between two knots: c0 + d (c1 + d (c2 + d c3)), d = v - x.
struct Tone_piece {
    float x, c0, c1, c2, c3;
};

/// From knot `k` to the next one; k < knots - 1.
Tone_piece tone_piece(const Colour_axes& colours, std::uint32_t axis, std::uint32_t k) noexcept;

/// The tone curve of an axis at v; v itself if there are no knots.
double tone_at(const Colour_axes& colours, std::uint32_t axis, double v) noexcept;

/// Mean and variance of what the tone curve of an axis makes of normal numbers of mean 0. The same on every machine.
struct Tone_moments {
    double mean, variance;
};
Tone_moments tone_moments(const Colour_axes& colours, std::uint32_t axis, double variance) noexcept;

} // namespace weft
