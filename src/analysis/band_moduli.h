/// What tells structure from Gaussian texture: moduli of oriented bands, which structure makes rise together.
#pragma once
#include "analysis/spectra.h"

namespace weft {

constexpr std::uint32_t moduli_scales = 4, moduli_orientations = 4, moduli_bands = moduli_scales * moduli_orientations;

/// Correlations between the moduli of complex band-pass filters, four octaves by four orientations (Portilla and
/// Simoncelli 2000).
struct Moduli_correlations {
    double value[moduli_bands][moduli_bands] = {};
};
Moduli_correlations moduli_correlations(Core& core, const PlaneTransform& transform, const Spectra& spectrum);

/// Root mean square of the differences between pairs of bands.
double distance_of(const Moduli_correlations& a, const Moduli_correlations& b) noexcept;

/// `result` <- the spectrum with random phases: of a Gaussian texture with the same autocovariance.
void randomise_phases(Core& core, const Spectra& spectrum, std::uint64_t seed, Spectra& result);

} // namespace weft
