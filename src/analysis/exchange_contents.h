/// Content exchange (Vanhoey et al. 2013): patches, and what each of them may show instead of itself.
#pragma once
#include "analysis/exchange_search.h"
#include "analysis/structure_bearing.h"
#include "base/progress.h"
#include "model/bilayer.h"

namespace weft {

/// Of all diamonds if there are Wang tiles, otherwise of the whole structure as a torus; contents come from within
/// `bounds`. Offers also what the structure does not bear, for those who ask for it. Empty if nothing can be exchanged.
Exchange exchange_of(Core& core, const Features& features, const Wang& wang, const Bounds& bounds,
                     const Bearing& bearing, const Progress& progress);

} // namespace weft
