/// Photo -> wavelet noise: Lagae, Vangorp, Lenaerts, Dutre 2010.
#pragma once
#include "base/core.h"
#include "base/progress.h"
#include "model/model.h"

namespace weft {

/// `options` has been read and is complete in size; zeros still stand for defaults. Errors name weft_analyze_wavelet.
Model analyze_wavelet(Core& core, const weft_image& photo, const weft_wavelet_options& options,
                      const Progress& progress);

} // namespace weft
