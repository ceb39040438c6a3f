/// The filter that finds the structure layer: joint bilateral, guided by local spectra (Guingo et al. 2017, section 5).
#pragma once
#include "analysis/local_spectrum.h"

namespace weft {

struct Structure_filter {
    std::uint32_t width;      ///< of the neighbourhood; of an even one, pixels at half that distance count half
    std::uint32_t iterations; ///< over which the guide stays as it is
    float sigma;              ///< the weight of two pixels is exp(-|S_x - S_y|^2 / (2 sigma^2)); below e^-16 it is 0
};

/// `planes` <- their structure.
void filter_structure(Core& core, const Local_spectra& guide, const Structure_filter& filter, Planes& planes,
                      const Progress& progress);

} // namespace weft
