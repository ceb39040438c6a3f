/// By Wiener and Khinchin, with room enough that lags up to half the size do not wrap.
#include "analysis/structure_correlation.h"
#include "analysis/spectra.h"
#include "base/elementary.h"
#include <algorithm>

namespace weft {
namespace {

constexpr double high_pass = 16; ///< deviation of the Gaussian that is taken off, in pixels
constexpr std::int32_t least_lag = 20;

/// Of each frequency, what the Gaussian lets through along one axis.
Array<float> gaussian(std::pmr::memory_resource* memory, std::uint32_t size)
{
    Array<float> passed(memory, size);
    for (std::uint32_t i = 0; i < size; ++i) {
        const double frequency = static_cast<double>(std::min(i, size - i)) / size;
        const double exponent = 2 * 9.8696044 * high_pass * high_pass * frequency * frequency;
        passed[i] = static_cast<float>(exponential_of_minus(std::min(exponent, 700.0)));
    }
    return passed;
}

} // namespace

Correlation::Correlation(Core& core, const Features& features, const Progress& progress)
    : width_(features.width), height_(features.height),
      sums_(&core.memory, fast_length(width_ * 3 / 2 + 1), fast_length(height_ * 3 / 2 + 1), 1)
{
    Spectra spectrum(&core.memory, sums_.width, sums_.height, 1), power(&core.memory, sums_.width, sums_.height, 1);
    const PlaneTransform transform(core, sums_.width, sums_.height);
    for (std::uint32_t c = 0; c < 4; ++c) {
        std::fill(sums_.values.begin(), sums_.values.end(), 0.0f);
        for (std::size_t y = 0; y < height_; ++y)
            for (std::size_t x = 0; x < width_; ++x) sums_.row(0, y)[x] = features.at(x, y).value[c];
        transform.forward(sums_.plane(0), spectrum, 0);
        for (std::size_t i = 0; i < power.values.size(); ++i) power.values[i] += std::norm(spectrum.values[i]);
        progress.at((c + 1) / 5.0);
    }
    const Array<float> across = gaussian(&core.memory, sums_.width), down = gaussian(&core.memory, sums_.height);
    for (std::size_t y = 0; y < sums_.height; ++y)
        for (std::size_t x = 0; x < power.columns(); ++x) {
            const float kept = 1 - across[x] * down[y];
            power.at(0, x, y) *= kept * kept;
        }
    transform.backward(power, 0, sums_.plane(0));
}

float Correlation::at(std::int32_t x, std::int32_t y) const noexcept
{
    const float all = sums_.plane(0)[0];
    if (!(all > 0)) return 0;
    const auto w = static_cast<std::int32_t>(width_), h = static_cast<std::int32_t>(height_);
    const auto share = static_cast<float>(w - std::abs(x)) / static_cast<float>(w) *
                       (static_cast<float>(h - std::abs(y)) / static_cast<float>(h));
    const auto column = static_cast<std::size_t>(x < 0 ? x + static_cast<std::int32_t>(sums_.width) : x),
               row = static_cast<std::size_t>(y < 0 ? y + static_cast<std::int32_t>(sums_.height) : y);
    return sums_.row(0, row)[column] / (all * share);
}

float Correlation::far_peak() const noexcept
{
    const auto w = static_cast<std::int32_t>(width_ / 2), h = static_cast<std::int32_t>(height_ / 2);
    float peak = 0;
    for (std::int32_t y = -h; y <= h; ++y)
        for (std::int32_t x = 0; x <= w; ++x)
            if (x * x + y * y >= least_lag * least_lag) peak = std::max(peak, at(x, y));
    return peak;
}

} // namespace weft
