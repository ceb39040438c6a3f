/// Starts on a sample of the pixels, the best of them refined on a larger one.
#include "analysis/clusters.h"
#include "analysis/cluster_count.h"
#include "analysis/kmeans.h"
#include "analysis/wasserstein.h"
#include "base/hash.h"
#include <algorithm>

namespace weft {
namespace {

constexpr std::uint32_t first_points = 1U << 12, most_points = 1U << 14;
constexpr std::uint32_t most_rounds = 100;

Points points_of(Core& core, const Local_spectra& spectra, std::uint32_t most, std::uint64_t seed)
{
    const Sample sample(std::uint64_t{spectra.width} * spectra.height, most, seed);
    Points points(&core.memory, static_cast<std::uint32_t>(sample.size()), spectra.size);
    for (std::size_t point = 0; point < points.blocks() * std::size_t{Points::lanes}; ++point) {
        const std::uint64_t pixel = sample[std::min<std::uint64_t>(point, points.count - 1)];
        for (std::uint32_t i = 0; i < spectra.size; ++i)
            points.at(point, i) = spectra.row(pixel / spectra.width, i)[pixel % spectra.width];
    }
    return points;
}

/// Those that have points, the largest first.
Clusters sorted(Core& core, const Means& means, std::uint32_t size)
{
    std::uint32_t order[most_clusters];
    Clusters clusters;
    clusters.size = size;
    for (std::uint32_t k = 0; k < means.count; ++k)
        if (means.members[k] > 0) order[clusters.count++] = k;
    std::stable_sort(order, order + clusters.count,
                     [&](std::uint32_t a, std::uint32_t b) { return means.members[a] > means.members[b]; });
    clusters.centres = Array<float>(&core.memory, std::size_t{clusters.count} * size);
    for (std::size_t k = 0; k < clusters.count; ++k)
        std::copy_n(means.centres.data() + std::size_t{order[k]} * size, size, clusters.centres.data() + k * size);
    return clusters;
}

} // namespace

Clusters find_clusters(Core& core, const Local_spectra& spectra, std::uint32_t count, std::uint64_t seed,
                       const Progress& progress)
{
    progress.at(0);
    const Points first = points_of(core, spectra, first_points, mix_in(seed, 0));
    if (count == 0) count = cluster_count(core, first, most_clusters, mix_in(seed, 1), progress.part(0.1, 0.4));
    Means best = best_means(core, first, count, mix_in(seed, 2), progress.part(0.4, 0.7));
    const Points points = points_of(core, spectra, most_points, mix_in(seed, 3));
    refine_means(core, points, most_rounds, best, progress.part(0.75, 1));
    return sorted(core, best, spectra.size);
}

} // namespace weft
