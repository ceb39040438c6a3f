/// Valleys between clusters, and what one more is worth.
#include "analysis/cluster_count.h"
#include "analysis/clusters.h"
#include "base/hash.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr double worthwhile = 0.65; // of the sum of squares may be left by one more cluster
constexpr double reach = 0.15;      // of the distance of two centres: what counts as at one, or midway
constexpr std::uint32_t starts = 6, rounds = 20;

/// Points at two centres and midway between them, along the line through them.
struct Valley {
    std::uint32_t at_first = 0, midway = 0, at_second = 0;
    void add(double place) noexcept
    {
        at_first += std::abs(place) < reach ? 1 : 0;
        midway += std::abs(place - 0.5) < reach ? 1 : 0;
        at_second += std::abs(place - 1) < reach ? 1 : 0;
    }
    bool parts() const noexcept { return midway < std::min(at_first, at_second); }
};

double product(const float* a, const float* b, const float* c, const float* d, std::uint32_t size) noexcept
{
    double sum = 0;
    for (std::uint32_t i = 0; i < size; ++i)
        sum += (static_cast<double>(a[i]) - static_cast<double>(b[i])) *
               (static_cast<double>(c[i]) - static_cast<double>(d[i]));
    return sum;
}

bool all_parted(Core& core, const Points& points, const Means& means)
{
    const std::uint32_t size = points.size, count = means.count;
    const auto centre = [&](std::size_t k) { return means.centres.data() + k * size; };
    Array<Valley> valleys(&core.memory, std::size_t{count} * count);
    Array<float> point(&core.memory, size);
    for (std::uint32_t i = 0; i < points.count; ++i) {
        for (std::uint32_t number = 0; number < size; ++number) point[number] = points.at(i, number);
        std::uint32_t nearest = 0;
        double squares[most_clusters];
        for (std::uint32_t k = 0; k < count; ++k) {
            squares[k] = product(point.data(), centre(k), point.data(), centre(k), size);
            if (squares[k] < squares[nearest]) nearest = k;
        }
        for (std::uint32_t k = 0; k < count; ++k) {
            if (k == nearest) continue;
            const std::uint32_t a = std::min(k, nearest), b = std::max(k, nearest);
            const double length = product(centre(a), centre(b), centre(a), centre(b), size);
            valleys[std::size_t{a} * count + b].add(0.5 + 0.5 * (squares[a] - squares[b]) / length);
        }
    }
    for (std::uint32_t a = 0; a < count; ++a)
        for (std::uint32_t b = a + 1; b < count; ++b)
            if (!valleys[std::size_t{a} * count + b].parts()) return false;
    return true;
}

} // namespace

Means best_means(Core& core, const Points& points, std::uint32_t count, std::uint64_t seed, const Progress& progress)
{
    Means best;
    for (std::uint32_t i = 0; i < starts; ++i) {
        Means means = spread_means(core, points, count, mix_in(seed, i));
        refine_means(core, points, rounds, means, progress.part(static_cast<double>(i) / starts, (i + 1.0) / starts));
        if (i == 0 || means.squares < best.squares) best = std::move(means);
    }
    return best;
}

std::uint32_t cluster_count(Core& core, const Points& points, std::uint32_t most, std::uint64_t seed,
                            const Progress& progress)
{
    double before = 0;
    bool worth = true;
    std::uint32_t result = 1;
    for (std::uint32_t count = 1; count <= most; ++count) {
        const Means means = best_means(core, points, count, seed,
                                       progress.part((count - 1.0) / most, static_cast<double>(count) / most));
        if (means.count < count) break; // no more points are different
        worth = worth && (count == 1 || means.squares < worthwhile * before);
        before = means.squares;
        if (count > 1 && (worth || all_parted(core, points, means))) result = count;
    }
    return result;
}

} // namespace weft
