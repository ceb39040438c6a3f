/// Welch's estimate (1967) of all the power spectra and cross spectra of a picture's channels.
#pragma once
#include "analysis/compare_pair.h"
#include "analysis/tile_transform.h"

namespace weft {

/// At each frequency of a tile (in TileTransform's layout) the lower triangle of the channels' Hermitian covariance
/// matrix, row by row; summed over all frequencies it is the channels' covariance.
struct CrossSpectrum {
    std::uint32_t channels = 0;
    Array<std::complex<double>> values;

    std::size_t triangle() const noexcept { return std::size_t{channels} * (channels + 1) / 2; }
    const std::complex<double>* at(std::size_t frequency) const noexcept
    {
        return values.data() + frequency * triangle();
    }
};

/// Hann windows of the transform's edge, spread evenly at half overlap or more; at most 4096, spread farther, where the
/// picture holds more. `mean` is taken off the channels.
CrossSpectrum cross_spectrum_of(Core& core, const Planes& planes, const double* mean, const TileTransform& transform,
                                const Progress& progress);

} // namespace weft
