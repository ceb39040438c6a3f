/// What a texton is to reproduce: the spectrum and the covariance of a photo's periodic component.
#pragma once
#include "analysis/spline.h"
#include "analysis/statistics.h"
#include "base/progress.h"

namespace weft {

struct Target {
    Spectra spectra; ///< T = sqrt(b^) t^, t the photo's periodic component less its mean, times the centring's scale /
                     ///< sqrt(|Omega|)
    Matrix covariance; ///< of the periodic component's channels, scaled: the sum over all pixels of t t^T
    Centring centring;
    double power() const noexcept; ///< sum over all frequencies of |t^|^2: |Omega| times the covariance's trace
};

/// `planes` are the photo; they are given up on the way.
Target make_target(Core& core, Planes planes, const SplineSamples& samples, const Progress& progress);

} // namespace weft
