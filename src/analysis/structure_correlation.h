/// How much a structure resembles itself some way off.
#pragma once
#include "analysis/structure_features.h"
#include "base/progress.h"

namespace weft {

/// Autocorrelation of all features together, after a high-pass filter: 1 at (0, 0).
class Correlation {
public:
    Correlation(Core& core, const Features& features, const Progress& progress);

    /// Of pixels that are x to the right and y below, up to half the size.
    float at(std::int32_t x, std::int32_t y) const noexcept;
    /// Highest of those that are farther than what belongs to one and the same feature.
    float far_peak() const noexcept;

private:
    std::uint32_t width_, height_;
    Planes sums_; ///< over pairs, around (0, 0) as a torus
};

} // namespace weft
