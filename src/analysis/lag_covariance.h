/// The autocovariance of a picture at small lags, from blocks, so that its size costs no memory.
#pragma once
#include "analysis/compare_pair.h"

namespace weft {

/// For each channel the lags (x, y) with |x| <= reach and 0 <= y <= reach; the others follow by symmetry.
struct LagCovariance {
    std::uint32_t reach = 0;
    Array<double> values;

    std::size_t index(std::uint32_t channel, std::int64_t x, std::int64_t y) const noexcept
    {
        const std::int64_t side = reach;
        return static_cast<std::size_t>((channel * (side + 1) + y) * (2 * side + 1) + x + side);
    }
};

/// Unbiased: the mean over all pairs of pixels at that lag, or over those that begin in 256 blocks of a large picture.
LagCovariance lag_covariance_of(Core& core, const Planes& planes, const double* mean, std::uint32_t reach,
                                std::uint64_t seed, const Progress& progress);

} // namespace weft
