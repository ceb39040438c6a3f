/// The contour within which a patch shows a content: the closed cut along which the two differ least.
#pragma once
#include "analysis/exchange_search.h"

namespace weft {

struct Content_contour {
    float error; ///< mean along the contour
    std::uint8_t depths[contour_knots];
};

Content_contour contour_of(const Search_pictures& pictures, const Patch_shape& shape, const Found& found) noexcept;

} // namespace weft
