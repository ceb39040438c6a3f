/// Patches of neighbours lie side by side in the map, as a rule: such a run adds each of the map's values once, times
/// the number of patches that it lies in.
#include "model/correspondence.h"
#include <algorithm>
#include <functional>

namespace weft {

namespace {

/// Adds rows of `patch` values, the first at `values` and the last `length` - 1 places on, each to where it lies.
void add_run(const float* values, std::size_t length, std::size_t patch, double* sums) noexcept
{
    const std::size_t count = length + patch - 1, most = std::min(length, patch);
    for (std::size_t i = 0; i < most - 1; ++i) {
        sums[i] += static_cast<double>(i + 1) * static_cast<double>(values[i]);
        sums[count - 1 - i] += static_cast<double>(i + 1) * static_cast<double>(values[count - 1 - i]);
    }
    const auto all = static_cast<double>(most);
    for (std::size_t i = most - 1; i < count - (most - 1); ++i) sums[i] += all * static_cast<double>(values[i]);
}

/// One row of one plane of the tile: `sums` has `reach` places before and after it, which belong to the other end.
void assemble_row(const Planes& map, const Correspondence& from, std::uint32_t c, std::uint32_t y, Planes& tile,
                  double* sums)
{
    const std::size_t width = tile.width, reach = from.reach(), patch = from.patch;
    std::fill_n(sums, width + 2 * reach, 0.0);
    for (std::size_t row = 0; row < patch; ++row) {
        const std::size_t middle = (std::size_t{y} + std::size_t{tile.height} * patch + reach - row) % tile.height;
        const std::uint16_t *xs = &from.x[middle * width], *ys = &from.y[middle * width];
        for (std::size_t begin = 0, end = 0; begin < width; begin = end) {
            for (end = begin + 1; end < width; ++end)
                if (ys[end] != ys[begin] || xs[end] != xs[begin] + (end - begin)) break;
            add_run(map.row(c, ys[begin] + row - reach) + (xs[begin] - reach), end - begin, patch, sums + begin);
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
                std::pmr::memory_resource* memory, Parallel& parallel, const Progress& progress)
{
    Planes tile(memory, width, height, map.count, Array<float>::unset);
    const std::uint32_t rows = height * map.count, step = std::max(1U, 4096U / width), tasks = (rows + step - 1) / step;
    const auto work = [&](std::uint32_t task) {
        Array<double> sums(memory, std::size_t{width} + 2 * correspondence.reach(), Array<double>::unset);
        for (std::uint32_t row = task * step; row < std::min(rows, (task + 1) * step); ++row)
            assemble_row(map, correspondence, row / height, row % height, tile, sums.data());
    };
    const std::uint32_t batch = std::max(parallel.width(), 128U);
    for (std::uint32_t first = 0; first < tasks; first += batch) {
        const std::uint32_t count = std::min(batch, tasks - first);
        const auto work_from = [&](std::uint32_t task) { work(first + task); };
        parallel.for_each_index(count, std::ref(work_from));
        progress.at(static_cast<double>(first + count) / tasks);
    }
    return tile;
}

} // namespace weft
