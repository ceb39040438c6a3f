/// Which diamonds of the exemplar go well together on the edges of Wang tiles.
#pragma once
#include "analysis/structure_features.h"
#include "base/progress.h"
#include "model/bilayer.h"

namespace weft {

/// `wang.diamonds` <- diamonds whose cuts cost little, that overlap little, and that together show what the exemplar
/// does; wang's colours and sizes are given.
void select_diamonds(Core& core, const Features& features, std::uint64_t seed, Wang& wang, const Progress& progress);

} // namespace weft
