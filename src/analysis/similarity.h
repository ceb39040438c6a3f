/// How alike the local spectra of pixels are.
#pragma once
#include "analysis/local_spectrum.h"

namespace weft {

/// to[x] <- share * exp(-scale * |S(x, y) - S(x + dx, other)|^2), or 0 where x + dx is outside.
void similarities(const Local_spectra& spectra, std::uint32_t y, std::uint32_t other, std::int32_t dx, float scale,
                  float share, float* to) noexcept;

} // namespace weft
