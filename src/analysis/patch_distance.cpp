/// Sliced Wasserstein distance of whitened patches, at one dyadic level.
#include "analysis/compare_metrics.h"
#include "analysis/patches.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr std::uint32_t patch_directions = 128, directions_at_once = 4;
constexpr std::uint64_t least_patches = 64;   // more than the components, so that whitening is possible
constexpr double least_variance = 1e-4;       // of a principal channel, relative to the first
constexpr std::size_t patches_at_once = 1024; // 49 rows of them stay in the second-level cache

/// Components of all patches along directions_at_once directions, each run sorted.
Array<float> project(Core& core, const Patches& patches, const float* directions)
{
    Array<float> result(&core.memory, directions_at_once * patches.count),
        scratch(&core.memory, patches.count, Array<float>::unset);
    for (std::size_t first = 0; first < patches.count; first += patches_at_once) {
        const std::size_t size = std::min(patches_at_once, patches.count - first);
        for (std::size_t d = 0; d < directions_at_once; ++d) {
            float* sums = result.data() + d * patches.count + first;
            for (std::size_t k = 0; k < patch_size; ++k) {
                const float weight = directions[d * patch_size + k];
                const float* row = patches.row(k) + first;
                for (std::size_t i = 0; i < size; ++i) sums[i] += weight * row[i];
            }
        }
    }
    for (std::size_t d = 0; d < directions_at_once; ++d)
        sort_floats(result.data() + d * patches.count, scratch.data(), patches.count);
    return result;
}

double channel_distance(Core& core, const Pair& pair, std::uint32_t channel, std::uint32_t level, std::uint64_t seed,
                        const Progress& progress)
{
    const Patches a = sample_patches(core, pair.exemplar, channel, level, seed, progress.part(0, 0.1));
    const Patches b = sample_patches(core, pair.output, channel, level, seed, progress.part(0.1, 0.2));
    const Array<float> directions =
        white_directions(core, a, patch_directions, mix_bits(seed), progress.part(0.2, 0.4));
    if (directions.empty()) return 0;
    double distance[patch_directions] = {};
    const double cost = directions_at_once * 80.0 * static_cast<double>(a.count + b.count);
    for_each_step(core, patch_directions / directions_at_once, cost, progress.part(0.4, 1), [&](std::uint32_t run) {
        const float* own = directions.data() + run * directions_at_once * patch_size;
        const Array<float> u = project(core, a, own), v = project(core, b, own);
        for (std::size_t d = 0; d < directions_at_once; ++d)
            distance[run * directions_at_once + d] =
                wasserstein_distance(u.data() + d * a.count, a.count, v.data() + d * b.count, b.count);
    });
    double sum = 0;
    for (const double each : distance) sum += each;
    return sum / patch_directions;
}

} // namespace

double patch_distance(Core& core, const Pair& pair, std::uint32_t level, std::uint64_t seed, const Progress& progress)
{
    const std::uint64_t least = std::min(patches_in(pair.exemplar, level), patches_in(pair.output, level));
    if (!pair.exemplar_varies || least < least_patches) return undefined;
    std::uint32_t channels = 0;
    while (channels < pair.channels() && pair.variance[channels] >= least_variance * pair.variance[0]) ++channels;
    double distance = 0, weight = 0;
    for (std::uint32_t c = 0; c < channels; ++c) {
        const double begin = static_cast<double>(c) / channels, end = static_cast<double>(c + 1) / channels;
        const double deviation = std::sqrt(pair.variance[c]);
        const std::uint64_t own = mix_bits(seed ^ (level * most_channels + c));
        distance += deviation * channel_distance(core, pair, c, level, own, progress.part(begin, end));
        weight += deviation;
    }
    return distance / weight;
}

} // namespace weft
