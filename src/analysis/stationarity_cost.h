/// How much the neighbourhoods of an image differ from one another: c_stat (Moritz et al. 2017, equation 1).
#pragma once
#include "base/core.h"
#include "base/progress.h"

namespace weft {

/// As weft_stationarity_cost has it; options are complete, images checked. `map` may be NULL.
float stationarity_cost(Core& core, const weft_image& image, const weft_stationarity_options& options,
                        const Progress& progress, const weft_image* map);

} // namespace weft
