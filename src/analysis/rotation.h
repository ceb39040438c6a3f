/// The shortest way from one frame of axes to another.
#pragma once
#include "analysis/matrix.h"

namespace weft {

/// Axis p of one frame goes with axis order[p] of the other, times sign[p].
struct Axis_match {
    std::uint32_t order[most_channels];
    int sign[most_channels];
};

/// The order and signs of the axes (rows) of `to` that make it a rotation of `from` by angles as small as can be: the
/// greatest sum of cosines between axes. Of up to 6 axes the best, of more a greedy choice.
Axis_match match_axes(const Matrix& from, const Matrix& to) noexcept;

/// The frame at t between `from` (0) and `to` (1), along the geodesic of the rotation that takes one to the other: of
/// three axes that is the spherical interpolation of quaternions (Shoemake 1985). Frames are orthonormal but for
/// rounding.
Matrix rotate_frame(const Matrix& from, const Matrix& to, double t) noexcept;

} // namespace weft
