/// The patches of a view: compact regions of like pixels, whose borders follow edges, and how deep texels lie in them.
#pragma once
#include "analysis/exchange_pieces.h"
#include "base/progress.h"

namespace weft {

struct Patches_of_view {
    std::uint32_t count = 0;
    Array<std::uint32_t> patch; ///< of each texel, or no_patch
    Array<std::uint8_t> depth;  ///< of each texel: distance to the patch's border in eighths of a texel, 0..191
};

/// Patches of about `side` texels a side: SLIC (Achanta et al. 2012).
Patches_of_view patches_of(Core& core, const Features& features, const View& view, float side,
                           const Progress& progress);

} // namespace weft
