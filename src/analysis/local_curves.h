/// Curves that bring the values around each cell of a grid to the distribution of the whole.
#pragma once
#include "analysis/neighbourhoods.h"
#include <weft/weft.h>

namespace weft {

/// Makes the planes stationary, each by itself: local histograms, or local moments up to `moments`, become those of the
/// whole plane (paper, section 4.3). `moments` 0: histograms.
void equalise(Core& core, Planes& planes, const Neighbourhoods& neighbourhoods, std::uint32_t moments,
              const Progress& progress);

} // namespace weft
