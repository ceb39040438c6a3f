/// What turns white noise into a texton, for targets of any origin: projections, colour correction, what is left to
/// gain.
#pragma once
#include "analysis/projection.h"
#include "analysis/target.h"

namespace weft {

struct Fit {
    std::uint32_t iterations; ///< the start counts as the first
    bool accelerated;         ///< else Algorithm 1 as the paper has it
    bool ease;                ///< accelerated, from a start that is far off: weak phases count less at first
};

/// Alternating projections from `coefficients` on.
void fit_coefficients(Core& core, Projection& projection, const Fit& fit, const Target& target,
                      const SplineSamples& samples, Planes& coefficients, const Progress& progress);

/// coefficients <- B^1/2 A^-1/2 coefficients, A the noise's covariance and B the wanted one (paper, section 4.3).
void correct_colours(Core& core, const SplineSamples& samples, const Matrix& covariance, Planes& coefficients);

/// Relative model error (Xia et al. 2014) of the coefficients against the target.
double model_error(Projection& projection, const Target& target, const Planes& coefficients);

} // namespace weft
