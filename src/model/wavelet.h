/// What a wavelet noise model holds: weights of octaves, tone curves and the colour frame; as in weft_wavelet, but for
/// the mean.
#pragma once
#include "model/colour_axes.h"

namespace weft {

constexpr std::uint32_t most_bands = 16;

/// Only [0, bands) and [0, channels) are used; the rest is 0. Band b holds 2^-(b+2)..2^-(b+1) cycles per pixel, and its
/// noise has unit variance over the centres of pixels, at level 0.
struct Wavelet : Colour_axes {
    std::uint32_t bands = 0;        ///< 1..16
    float weight[most_bands][16]{}; ///< [band][axis], 0 or more
};

} // namespace weft
