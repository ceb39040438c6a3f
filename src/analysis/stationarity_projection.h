/// The tile made stationary by one of the paper's measures (section 4.3).
#pragma once
#include "analysis/lab_picture.h"
#include "analysis/neighbourhoods.h"

namespace weft {

/// For a tile of the neighbourhoods' size; its margin is left as it is.
void project(Core& core, const Neighbourhoods& neighbourhoods, weft_stationarity measure, std::uint32_t moments,
             Lab_picture& tile, const Progress& progress);

} // namespace weft
