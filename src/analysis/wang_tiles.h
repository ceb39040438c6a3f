/// Wang tiles of a structure: cells composed of diamonds of the exemplar along minimal cuts (Cohen et al. 2003).
#pragma once
#include "analysis/structure_correlation.h"
#include "base/progress.h"
#include "model/bilayer.h"

namespace weft {

Wang wang_tiles_of(Core& core, const Features& features, const Correlation& correlation, std::uint32_t colours,
                   std::uint64_t seed, const Progress& progress);

} // namespace weft
