/// Covariance between the channels of a texton's noise.
#pragma once
#include "analysis/matrix.h"
#include "analysis/spline.h"

namespace weft {

/// At lag 0, in the plane: sum over k and l of alpha(k) b(k - l) alpha(l)^T, where nothing wraps around.
Matrix noise_covariance(Core& core, const SplineSamples& samples, const Planes& coefficients);

} // namespace weft
