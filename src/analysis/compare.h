/// How close an output is to its exemplar: the metrics of weft_compare.
#pragma once
#include "base/core.h"
#include "base/progress.h"

namespace weft {

/// `comparison->size` is set by the caller; all else is filled.
void compare(Core& core, const weft_image& exemplar, const weft_image& output, const weft_compare_options& options,
             const Progress& progress, weft_comparison& comparison);

} // namespace weft
