/// How far the patches of an image are from those of another: c_text (Moritz et al. 2017, equation 5).
#pragma once
#include "base/core.h"
#include "base/progress.h"

namespace weft {

/// As weft_texture_cost has it; options are complete, images checked.
float texture_cost(Core& core, const weft_image& exemplar, const weft_image& output,
                   const weft_texture_cost_options& options, const Progress& progress);

} // namespace weft
