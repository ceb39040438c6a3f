/// Structure and masks as they are in the exemplar, noises by their textons: where masks blend, noises are correlated,
/// as they share impacts.
#include "model/statistics.h"
#include "model/tone.h"
#include <algorithm>
#include <cmath>

namespace weft {

namespace {

/// What noise k has on the axis of channel o, before tone curves: a texton per channel of the result.
Planes in_channels(const Noise& noise, std::uint32_t channels, std::pmr::memory_resource* memory)
{
    const Planes& alpha = noise.coefficients;
    Planes result(memory, alpha.width, alpha.height, channels);
    for (std::uint32_t o = 0; o < channels; ++o)
        for (std::size_t i = 0; i < alpha.area(); ++i) {
            double sum = 0;
            for (std::uint32_t p = 0; p < channels; ++p)
                sum += static_cast<double>(noise.axes[p][o]) * static_cast<double>(alpha.plane(p)[i]);
            result.plane(o)[i] = static_cast<float>(sum);
        }
    return result;
}

using Channels = std::array<double, most_channels>;

/// Mean and variance of one noise alone.
struct Moments {
    Channels mean{}, variance{};
};

Moments moments_of(const Noise& noise, std::uint32_t channels, std::pmr::memory_resource* memory, Parallel& parallel)
{
    Moments moments;
    for (std::uint32_t o = 0; o < channels; ++o) moments.mean[o] = static_cast<double>(noise.mean[o]);
    if (noise.knots == 0) {
        moments.variance = texton_variance(in_channels(noise, channels, memory), channels, 2, memory, parallel);
        return moments;
    }
    const Channels power = texton_variance(noise.coefficients, channels, 2, memory, parallel);
    for (std::uint32_t p = 0; p < channels; ++p) {
        const Tone_moments tone = tone_moments(noise, p, power[p]);
        for (std::uint32_t o = 0; o < channels; ++o) {
            const double axis = static_cast<double>(noise.axes[p][o]);
            moments.mean[o] += axis * tone.mean;
            moments.variance[o] += axis * axis * tone.variance;
        }
    }
    return moments;
}

/// Covariance of two noises at one position, without their tone curves.
Channels covariance_of(const Noise& a, const Noise& b, const Moments& of_a, const Moments& of_b, std::uint32_t channels,
                       std::pmr::memory_resource* memory, Parallel& parallel)
{
    Channels result{};
    if (a.knots != 0 || b.knots != 0 || a.coefficients.width != b.coefficients.width ||
        a.coefficients.height != b.coefficients.height)
        return result;
    Planes sum = in_channels(a, channels, memory);
    const Planes other = in_channels(b, channels, memory);
    for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += other.values[i];
    result = texton_variance(sum, channels, 2, memory, parallel);
    for (std::uint32_t o = 0; o < channels; ++o) result[o] = (result[o] - of_a.variance[o] - of_b.variance[o]) / 2;
    return result;
}

/// P with the means of the noises under their masks, at one texel.
double expected_at(const Model& model, const Moments* moments, std::uint32_t o, std::size_t i) noexcept
{
    const Bilayer& bilayer = model.bilayer;
    const std::uint32_t first = bilayer.plain != 0 ? 0 : model.channels;
    double value = static_cast<double>(bilayer.plain != 0 ? model.mean[o] : bilayer.structure.plane(o)[i]);
    for (std::uint32_t k = first; k < bilayer.structure.count; ++k)
        value += static_cast<double>(bilayer.structure.plane(k)[i]) * moments[k - first].mean[o];
    return value;
}

double mean_product(const Planes& planes, std::uint32_t a, std::uint32_t b) noexcept
{
    double sum = 0;
    for (std::size_t i = 0; i < planes.area(); ++i)
        sum += static_cast<double>(planes.plane(a)[i]) * static_cast<double>(planes.plane(b)[i]);
    return sum / static_cast<double>(planes.area());
}

} // namespace

Statistics bilayer_statistics(const Model& model, std::pmr::memory_resource* memory, Parallel& parallel)
{
    const Bilayer& bilayer = model.bilayer;
    const auto noises = static_cast<std::uint32_t>(bilayer.noises.size());
    const std::uint32_t channels = model.channels, first = bilayer.structure.count - noises;
    const auto area = static_cast<double>(bilayer.structure.area());
    Moments moments[most_noises];
    for (std::uint32_t k = 0; k < noises; ++k) moments[k] = moments_of(bilayer.noises[k], channels, memory, parallel);
    Channels variance{};
    for (std::uint32_t k = 0; k < noises; ++k)
        for (std::uint32_t l = k; l < noises; ++l) {
            const double weight = mean_product(bilayer.structure, first + k, first + l) * (k == l ? 1 : 2);
            if (weight == 0) continue;
            const Channels covariance = k == l ? moments[k].variance
                                               : covariance_of(bilayer.noises[k], bilayer.noises[l], moments[k],
                                                               moments[l], channels, memory, parallel);
            for (std::uint32_t o = 0; o < channels; ++o) variance[o] += weight * covariance[o];
        }
    Statistics result;
    for (std::uint32_t o = 0; o < channels; ++o) {
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < bilayer.structure.area(); ++i) sum += expected_at(model, moments, o, i);
        const double mean = sum / area;
        for (std::size_t i = 0; i < bilayer.structure.area(); ++i) {
            const double difference = expected_at(model, moments, o, i) - mean;
            squares += difference * difference;
        }
        result.mean[o] = static_cast<float>(mean);
        result.deviation[o] = static_cast<float>(std::sqrt(std::max(0.0, variance[o] + squares / area)));
    }
    return result;
}

} // namespace weft
