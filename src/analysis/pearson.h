/// Distributions made of their first moments.
#pragma once
#include <cstdint>

namespace weft {

/// Of a histogram whose bins are one apart, the first's middle at 0.5. A histogram in one bin has deviation 0.
struct Moments {
    double mean, deviation, skewness, kurtosis; ///< kurtosis 3: Gaussian
};

Moments moments_of(const float* bins, std::uint32_t count) noexcept;

/// Fills a histogram of sum 1 with the Pearson distribution of these moments; of `order` 3 with the type III, whose
/// kurtosis follows from its skewness. Moments that only distributions with two peaks or a peak at the end of their
/// range have are replaced by the nearest kurtosis that others have.
void fit_pearson(const Moments& moments, std::uint32_t order, std::uint32_t count, float* bins) noexcept;

} // namespace weft
