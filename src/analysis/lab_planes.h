/// Images as planes of CIE L*a*b*.
#pragma once
#include "base/array.h"
#include "base/core.h"

namespace weft {

/// Three planes of the first three channels taken as sRGB, or L* alone of the first if there are fewer. Throws as
/// read_image does.
Planes lab_planes(Core& core, const weft_image& image, const char* function, const char* argument);

} // namespace weft
