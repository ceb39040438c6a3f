/// The metrics of weft_compare, one file each; what they mean stands at weft_comparison in weft.h.
#pragma once
#include "analysis/compare_pair.h"

namespace weft {

constexpr double undefined = -1; // a metric's answer where it is not defined

double model_error(Core& core, const Pair& pair, const Progress& progress);
double histogram_distance(Core& core, const Pair& pair, std::uint64_t seed, const Progress& progress);
double autocovariance_error(Core& core, const Pair& pair, std::uint64_t seed, const Progress& progress);
double patch_distance(Core& core, const Pair& pair, std::uint32_t level, std::uint64_t seed, const Progress& progress);
double repetition(Core& core, const Pair& pair, std::uint64_t seed, const Progress& progress);
double verbatim_copy(Core& core, const Pair& pair, std::uint64_t seed, const Progress& progress);
double seam_score(Core& core, const Pair& pair, const Progress& progress);

} // namespace weft
