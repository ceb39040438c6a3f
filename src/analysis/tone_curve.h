/// Histogram matching with a normal distribution, and the curve that undoes it.
#pragma once
#include "base/array.h"
#include "base/core.h"
#include "model/colour_axes.h"

namespace weft {

/// The values of a picture against the normal numbers of their ranks, both ascending.
class Normal_scores {
public:
    /// Of at most 2^16 pixels, evenly spread.
    Normal_scores(Core& core, const float* values, std::size_t count);

    /// values <- factor * their scores.
    void apply(Core& core, float* values, std::size_t count, float factor) const;

    float value_at(float score) const noexcept; ///< between the scores the line, beyond them the ends
    float least_score() const noexcept { return scores_[0]; }
    float greatest_score() const noexcept { return scores_[size_ - 1]; }

private:
    std::uint32_t hint_of(float value) const noexcept;

    std::size_t size_ = 0;
    Array<float> values_, scores_;
    Array<std::uint32_t> hints_; ///< the last entry below each of equal intervals of values
};

/// Sets the knots of `axis`: the curve that makes values / unit of normal numbers of standard deviation `deviation`, of
/// mean 0 and standard deviation `wanted` exactly. tones.knots are set where the curve needs them most.
void fit_tone_curve(const Normal_scores& scores, double unit, double deviation, double wanted, std::uint32_t axis,
                    Colour_axes& tones) noexcept;

/// A tone curve that is 0 everywhere.
void set_flat_tone_curve(std::uint32_t axis, Colour_axes& tones) noexcept;

/// Slopes of a monotone cubic Hermite spline through ascending points (Fritsch and Carlson 1980).
void monotone_slopes(const double* x, const double* y, std::uint32_t count, double* slope) noexcept;

} // namespace weft
