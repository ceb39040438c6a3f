/// A cluster's pixels along their principal axes; the spectrum of each axis; a texton that has it.
#include "analysis/noise_learning.h"
#include "analysis/principal_axes.h"
#include "analysis/texton_fit.h"
#include "analysis/tone_curve.h"
#include "base/hash.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr double share_of_region = 0.9;  // the paper's
constexpr double rank_tolerance = 1e-10; // of an axis's variance: float's rounding, squared, is below
constexpr std::uint32_t knots = 10, taps = 2;
constexpr std::uint32_t iterations =
    50; // twice as many lower the model error from 0.16 to 0.13, below that of the spectrum itself

/// The cluster's pixels less their mean, 0 elsewhere, and that mean.
Planes masked(Core& core, const Planes& residual, const Regions& regions, std::uint32_t k, double* mean)
{
    Planes planes(&core.memory, residual.width, residual.height, residual.count);
    for (std::size_t c = 0; c < residual.count; ++c) {
        const float* from = residual.plane(c);
        double sum = 0, members = 0;
        for (std::size_t i = 0; i < residual.area(); ++i)
            if (regions.nearest[i] == k) {
                sum += static_cast<double>(from[i]);
                members += 1;
            }
        mean[c] = members > 0 ? sum / members : 0;
        for (std::size_t i = 0; i < residual.area(); ++i)
            planes.plane(c)[i] =
                regions.nearest[i] == k ? static_cast<float>(static_cast<double>(from[i]) - mean[c]) : 0.0F;
    }
    return planes;
}

/// Gives the cluster's pixels the scores of their ranks, and the noise the tone curve that undoes it.
void equalize(Core& core, const Regions& regions, std::uint32_t k, double unit, double before, double after,
              std::uint32_t axis, float* plane, Noise& noise)
{
    const std::size_t pixels = regions.nearest.size();
    Array<float> members(&core.memory, pixels, Array<float>::unset);
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixels; ++i)
        if (regions.nearest[i] == k) members[count++] = plane[i];
    const Normal_scores scores(core, members.data(), count);
    fit_tone_curve(scores, unit, before, after, axis, noise);
    scores.apply(core, members.data(), count, 1);
    count = 0;
    for (std::size_t i = 0; i < pixels; ++i)
        if (regions.nearest[i] == k) plane[i] = members[count++];
}

/// plane <- what of it is in the region, less its mean there, 0 elsewhere. False if that is 0.
bool confine(const Array<float>& region, float* plane) noexcept
{
    double sum = 0, members = 0, squares = 0;
    for (std::size_t i = 0; i < region.size(); ++i) {
        sum += static_cast<double>(region[i] * plane[i]);
        members += static_cast<double>(region[i]);
    }
    const auto mean = static_cast<float>(members > 0 ? sum / members : 0);
    for (std::size_t i = 0; i < region.size(); ++i) {
        plane[i] = region[i] * (plane[i] - mean);
        squares += static_cast<double>(plane[i]) * static_cast<double>(plane[i]);
    }
    return squares > 0;
}

/// A texton whose noise has the spectrum of `plane` in the region and unit variance. False if that is 0.
bool learn_texton(Core& core, const Array<float>& region, float* plane, std::uint64_t seed, Region_spectrum& spectrum,
                  Planes& texton, const Progress& progress)
{
    progress.at(0);
    if (!confine(region, plane)) return false;
    const SplineSamples samples = spline_samples(taps);
    const Target target = spectrum.target_of(plane, samples);
    progress.at(0.1);
    Projection projection(core, target.spectra, samples, texton.width);
    projection.start(seed, texton);
    fit_coefficients(core, projection, {iterations, true, true}, target, samples, texton, progress.part(0.1, 1));
    return true;
}

} // namespace

Noise learn_noise(Core& core, const Planes& residual, const Regions& regions, std::uint32_t k,
                  const Noise_choices& choices, Region_spectrum& spectrum, const Progress& progress)
{
    const std::uint32_t channels = residual.count, support = choices.support;
    progress.at(0);
    double mean[most_channels];
    const Planes planes = masked(core, residual, regions, k, mean);
    progress.at(0.03);
    const Principal_axes principal = principal_axes_of(core, planes);
    Array<float> region(&core.memory, residual.area());
    progress.at(0.05);
    nearest_share(core, regions, k, share_of_region, region);
    progress.at(0.07);
    spectrum.set_region(region.data());
    const auto members = static_cast<double>(std::count(regions.nearest.begin(), regions.nearest.end(), k));

    Noise noise;
    noise.knots = choices.equalize ? knots : 0;
    noise.coefficients = Planes(&core.memory, support, support, channels);
    double deviation[most_channels] = {}; // of what is before the tone curves
    Matrix unit;
    unit.size = channels;
    Planes plane(&core.memory, residual.width, residual.height, 1), texton(&core.memory, support, support, 1);
    for (std::uint32_t p = 0; p < channels; ++p) {
        noise.mean[p] = static_cast<float>(mean[p] / choices.scale);
        for (std::uint32_t o = 0; o < channels; ++o) noise.axes[p][o] = static_cast<float>(principal.axes[p][o]);
        set_flat_tone_curve(p, noise);
        const double variance = principal.variance[p] * static_cast<double>(residual.area()) / std::max(members, 1.0);
        const double after = std::sqrt(variance) / choices.scale;
        if (!(principal.variance[p] > rank_tolerance * principal.variance[0]) || !(after > 1e-36)) continue;
        const Progress share = progress.part(0.1 + 0.9 * p / channels, 0.1 + 0.9 * (p + 1) / channels);
        share.at(0);
        project_on_axis(core, planes, principal.axes, p, plane.plane(0));
        deviation[p] = choices.equalize ? std::clamp(after, 1e-3, 1e3) : after;
        if (choices.equalize) equalize(core, regions, k, choices.scale, deviation[p], after, p, plane.plane(0), noise);
        if (!learn_texton(core, region, plane.plane(0), mix_in(choices.seed, p), spectrum, texton, share.part(0.1, 1)))
            continue;
        std::copy(texton.values.begin(), texton.values.end(), noise.coefficients.plane(p));
        unit[p][p] = 1;
    }
    correct_colours(core, spline_samples(taps), unit, noise.coefficients);
    for (std::uint32_t p = 0; p < channels; ++p)
        for (std::size_t i = 0; i < noise.coefficients.area(); ++i)
            noise.coefficients.plane(p)[i] *= static_cast<float>(deviation[p]);
    return noise;
}

} // namespace weft
