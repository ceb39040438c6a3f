/// Means, extremes and covariances, summed in double and in an order that no number of threads changes.
#pragma once
#include "analysis/matrix.h"
#include "analysis/spectra.h"

namespace weft {

/// How planes were centred: values <- (values - mean) * scale, a constant channel exactly 0.
struct Centring {
    double mean[most_channels] = {}, deviation[most_channels] = {};
    double scale = 1; ///< a power of two that brings the largest deviation to 1..2, far from float's limits
};
Centring centre(Core& core, Planes& planes);

/// One block's share in `unit` times the sum over all frequencies of real(v v*), v the channels' values in `block`,
/// which is laid out as block `b` of `spectra`. Only the upper half is filled.
Matrix block_covariance(const Spectra& spectra, std::uint32_t b, const Complex* block, double unit) noexcept;

/// The sum of matrices of which only upper halves are filled; both halves of it are.
Matrix sum_of(const Array<Matrix>& parts, std::uint32_t size) noexcept;

} // namespace weft
