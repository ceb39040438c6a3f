/// Filters of the uniform quadratic B-spline: what wavelet noise is made with (Cook and DeRose 2005).
#pragma once
#include "synthesis/torus.h"

namespace weft {

struct Wavelet_filters {
    Wavelet_filters() noexcept;

    Taps analysis;   ///< half the resolution, in the sense of least squares: 32 taps; kept at even coefficients
    Taps refinement; ///< 1/4, 3/4, 3/4, 1/4: from coefficients at even places to all
    Taps low_pass;   ///< what analysis and refinement do on the mean over all places
};

/// The mean of w_i(t) w_i+k(t), summed over i, at lags k = -2..2: w(t) the spline's three weights, t the middles of
/// 2^log2 equal parts of a cell, or, beyond `most_parts_log2`, all of it.
constexpr std::uint32_t most_parts_log2 = 6;
Taps spline_overlap(std::uint32_t log2) noexcept;

} // namespace weft
