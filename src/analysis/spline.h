/// The B-spline that interpolates a texton's coefficients, as its covariance sees it (paper, section 4.1).
#pragma once
#include "analysis/spectra.h"

namespace weft {

/// Samples at the integers 0, 1, ... of psi * psi, one axis, psi the B-spline of `taps` - 1: the B-spline of twice that
/// order and one more. `count` is 1, 2, 4, 6.
struct SplineSamples {
    std::uint32_t count = 1;
    double values[6] = {1};
};
SplineSamples spline_samples(std::uint32_t taps) noexcept;

/// b^ on one axis of `length` pixels at the frequencies 0 .. count - 1: positive, by folding right for any length.
Array<float> spline_spectrum(std::pmr::memory_resource* memory, const SplineSamples& samples, std::uint32_t length,
                             std::uint32_t count);

/// Cholesky factor of b on one axis of `length` pixels, restricted to the first `support` of them. It is banded but for
/// its last rows where b reaches around the axis's end, so each row is kept from its first value that is not 0 on.
class AxisFactor {
public:
    AxisFactor(std::pmr::memory_resource* memory, const SplineSamples& samples, std::uint32_t length,
               std::uint32_t support);
    /// Solves for `count` unknowns side by side: unknown i of number k is values[i * step + k].
    void solve(float* values, std::size_t step, std::uint32_t count) const noexcept;

private:
    std::uint32_t support_;
    Array<std::uint32_t> first_;  ///< of each row
    Array<std::size_t> diagonal_; ///< where each row ends in factor_
    Array<float> factor_;         ///< rows one after another, the inverse of the diagonal at their ends
};

/// Solves with the matrix b restricted to a square support, which is separable.
class SplineSolver {
public:
    SplineSolver(Core& core, const SplineSamples& samples, std::uint32_t width, std::uint32_t height,
                 std::uint32_t support);
    void solve(Planes& planes) const; ///< in place; support * support planes

private:
    Core& core_;
    std::uint32_t support_;
    AxisFactor along_x_, along_y_;
};

} // namespace weft
