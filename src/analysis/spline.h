/// The B-spline that interpolates a texton's coefficients, as its covariance sees it (paper, section 4.1).
#pragma once
#include "analysis/spectra.h"

namespace weft {

/// Samples at the integers 0, 1, ... of psi * psi, one axis, psi the B-spline of `taps` - 1: the B-spline of twice that order
/// and one more. `count` is 1, 2, 4, 6.
struct SplineSamples {
    std::uint32_t count = 1;
    double values[6] = {1};
};
SplineSamples spline_samples(std::uint32_t taps) noexcept;

/// b^ on one axis of `length` pixels at the frequencies 0 .. count - 1: positive, by folding right for any length.
Array<float> spline_spectrum(std::pmr::memory_resource* memory, const SplineSamples& samples, std::uint32_t length,
                             std::uint32_t count);

/// Solves with the matrix b restricted to a square support: separable, and banded on each axis.
class SplineSolver {
public:
    SplineSolver(Core& core, const SplineSamples& samples, std::uint32_t support);
    void solve(Planes& planes) const; ///< in place; support * support planes

private:
    void solve_columns(float* plane, std::uint32_t first, std::uint32_t last) const noexcept;
    void solve_row(float* row) const noexcept;

    Core& core_;
    std::uint32_t support_, band_;
    Array<float> factor_; ///< Cholesky: row i is 1 / L(i, i), L(i, i - 1), ..., L(i, i - band)
};

} // namespace weft
