/// Power spectrum, autocovariance and histogram of an image, as weft.h has them.
#pragma once
#include "base/core.h"

namespace weft {

void power_spectrum(Core& core, const weft_image& image, const weft_image& spectrum);
void autocovariance(Core& core, const weft_image& image, const weft_image& covariance);
void histogram(Core& core, const weft_image& image, float low, float high, std::uint32_t bins, std::uint64_t* counts);

} // namespace weft
