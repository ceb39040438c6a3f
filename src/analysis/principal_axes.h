/// The axes along which the channels of a picture do not correlate.
#pragma once
#include "analysis/matrix.h"
#include "base/core.h"

namespace weft {

/// Row p of `axes` is axis p, of unit length: the most varied first, its greatest component positive.
struct Principal_axes {
    Matrix axes;
    double variance[most_channels] = {};
};

/// Of planes whose means are 0. Summed in double and in an order that no number of threads changes.
Principal_axes principal_axes_of(Core& core, const Planes& planes);

/// plane <- what the planes are along axis `p`.
void project_on_axis(Core& core, const Planes& planes, const Matrix& axes, std::uint32_t p, float* plane);

} // namespace weft
