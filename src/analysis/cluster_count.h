/// How many clusters points have.
#pragma once
#include "analysis/kmeans.h"

namespace weft {

/// 1..most.
std::uint32_t cluster_count(Core& core, const Points& points, std::uint32_t most, std::uint64_t seed,
                            const Progress& progress);

} // namespace weft
