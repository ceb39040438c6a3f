/// Photo -> target: centred, transformed, made periodic, weighted.
#include "analysis/target.h"
#include "analysis/periodic.h"
#include <cmath>

namespace weft {
namespace {

/// From the DFT of the periodic component to T, gathering the covariance of t on the way.
void weigh(Core& core, Target& target, const SplineSamples& samples)
{
    Spectra& spectra = target.spectra;
    const Array<float> b_x = spline_spectrum(&core.memory, samples, spectra.width, spectra.blocks() * fft_lanes);
    const Array<float> b_y = spline_spectrum(&core.memory, samples, spectra.height, spectra.height);
    const double pixels = static_cast<double>(spectra.width) * spectra.height;
    const float normal = static_cast<float>(1 / std::sqrt(pixels));
    Array<Matrix> parts(&core.memory, spectra.blocks());
    for (std::uint32_t c = 0; c < spectra.count; ++c) spectra.at(c, 0, 0) = 0;
    for_each_run(core.parallel, spectra.blocks(), [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t b = first; b < last; ++b) {
            Complex* block = spectra.block(b, 0);
            const auto each = [&](const auto& factor) {
                for (std::size_t i = 0; i < spectra.count * spectra.block_size(); ++i)
                    block[i] *= factor(i % fft_lanes, i / fft_lanes % spectra.height);
            };
            each([&](std::size_t, std::size_t) { return normal; });
            parts[b] = block_covariance(spectra, b, block, 1 / pixels);
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
    return trace * spectra.width * spectra.height;
}

Target make_target(Core& core, Planes planes, const SplineSamples& samples, const Progress& progress)
{
    Target target;
    target.centring = centre(core, planes);
    target.spectra = Spectra(&core.memory, planes.width, planes.height, planes.count);
    const PlaneTransform transform(core, planes.width, planes.height);
    const std::uint32_t count = planes.count;
    const double steps = count + 2.0;
    for (std::uint32_t c = 0; c < count; ++c) {
        progress.at(c / steps);
        transform.forward(planes.plane(c), target.spectra, c);
    }
    progress.at(count / steps);
    keep_periodic_component(core, planes, target.spectra);
    planes = Planes();
    progress.at((count + 1) / steps);
    weigh(core, target, samples);
    progress.at(1);
    return target;
}

} // namespace weft
