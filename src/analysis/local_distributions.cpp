/// Soft counts by cell, and their blur.
#include "analysis/compare_pair.h"
#include "analysis/neighbourhoods.h"
#include <algorithm>

namespace weft {
namespace {

void count_row(const float* values, std::uint32_t width, std::uint32_t columns, const Local_distributions::Range& range,
               float* bins) noexcept
{
    std::uint32_t x = 0;
    for (std::uint32_t column = 0; column < columns; ++column, bins += local_bins) {
        const auto end = static_cast<std::uint32_t>(std::uint64_t{column + 1} * width / columns);
        for (; x < end; ++x) {
            const float at = (values[x] - range.low) * range.scale;
            const std::uint32_t bin = std::min(static_cast<std::uint32_t>(at), local_bins - 2);
            const float fraction = at - static_cast<float>(bin);
            bins[bin] += 1 - fraction;
            bins[bin + 1] += fraction;
        }
    }
}

void normalise(float* bins) noexcept
{
    float sum = 0;
    for (std::uint32_t b = 0; b < local_bins; ++b) sum += bins[b];
    for (std::uint32_t b = 0; b < local_bins; ++b) bins[b] /= sum;
}

} // namespace

Local_distributions::Local_distributions(Core& core, const Planes& planes, const Neighbourhoods& around,
                                         const Progress& progress)
    : ranges(&core.memory, planes.count), whole(&core.memory, std::size_t{planes.count} * local_bins),
      local(&core.memory, planes.count * around.cells() * local_bins)
{
    for_each_step(core, planes.count, static_cast<double>(planes.area()), progress.part(0, 0.1), [&](std::uint32_t c) {
        const float* plane = planes.plane(c);
        float low = plane[0], high = plane[0];
        for (std::size_t i = 0; i < planes.area(); ++i) {
            low = plane[i] < low ? plane[i] : low;
            high = plane[i] > high ? plane[i] : high;
        }
        ranges[c] = {low, high > low ? static_cast<float>(local_bins - 1) / (high - low) : 1};
    });
    const std::uint32_t rows = around.rows();
    const std::size_t line = std::size_t{around.columns()} * local_bins;
    const double cost = 8.0 * static_cast<double>(planes.area()) / rows;
    for_each_step(core, planes.count * rows, cost, progress.part(0.1, 0.4), [&](std::uint32_t task) {
        const std::uint32_t plane = task / rows, row = task % rows;
        const std::size_t first = std::size_t{row} * planes.height / rows;
        for (std::size_t y = first; y < std::size_t{row + 1} * planes.height / rows; ++y)
            count_row(planes.row(plane, y), planes.width, around.columns(), ranges[plane], local.data() + task * line);
    });
    for (std::uint32_t c = 0; c < planes.count; ++c) {
        for (std::size_t cell = 0; cell < around.cells(); ++cell)
            for (std::uint32_t b = 0; b < local_bins; ++b)
                whole[c * local_bins + b] += local[(c * around.cells() + cell) * local_bins + b];
        normalise(whole.data() + c * local_bins);
    }
    around.average(core, local, local_bins, progress.part(0.4, 0.9));
    const auto cells = static_cast<std::uint32_t>(around.cells());
    for_each_step(core, planes.count, 2.0 * cells * local_bins, progress.part(0.9, 1), [&](std::uint32_t c) {
        for (std::size_t cell = 0; cell < cells; ++cell) normalise(local.data() + (c * cells + cell) * local_bins);
    });
}

} // namespace weft
