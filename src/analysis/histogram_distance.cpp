/// Sliced Wasserstein distance of the colours (Bonneel, Rabin, Peyre, Pfister 2015), in standard deviations of the
/// exemplar.
#include "analysis/compare_metrics.h"
#include "analysis/wasserstein.h"
#include <cmath>

namespace weft {
namespace {

constexpr std::uint32_t colour_directions = 64;
constexpr std::uint64_t most_pixels = 1u << 17; // the distance of two such samples of one law is about 0.003

/// The sampled pixels, plane by plane.
struct Colours {
    Colours(Core& core, const Planes& planes, std::uint64_t seed)
        : sample(planes.area(), most_pixels, seed),
          values(&core.memory, sample.size() * planes.count, Array<float>::unset)
    {
        core.parallel.for_each_index(planes.count, [&](std::uint32_t c) {
            for (std::size_t i = 0; i < sample.size(); ++i) values[c * sample.size() + i] = planes.plane(c)[sample[i]];
        });
    }
    /// Each pixel's component along `direction`, sorted.
    Array<float> along(Core& core, const float* direction) const
    {
        const std::size_t size = sample.size();
        Array<float> result(&core.memory, size), scratch(&core.memory, size, Array<float>::unset);
        for (std::size_t c = 0; c < values.size() / size; ++c)
            for (std::size_t i = 0; i < size; ++i) result[i] += direction[c] * values[c * size + i];
        sort_floats(result.data(), scratch.data(), size);
        return result;
    }

    Sample sample;
    Array<float> values;
};

double deviation_of(const Array<float>& values) noexcept
{
    double sum = 0, squares = 0;
    for (const float value : values) sum += static_cast<double>(value);
    const double mean = sum / static_cast<double>(values.size());
    for (const float value : values)
        squares += (static_cast<double>(value) - mean) * (static_cast<double>(value) - mean);
    return std::sqrt(squares / static_cast<double>(values.size()));
}

void unit_direction(std::uint64_t seed, std::uint32_t index, std::uint32_t size, float* direction) noexcept
{
    double square = 0;
    for (std::uint32_t c = 0; c < size; ++c) {
        direction[c] = normal_pair(seed, index * most_channels + c).real();
        square += static_cast<double>(direction[c]) * static_cast<double>(direction[c]);
    }
    for (std::uint32_t c = 0; c < size; ++c)
        direction[c] = static_cast<float>(static_cast<double>(direction[c]) / std::sqrt(square));
}

} // namespace

double histogram_distance(Core& core, const Pair& pair, std::uint64_t seed, const Progress& progress)
{
    if (!pair.exemplar_varies) return undefined;
    const std::uint32_t directions = pair.channels() == 1 ? 1 : colour_directions;
    const Colours exemplar(core, pair.exemplar, seed), output(core, pair.output, seed);
    double distance[colour_directions] = {}, deviation[colour_directions] = {};
    const double cost = 20.0 * static_cast<double>(exemplar.sample.size() + output.sample.size());
    for_each_step(core, directions, cost, progress, [&](std::uint32_t i) {
        float direction[most_channels];
        unit_direction(seed, i, pair.channels(), direction);
        const Array<float> a = exemplar.along(core, direction), b = output.along(core, direction);
        distance[i] = wasserstein_distance(a.data(), a.size(), b.data(), b.size());
        deviation[i] = deviation_of(a);
    });
    double distances = 0, deviations = 0;
    for (std::uint32_t i = 0; i < directions; ++i) distances += distance[i], deviations += deviation[i];
    return deviations > 0 ? distances / deviations : undefined;
}

} // namespace weft
