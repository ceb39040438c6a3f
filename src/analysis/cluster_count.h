/// How many clusters points have.
#pragma once
#include "analysis/kmeans.h"

namespace weft {

/// 1..most, the greater of two numbers. One sees kinds that do not pass into each other: the most clusters between any
/// two of which, along the line through their centres, there are fewer points midway than at either. The other sees how
/// much a continuous range of kinds is worth: clusters are added as long as one more takes 35 % of the sum of squares.
std::uint32_t cluster_count(Core& core, const Points& points, std::uint32_t most, std::uint64_t seed,
                            const Progress& progress);

/// The best of several starts.
Means best_means(Core& core, const Points& points, std::uint32_t count, std::uint64_t seed, const Progress& progress);

} // namespace weft
