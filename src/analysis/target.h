/// What a texton is to reproduce: the spectrum and the covariance of a photo's periodic component.
#pragma once
#include "analysis/matrix.h"
#include "analysis/spectra.h"
#include "analysis/spline.h"
#include "base/progress.h"

namespace weft {

struct Target {
    Spectra spectra;          ///< T = sqrt(b^) t^, t the photo's periodic component less its mean, times scale / sqrt(|Omega|)
    Matrix covariance;        ///< sum over all frequencies of real(t^ t^*): |Omega| times that of the photo, scaled
    std::array<double, most_channels> mean{};
    double scale = 1;         ///< a power of two that brings the largest deviation near 1, far from float's limits
    double power() const noexcept; ///< sum over all frequencies of |t^|^2
};

/// `planes` are the photo; they are given up on the way.
Target make_target(Core& core, Planes planes, const SplineSamples& samples, const Progress& progress);

} // namespace weft
