/// Steerable filters (Freeman, Adelson 1991): a picture's band in 4 orientations.
#pragma once
#include "base/array.h"
#include "base/core.h"

namespace weft {

constexpr std::uint32_t orientations = 4;

/// Four planes: what varies along 0, 45, 90 and 135 degrees at 1/8..1/2 cycles per pixel, as a third derivative. The
/// picture repeats.
Planes oriented_bands(Core& core, const float* plane, std::uint32_t width, std::uint32_t height);

} // namespace weft
