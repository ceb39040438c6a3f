/// Which noise is where: nearest centres, convex weights, bands along borders.
#include "analysis/masks.h"
#include "analysis/spectra.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

/// Distances of a row's pixels to all centres: `to` has count rows of `width`.
void distances_of_row(const Local_spectra& spectra, const Clusters& clusters, std::uint32_t y, float* to) noexcept
{
    std::fill_n(to, std::size_t{clusters.count} * spectra.width, 0.0F);
    for (std::uint32_t i = 0; i < spectra.size; ++i) {
        const float* row = spectra.row(y, i);
        for (std::size_t k = 0; k < clusters.count; ++k) {
            const float centre = clusters.centre(k)[i];
            float* sum = to + k * spectra.width;
            for (std::uint32_t x = 0; x < spectra.width; ++x) sum[x] += (row[x] - centre) * (row[x] - centre);
        }
    }
    for (std::size_t x = 0; x < std::size_t{clusters.count} * spectra.width; ++x) to[x] = std::sqrt(to[x]);
}

void set_weights(const float* distance, std::uint32_t width, std::uint32_t x, std::uint32_t nearest, bool barycentric,
                 std::uint32_t y, Planes& masks) noexcept
{
    const float least = distance[std::size_t{nearest} * width + x];
    if (!barycentric || !(least > 0)) {
        masks.row(nearest, y)[x] = 1;
        return;
    }
    float sum = 0;
    for (std::size_t k = 0; k < masks.count; ++k) sum += least / distance[k * width + x];
    for (std::size_t k = 0; k < masks.count; ++k) masks.row(k, y)[x] = least / distance[k * width + x] / sum;
}

/// Whether a neighbour of the pixel belongs to another cluster.
bool is_edge(const Planes& masks, const std::uint8_t* nearest, std::size_t x, std::size_t y) noexcept
{
    const std::size_t width = masks.width, at = y * width + x;
    const std::uint8_t own = nearest[at];
    return (x > 0 && nearest[at - 1] != own) || (x + 1 < width && nearest[at + 1] != own) ||
           (y > 0 && nearest[at - width] != own) || (y + 1 < masks.height && nearest[at + width] != own);
}

/// For each pixel how many rows the next edge pixel of its column is away, or `border`.
Array<std::uint8_t> rows_to_edge(Core& core, std::uint32_t border, const Regions& regions)
{
    const std::uint32_t width = regions.masks.width, height = regions.masks.height;
    Array<std::uint8_t> rows(&core.memory, regions.masks.area(), Array<std::uint8_t>::unset);
    const auto most = static_cast<std::uint8_t>(border);
    for_each_run(core.parallel, width, [&](std::uint32_t first, std::uint32_t last) {
        const auto pass = [&](std::size_t y, std::size_t before) {
            for (std::size_t x = first; x < last; ++x) {
                std::uint8_t& here = rows[y * width + x];
                here = std::min<std::uint8_t>(here, static_cast<std::uint8_t>(rows[before * width + x] + 1));
            }
        };
        for (std::size_t y = 0; y < height; ++y) {
            for (std::size_t x = first; x < last; ++x)
                rows[y * width + x] = is_edge(regions.masks, regions.nearest.data(), x, y) ? 0 : most;
            if (y > 0) pass(y, y - 1);
        }
        for (std::size_t y = height - 1; y-- > 0;) pass(y, y + 1);
    });
    return rows;
}

} // namespace

Regions regions_of(Core& core, const Local_spectra& spectra, const Clusters& clusters, bool barycentric,
                   const Progress& progress)
{
    const std::uint32_t width = spectra.width, height = spectra.height;
    Regions regions;
    regions.masks = Planes(&core.memory, width, height, clusters.count);
    regions.nearest = Array<std::uint8_t>(&core.memory, regions.masks.area(), Array<std::uint8_t>::unset);
    regions.distance = Array<float>(&core.memory, regions.masks.area(), Array<float>::unset);
    const std::size_t work = std::size_t{width} * clusters.count * (spectra.size + 8);
    for_each_group(height, work, progress, [&](std::uint32_t begin, std::uint32_t end) {
        for_each_run(core.parallel, end - begin, [&](std::uint32_t first, std::uint32_t last) {
            Array<float> distance(&core.memory, std::size_t{clusters.count} * width, Array<float>::unset);
            for (std::uint32_t y = begin + first; y < begin + last; ++y) {
                distances_of_row(spectra, clusters, y, distance.data());
                for (std::uint32_t x = 0; x < width; ++x) {
                    std::uint32_t nearest = 0;
                    for (std::uint32_t k = 1; k < clusters.count; ++k)
                        if (distance[std::size_t{k} * width + x] < distance[std::size_t{nearest} * width + x])
                            nearest = k;
                    regions.nearest[std::size_t{y} * width + x] = static_cast<std::uint8_t>(nearest);
                    regions.distance[std::size_t{y} * width + x] = distance[std::size_t{nearest} * width + x];
                    set_weights(distance.data(), width, x, nearest, barycentric, y, regions.masks);
                }
            }
        });
    });
    return regions;
}

void clear_borders(Core& core, std::uint32_t border, Regions& regions, const Progress& progress)
{
    const std::uint32_t width = regions.masks.width, height = regions.masks.height;
    progress.at(0);
    const Array<std::uint8_t> rows = rows_to_edge(core, border, regions);
    for_each_group(height, std::size_t{width} * border * 4, progress, [&](std::uint32_t begin, std::uint32_t end) {
        core.parallel.for_each_index(end - begin, [&](std::uint32_t i) {
            const std::size_t y = begin + i;
            for (std::uint32_t x = 0; x < width; ++x) {
                const std::uint32_t left = x < border ? 0 : x - border + 1, right = std::min(x + border, width);
                bool near = false;
                for (std::uint32_t other = left; other < right && !near; ++other) {
                    const std::uint32_t across = other < x ? x - other : other - x, down = rows[y * width + other];
                    near = across * across + down * down < border * border;
                }
                if (!near) continue;
                regions.nearest[y * width + x] = no_cluster;
                for (std::size_t k = 0; k < regions.masks.count; ++k) regions.masks.row(k, y)[x] = 0;
            }
        });
    });
}

void nearest_share(Core& core, const Regions& regions, std::uint32_t k, double share, Array<float>& region)
{
    const std::size_t pixels = regions.nearest.size();
    std::size_t members = 0;
    for (std::size_t i = 0; i < pixels; ++i) members += regions.nearest[i] == k ? 1 : 0;
    Array<float> distances(&core.memory, members, Array<float>::unset);
    float* next = distances.data();
    for (std::size_t i = 0; i < pixels; ++i)
        if (regions.nearest[i] == k) *next++ = regions.distance[i];
    if (members == 0) return std::fill(region.begin(), region.end(), 0.0F);
    float* limit = distances.data() + static_cast<std::size_t>(share * static_cast<double>(members - 1));
    std::nth_element(distances.begin(), limit, distances.end());
    for (std::size_t i = 0; i < pixels; ++i)
        region[i] = regions.nearest[i] == k && regions.distance[i] <= *limit ? 1.0F : 0.0F;
}

} // namespace weft
