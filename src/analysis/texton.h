/// Photo -> texton: Algorithm 1 of Galerne, Leclaire, Moisan 2017.
#pragma once
#include "base/core.h"
#include "base/progress.h"
#include "model/model.h"

namespace weft {

/// `options` has been read and is complete in size; zeros still stand for defaults. Errors name weft_analyze_texton.
Model analyze_texton(Core& core, const weft_image& photo, const weft_texton_options& options, const Progress& progress);

} // namespace weft
