/// Rows of patches are added as they lie in the map: eleven additions side by side in place of eleven look-ups.
#include "model/correspondence.h"
#include <algorithm>
#include <functional>

namespace weft {

namespace {

/// One row of one plane of the tile: `sums` has `reach` places before and after it, which belong to the other end.
void assemble_row(const Planes& map, const Correspondence& from, std::uint32_t c, std::uint32_t y, Planes& tile,
                  double* sums)
{
    const std::size_t width = tile.width, reach = from.reach(), patch = from.patch;
    std::fill_n(sums, width + 2 * reach, 0.0);
    for (std::size_t row = 0; row < patch; ++row) {
        const std::size_t middle = (std::size_t{y} + std::size_t{tile.height} * patch + reach - row) % tile.height;
        const std::uint16_t *xs = &from.x[middle * width], *ys = &from.y[middle * width];
        for (std::size_t x = 0; x < width; ++x) {
            const float* values = map.row(c, ys[x] + row - reach) + (xs[x] - reach);
            for (std::size_t i = 0; i < patch; ++i) sums[x + i] += static_cast<double>(values[i]);
        }
    }
    for (std::size_t i = 0; i < reach; ++i) { // a tile may be narrower than a patch
        sums[reach + (i + width * reach - reach) % width] += sums[i];
        sums[reach + i % width] += sums[reach + width + i];
    }
    float* to = tile.row(c, y);
    for (std::size_t x = 0; x < width; ++x)
        to[x] = static_cast<float>(sums[reach + x] / static_cast<double>(patch * patch));
}

} // namespace

Planes assemble(const Planes& map, const Correspondence& correspondence, std::uint32_t width, std::uint32_t height,
                std::pmr::memory_resource* memory, Parallel& parallel)
{
    Planes tile(memory, width, height, map.count, Array<float>::unset);
    const std::uint32_t rows = height * map.count, step = std::max(1U, 4096U / width), tasks = (rows + step - 1) / step;
    const auto work = [&](std::uint32_t task) {
        Array<double> sums(memory, std::size_t{width} + 2 * correspondence.reach(), Array<double>::unset);
        for (std::uint32_t row = task * step; row < std::min(rows, (task + 1) * step); ++row)
            assemble_row(map, correspondence, row / height, row % height, tile, sums.data());
    };
    parallel.for_each_index(tasks, std::ref(work));
    return tile;
}

} // namespace weft
