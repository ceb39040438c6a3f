/// Which deformations a structure bears, from measurements.
#pragma once
#include "analysis/structure_correlation.h"

namespace weft {

struct Bearing {
    bool lattice = false;     ///< repeats, or has courses and columns: bears no deformation, nor diagonal cuts of tiles
    std::uint32_t turns = 1;  ///< bits 0..4: rotations by so many eighths of a turn
    std::uint32_t scales = 1; ///< of those offered, from the first on
    float turbulence = 0;     ///< amplitude of a smooth distortion in pixels

    bool bears(std::uint32_t turn, std::uint32_t scale) const noexcept
    {
        return (turns >> turn & 1) != 0 && scale < scales;
    }
};

Bearing bearing_of(Core& core, const Features& features, const Correlation& correlation, const Progress& progress);

} // namespace weft
