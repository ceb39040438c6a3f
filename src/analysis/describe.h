/// Which method suits a photo, and why.
#pragma once
#include "base/core.h"
#include "base/progress.h"

namespace weft {

/// `description->size` is set by the caller; all else is filled. Errors name weft_describe.
void describe(Core& core, const weft_image& photo, const Progress& progress, weft_description& description);

} // namespace weft
