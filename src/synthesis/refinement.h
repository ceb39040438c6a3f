/// The next coarser level of a texton, by least squares: B-splines twice as wide that come closest to the filtered
/// noise.
#pragma once
#include "base/parallel.h"
#include "model/model.h"

namespace weft {

/// The level of texels twice as large. `first`: from level 0, which is not filtered yet; its successor is filtered by a
/// box of 2 texels. Later levels are filtered by a box as wide as their texels, which is the mean of two of the half
/// width. Each plane keeps its sum, and with it the noise its mean.
Planes coarser(const Planes& fine, std::uint32_t taps, bool first, std::pmr::memory_resource* memory,
               Parallel& parallel);

} // namespace weft
