/// One noise of a bi-layer texture: colour axes, tone curves and textons of what a cluster's pixels hold.
#pragma once
#include "analysis/masks.h"
#include "analysis/region_spectrum.h"
#include "model/bilayer.h"

namespace weft {

struct Noise_choices {
    std::uint32_t support;
    bool equalize;
    double scale;       ///< of the residual: that many times the photo's unit, a power of two
    std::uint64_t seed; ///< of the white noise that all clusters' textons start from: one for each axis
};

/// Of cluster k. `residual` is N.
Noise learn_noise(Core& core, const Planes& residual, const Regions& regions, std::uint32_t k,
                  const Noise_choices& choices, Region_spectrum& spectrum, const Progress& progress);

} // namespace weft
