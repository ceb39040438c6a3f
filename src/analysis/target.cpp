/// Photo -> target: centred, transformed, made periodic, weighted.
#include "analysis/target.h"
#include "analysis/periodic.h"
#include "analysis/statistics.h"
#include <cmath>

namespace weft {
namespace {

/// Means into the target; planes <- (planes - mean) * scale.
void centre(Core& core, Planes& planes, Target& target)
{
    double deviation = 0;
    std::array<bool, most_channels> constant{};
    for (std::uint32_t c = 0; c < planes.count; ++c) {
        const ChannelStatistics channel = channel_statistics(core, planes.plane(c), planes.width, planes.height);
        target.mean[c] = channel.mean;
        constant[c] = channel.deviation == 0;
        deviation = std::max(deviation, channel.deviation);
    }
    if (deviation > 0) target.scale = std::ldexp(1.0, -std::ilogb(deviation));
    for_each_run(core.parallel, planes.count * planes.height, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t i = first; i < last; ++i) {
            float* row = planes.values.data() + std::size_t{i} * planes.width;
            const std::uint32_t c = i / planes.height;
            for (std::uint32_t x = 0; x < planes.width; ++x)
                row[x] = constant[c] ? 0.0f : static_cast<float>((static_cast<double>(row[x]) - target.mean[c]) * target.scale);
        }
    });
}

/// From the DFT of the periodic component to T, gathering the covariance of t on the way.
void weigh(Core& core, Target& target, const SplineSamples& samples)
{
    Spectra& spectra = target.spectra;
    const Array<float> b_x = spline_spectrum(&core.memory, samples, spectra.width, spectra.blocks() * fft_lanes);
    const Array<float> b_y = spline_spectrum(&core.memory, samples, spectra.height, spectra.height);
    const float root = std::sqrt(static_cast<float>(spectra.width) * static_cast<float>(spectra.height));
    Array<Matrix> parts(&core.memory, spectra.blocks());
    for (std::uint32_t c = 0; c < spectra.count; ++c) spectra.at(c, 0, 0) = 0;
    for_each_run(core.parallel, spectra.blocks(), [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t b = first; b < last; ++b) {
            Complex* block = spectra.block(b, 0);
            const auto each = [&](const auto& factor) {
                for (std::size_t i = 0; i < spectra.count * spectra.block_size(); ++i)
                    block[i] *= factor(i % fft_lanes, i / fft_lanes % spectra.height);
            };
            each([&](std::size_t, std::size_t) { return 1 / root; });
            parts[b] = block_covariance(spectra, b, block, [](std::uint32_t, std::uint32_t) { return 1.0; });
            each([&](std::size_t lane, std::size_t y) { return std::sqrt(b_x[b * fft_lanes + lane] * b_y[y]); });
        }
    });
    target.covariance = sum_of(parts, spectra.count);
}

} // namespace

double Target::power() const noexcept
{
    double trace = 0;
    for (std::uint32_t c = 0; c < covariance.size; ++c) trace += covariance[c][c];
    return trace;
}

Target make_target(Core& core, Planes planes, const SplineSamples& samples, const Progress& progress)
{
    Target target;
    centre(core, planes, target);
    target.spectra = Spectra(&core.memory, planes.width, planes.height, planes.count);
    const PlaneTransform transform(core, planes.width, planes.height);
    for (std::uint32_t c = 0; c < planes.count; ++c) {
        progress.at((c + 0.5) / (planes.count + 2));
        transform.forward(planes.plane(c), target.spectra, c);
    }
    progress.at(planes.count / (planes.count + 2.0));
    keep_periodic_component(core, planes, target.spectra);
    planes = Planes();
    progress.at((planes.count + 1.0) / (planes.count + 2));
    weigh(core, target, samples);
    progress.at(1);
    return target;
}

} // namespace weft
