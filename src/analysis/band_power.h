/// Power in octaves of frequency, and the weights of the bands of wavelet noise that make it.
#pragma once
#include "base/array.h"
#include "base/core.h"
#include "model/wavelet.h"

namespace weft {

/// Octave a: max(|fx|, |fy|) within 2^-(a+2)..2^-(a+1) cycles per pixel; the last one also holds all that is below, but
/// for frequency 0.
struct Octaves {
    std::uint32_t count = 0;
    double power[most_bands] = {};
};

/// How many octaves a picture of that size holds, at least 1.
std::uint32_t octaves_in(std::uint32_t width, std::uint32_t height) noexcept;

/// Of the first plane's periodic component (Moisan 2011), which the borders' jumps do not leak into.
Octaves octaves_of(Core& core, const Planes& plane, std::uint32_t count);

/// share[a][b]: of the power, at the centres of pixels, of band b of wavelet noise what lies in octave a. Columns sum
/// up to 1.
struct Band_shares {
    std::uint32_t count = 0;
    double share[most_bands][most_bands] = {};
};
Band_shares band_shares(std::uint32_t count) noexcept;

/// The powers x >= 0 of bands with share * x = the octaves' power, in the sense of least squares if there are none;
/// their sum is the octaves'.
void solve_bands(const Band_shares& shares, const Octaves& octaves, double (&power)[most_bands]) noexcept;

} // namespace weft
