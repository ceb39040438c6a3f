/// The projections' arithmetic on one block of columns, all channels.
#pragma once
#include "analysis/projection.h"

namespace weft {

/// In place, block <- u T s - v block with s = T*block / sqrt(|T*block|^2 + smoothing^2); u = 1 / b^ and v = 0 with
/// `only_phases`, else u = 1 and v = b^. `b_x` and `b_y` are b^ along each axis.
void project_rows(const Spectra& target, std::uint32_t b, const float* b_x, const float* b_y, bool only_phases,
                  float smoothing, Complex* block) noexcept;

ModelSums measure_rows(const Spectra& target, std::uint32_t b, const float* b_x, const float* b_y,
                       const Complex* block) noexcept;

} // namespace weft
