/// Coefficients of wavelet noise: band-limited Gaussian lattices on a torus.
#pragma once
#include "base/core.h"
#include "synthesis/wavelet_filters.h"

namespace weft {

/// Cook and DeRose 2005: white noise less what half the resolution can hold of it, and a copy at an odd offset added.
/// Even sides of 16 or more.
Torus make_wavelet_lattice(Core& core, const Sides& sides, std::uint64_t key, const Wavelet_filters& filters);

/// What several bands add to one lattice, whose sides may be any: octave c, counted from the lattice's own, has
/// deviation deviations[c] after evaluation, `overlap` being the evaluation's (spline_overlap). The same octaves, from
/// filters that do not halve the resolution but widen instead. An octave that the torus is too short for is left out.
Torus make_octaves(Core& core, const Sides& sides, std::uint64_t key, const Wavelet_filters& filters,
                   const Taps& overlap, std::uint32_t octaves, const float* deviations);

/// A shift along each axis, below its side.
Sides hashed_shift(const Sides& sides, std::uint64_t key) noexcept;

/// Mean square of the spline surface through the lattice, over the positions that `overlap` stands for.
double power_of(Core& core, const Torus& lattice, const Taps& overlap);

} // namespace weft
