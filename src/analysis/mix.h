/// Between two textons.
#pragma once
#include "base/core.h"
#include "base/progress.h"
#include "model/model.h"

namespace weft {

/// `steps` (2..255) textons on the path of optimal transport between the noises of a and b (Galerne et al. 2017,
/// section 7; Xia et al. 2014). The first and the last are a's and b's own, in the corner of a square that holds both;
/// each of the others starts from its neighbour on the side of the nearer end, which leaves less to correct than white
/// noise, and gets the barycentre's covariance of colours exactly. Throws WEFT_ERROR_ARGUMENT unless both are single
/// textons of as many channels and one interpolation.
Model mix_textons(Core& core, const Model& a, const Model& b, std::uint32_t steps,
                  const Progress& progress = Progress());

} // namespace weft
