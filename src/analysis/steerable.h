/// Steerable filters in four orientations: third derivatives of a Gaussian (Freeman and Adelson 1991), around the
/// torus.
#pragma once
#include "base/array.h"
#include "base/core.h"
#include "base/progress.h"

namespace weft {

constexpr std::uint32_t orientations = 4; ///< 0, 45, 90 and 135 degrees from the x axis towards the y axis

/// The responses of plane `c`. Their powers add up to a band around 0.18 cycles a pixel, 1 where it is strongest.
/// `responses` has the picture's size and 4 planes.
void steerable_responses(Core& core, const Planes& picture, std::uint32_t c, Planes& responses,
                         const Progress& progress);

/// Adds to plane `c` the filters weighted by `responses`: the transpose of the above.
void add_steerable(Core& core, const Planes& responses, Planes& picture, std::uint32_t c, const Progress& progress);

} // namespace weft
