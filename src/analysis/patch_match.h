/// Nearest patches around the torus (Barnes et al. 2009): one pass of propagation and random search.
#pragma once
#include "analysis/match_field.h"
#include "analysis/uniformity.h"

namespace weft {

/// One pass over `field`, whose costs it sets to those of its matches with their penalties. The scan's origin and its
/// direction come from `key`. Returns the mean squared distance of a patch, without penalties. The same as a serial
/// scan, for any number of threads.
double search(Core& core, const Lab_picture& tile, const Lab_picture& exemplar, const Uniformity& uniformity,
              std::uint64_t key, Match_field& field, const Progress& progress);

} // namespace weft
