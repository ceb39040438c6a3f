/// What a wavelet noise model holds: weights of octaves, tone curves and the colour frame; as in weft_wavelet, but for
/// the mean.
#pragma once
#include <cstdint>

namespace weft {

constexpr std::uint32_t most_bands = 16, most_knots = 32;

/// Only [0, bands), [0, knots) and [0, channels) of each array are used; the rest is 0. Band b holds 2^-(b+2)..2^-(b+1)
/// cycles per pixel, and its noise has unit variance over the centres of pixels, at level 0.
struct Wavelet {
    std::uint32_t bands = 0;            ///< 1..16
    std::uint32_t knots = 0;            ///< 0: no tone curves; else 2..32
    float axes[16][16]{};               ///< row p: principal axis p, of unit length, orthogonal to the others
    float weight[most_bands][16]{};     ///< [band][axis], 0 or more
    float knot_x[most_knots][16]{};     ///< [knot][axis], ascending
    float knot_y[most_knots][16]{};     ///< not descending
    float knot_slope[most_knots][16]{}; ///< 0 or more
};

} // namespace weft
