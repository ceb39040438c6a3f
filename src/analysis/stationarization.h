/// Texture stationarization (Moritz et al. 2017): a photo becomes a tile that repeats without a seam, and without a
/// part that differs from the rest.
#pragma once
#include "base/core.h"
#include "base/progress.h"
#include "model/correspondence.h"

namespace weft {

struct Stationary_tile {
    Planes tile;           ///< all of the photo's channels, in its own encoding
    Correspondence origin; ///< assemble() of the photo by it is the tile, bit for bit
    double texture_cost = 0;
};

/// Errors name weft_analyze_stationary.
Stationary_tile stationarize(Core& core, const weft_image& photo, const weft_stationary_options& options,
                             const Progress& progress);

} // namespace weft
