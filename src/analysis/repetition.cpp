/// The highest far peak of an output's autocovariance, against Gaussian textures with the exemplar's.
#include "analysis/compare_metrics.h"
#include "analysis/spectra.h"
#include "analysis/white_noise.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr std::uint32_t realisations = 8, least_domain = 1024, nearest_lag = 48;

/// The part of both pictures that is looked at: from the middle of the output, twice the exemplar's size where that is
/// more than 1024 pixels, so that a repetition of the whole exemplar lies within its lags; of the exemplar as much as
/// fits.
struct Domain {
    std::uint32_t width, height;

    explicit Domain(const Pair& pair) noexcept
        : width(even(std::min(pair.output.width, std::max(2 * pair.exemplar.width, least_domain)))),
          height(even(std::min(pair.output.height, std::max(2 * pair.exemplar.height, least_domain))))
    {
    }
    static std::uint32_t even(std::uint32_t size) noexcept { return size & ~1u; }
};

/// Sum over the channels of the squared moduli of the DFT of the middle of `planes`, zero beyond them, as real parts.
Spectra power_of(Core& core, const PlaneTransform& transform, const Planes& planes, const double* mean, Domain domain,
                 const Progress& progress)
{
    Spectra power(&core.memory, domain.width, domain.height, 1), spectrum(&core.memory, domain.width, domain.height, 1);
    Array<float> plane(&core.memory, std::size_t{domain.width} * domain.height);
    const std::size_t width = std::min(planes.width, domain.width), height = std::min(planes.height, domain.height);
    const std::size_t left = (planes.width - width) / 2, top = (planes.height - height) / 2;
    for (std::uint32_t c = 0; c < planes.count; ++c) {
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = 0; x < width; ++x)
                plane[y * domain.width + x] = planes.row(c, top + y)[left + x] - static_cast<float>(mean[c]);
        transform.forward(plane.data(), spectrum, 0);
        for (std::size_t i = 0; i < power.values.size(); ++i) power.values[i] += std::norm(spectrum.values[i]);
        progress.at((c + 1.0) / planes.count);
    }
    return power;
}

/// Periodogram -> one of a Gaussian texture: every frequency times an independent exponential of mean 1, which is the
/// squared modulus of the DFT of white Gaussian noise. A frequency and its conjugate share theirs.
void randomise(Core& core, const Spectra& power, std::uint64_t seed, Spectra& result)
{
    core.parallel.for_each_index(power.blocks(), [&](std::uint32_t b) {
        for (std::size_t i = 0; i < power.block_size(); ++i) {
            const std::uint64_t x = b * fft_lanes + i % fft_lanes, y = i / fft_lanes;
            const bool own_conjugate = x == 0 || 2 * x == power.width;
            const std::uint64_t row = own_conjugate ? std::min(y, (power.height - y) % power.height) : y;
            const std::complex<float> normal = normal_pair(seed, x * power.height + row);
            const bool real = own_conjugate && (2 * row) % power.height == 0;
            const float factor = real ? normal.real() * normal.real() : std::norm(normal) / 2;
            result.block(b, 0)[i] = power.block(b, 0)[i].real() * factor;
        }
    });
}

/// max C(tau) / C(0) over lags beyond `nearest` along either axis, C the circular autocovariance; destroys `power`.
double highest_peak(Core& core, const PlaneTransform& transform, Spectra& power, std::uint32_t nearest,
                    Array<float>& plane)
{
    power.at(0, 0, 0) = 0;
    transform.backward(power, 0, plane.data());
    Array<float> peaks(&core.memory, power.height);
    const auto far = [nearest](std::size_t lag, std::size_t size) { return std::min(lag, size - lag) > nearest; };
    core.parallel.for_each_index(power.height, [&](std::uint32_t y) {
        for (std::size_t x = 0; x < power.width; ++x)
            if (far(x, power.width) || far(y, power.height))
                peaks[y] = std::max(peaks[y], plane[std::size_t{y} * power.width + x]);
    });
    return plane[0] > 0 ? static_cast<double>(*std::max_element(peaks.begin(), peaks.end()) / plane[0]) : 0;
}

} // namespace

double repetition(Core& core, const Pair& pair, std::uint64_t seed, const Progress& progress)
{
    const Domain domain(pair);
    const std::uint32_t side = std::min(pair.exemplar.width, pair.exemplar.height);
    const std::uint32_t nearest = std::min(nearest_lag, side / 2);
    if (!pair.exemplar_varies || !pair.output_varies || pair.output.area() < 4 * pair.exemplar.area()) return undefined;

    const PlaneTransform transform(core, domain.width, domain.height);
    const double zero[most_channels] = {}; // the exemplar's mean in a pair
    Array<float> plane(&core.memory, std::size_t{domain.width} * domain.height, Array<float>::unset);
    Spectra output = power_of(core, transform, pair.output, pair.output_mean, domain, progress.part(0, 0.25));
    const double peak = highest_peak(core, transform, output, nearest, plane);
    const Spectra exemplar = power_of(core, transform, pair.exemplar, zero, domain, progress.part(0.25, 0.5));
    double gaussian = 0;
    for (std::uint32_t k = 0; k < realisations; ++k) {
        randomise(core, exemplar, mix_bits(seed + k), output);
        gaussian = std::max(gaussian, highest_peak(core, transform, output, nearest, plane));
        progress.at(0.5 + 0.5 * (k + 1.0) / realisations);
    }
    return gaussian > 0 ? peak / gaussian : undefined;
}

} // namespace weft
