/// Sums of products and numbers of pairs at all lags, divided.
#include "analysis/region_spectrum.h"
#include <algorithm>
#include <cmath>

namespace weft {

Region_spectrum::Region_spectrum(Core& core, std::uint32_t width, std::uint32_t height, std::uint32_t support)
    : core_(core), width_(width), height_(height), support_(support),
      padded_(&core.memory, fast_length(width + support), fast_length(height + support), 1),
      spectra_(&core.memory, padded_.width, padded_.height, 1), transform_(core, padded_.width, padded_.height),
      small_(core, fast_length(2 * support), fast_length(2 * support)),
      pairs_(&core.memory, fast_length(2 * support), fast_length(2 * support), 1),
      lags_(&core.memory, pairs_.width, pairs_.height, 1), window_(&core.memory, pairs_.width)
{
    for (std::uint32_t lag = 0; lag < support; ++lag)
        window_[lag] = static_cast<float>(0.5 + 0.5 * std::cos(3.141592653589793 * lag / support));
}

void Region_spectrum::correlate(const float* plane, Planes& lags)
{
    std::fill(padded_.values.begin(), padded_.values.end(), 0.0F);
    for (std::size_t y = 0; y < height_; ++y) std::copy_n(plane + y * width_, width_, padded_.row(0, y));
    transform_.forward(padded_.plane(0), spectra_, 0);
    for (Complex& value : spectra_.values) value = std::norm(value);
    transform_.backward(spectra_, 0, padded_.plane(0));
    const float unit = 1 / static_cast<float>(padded_.area());
    const auto reach = static_cast<std::int64_t>(support_) - 1;
    const auto wrapped = [](std::int64_t lag, std::uint32_t length) {
        return static_cast<std::size_t>(lag < 0 ? lag + length : lag);
    };
    for (std::int64_t y = -reach; y <= reach; ++y)
        for (std::int64_t x = -reach; x <= reach; ++x)
            lags.row(0, wrapped(y, lags.height))[wrapped(x, lags.width)] =
                padded_.row(0, wrapped(y, padded_.height))[wrapped(x, padded_.width)] * unit;
}

void Region_spectrum::set_region(const float* region) { correlate(region, pairs_); }

/// From sums to covariances. Dividing by the pairs alone would give those of far lags without bias, but of too few
/// pairs to be of use; dividing by those of lag 0, as the paper does, takes the region's shape for the noise's. Half of
/// each, under a Hann window over the lags, is nearer to the true spectrum than either.
void Region_spectrum::smooth()
{
    const float all = pairs_.values[0];
    for (std::size_t y = 0; y < lags_.height; ++y)
        for (std::size_t x = 0; x < lags_.width; ++x) {
            const float weight = window_[std::min(x, lags_.width - x)] * window_[std::min(y, lags_.height - y)];
            lags_.row(0, y)[x] *= weight / (pairs_.row(0, y)[x] + 0.5F * all);
        }
}

Target Region_spectrum::target_of(const float* plane, const SplineSamples& samples)
{
    correlate(plane, lags_);
    smooth();
    Target target;
    const std::uint32_t side = lags_.width;
    target.spectra = Spectra(&core_.memory, side, side, 1);
    small_.forward(lags_.plane(0), target.spectra, 0);
    double power = 0;
    for (std::uint32_t x = 0; x < target.spectra.columns(); ++x)
        for (std::uint32_t y = 0; y < side; ++y) {
            Complex& value = target.spectra.at(0, x, y);
            value = std::max(value.real(), 0.0F);
            power += static_cast<double>(target.spectra.weight(x) * value.real());
        }
    const Array<float> b = spline_spectrum(&core_.memory, samples, side, side);
    const double scale = static_cast<double>(side) * side / power;
    for (std::uint32_t x = 0; x < target.spectra.columns(); ++x)
        for (std::uint32_t y = 0; y < side; ++y) {
            Complex& value = target.spectra.at(0, x, y);
            value = static_cast<float>(std::sqrt(static_cast<double>(value.real() * b[x] * b[y]) * scale));
        }
    target.covariance.size = 1;
    target.covariance[0][0] = 1;
    return target;
}

} // namespace weft
