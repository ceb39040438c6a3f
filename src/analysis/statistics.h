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

/// One block's share in the sum over all frequencies of weight(lane, y) times real(v v*), v the channels' values in `block`,
/// which is laid out as block `b` of `spectra`.
template <class Weight>
Matrix block_covariance(const Spectra& spectra, std::uint32_t b, const Complex* block, const Weight& weight) noexcept
{
    Matrix sum;
    sum.size = spectra.count;
    const auto wide = [&](std::size_t i) { return std::complex<double>(block[i]); };
    for (std::uint32_t lane = 0; lane < fft_lanes; ++lane) {
        const double copies = static_cast<double>(spectra.weight(b * fft_lanes + lane));
        if (copies == 0) continue;
        for (std::uint32_t y = 0; y < spectra.height; ++y) {
            const double factor = copies * weight(lane, y);
            for (std::uint32_t i = 0; i < sum.size; ++i)
                for (std::uint32_t j = i; j < sum.size; ++j) {
                    const auto u = wide(i * spectra.block_size() + y * fft_lanes + lane);
                    const auto v = wide(j * spectra.block_size() + y * fft_lanes + lane);
                    sum[i][j] += factor * (u.real() * v.real() + u.imag() * v.imag());
                }
        }
    }
    return sum;
}

/// The sum of blocks' upper halves, both halves filled.
Matrix sum_of(const Array<Matrix>& parts, std::uint32_t size) noexcept;

} // namespace weft
