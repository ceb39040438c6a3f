/// Photo -> structure layer, masks, noises: Guingo, Sauvage, Dischler, Cani 2017.
#pragma once
#include "base/core.h"
#include "base/progress.h"
#include "model/model.h"

namespace weft {

/// `options` has been read and is complete in size; zeros still stand for defaults. Errors name weft_analyze_bilayer.
Model analyze_bilayer(Core& core, const weft_image& photo, const weft_bilayer_options& options, const Progress& progress);

} // namespace weft
