/// Along rows first, for a few rows at a time, then along columns.
#include "analysis/local_sums.h"
#include "base/elementary.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr std::uint32_t rows_at_once = 64;

/// Row i: the weight at each of `places` of pixel i of `size`; each place's weights sum up to 1.
Array<double> axis_weights(std::pmr::memory_resource* memory, std::uint32_t size, std::uint32_t places, double sigma)
{
    Array<double> weights(memory, std::size_t{size} * places, Array<double>::unset);
    for (std::uint32_t place = 0; place < places; ++place) {
        const double middle = (place + 0.5) * size / places;
        double sum = 0;
        for (std::uint32_t i = 0; i < size; ++i) {
            const double straight = std::abs(i + 0.5 - middle), distance = std::min(straight, size - straight) / sigma;
            const double exponent = 0.5 * distance * distance;
            double& weight = weights[std::size_t{i} * places + place];
            weight = exponent < 700 ? exponential_of_minus(exponent) : 0.0;
            sum += weight;
        }
        for (std::uint32_t i = 0; i < size; ++i) weights[std::size_t{i} * places + place] /= sum;
    }
    return weights;
}

void add_scaled(double* to, const double* from, double factor, std::size_t count) noexcept
{
    for (std::size_t i = 0; i < count; ++i) to[i] += factor * from[i];
}

} // namespace

Array<double> local_sums(Core& core, const float* plane, std::uint32_t width, std::uint32_t height,
                         const Local_grid& grid, double sigma, std::uint32_t sums,
                         const std::function<Share(float)>& share_of, const Progress& progress)
{
    const Array<double> across = axis_weights(&core.memory, width, grid.columns, sigma),
                        down = axis_weights(&core.memory, height, grid.rows, sigma);
    const std::size_t row_size = std::size_t{sums} * grid.columns;
    Array<double> by_sum(&core.memory, row_size * grid.rows), rows(&core.memory, row_size * rows_at_once);
    for (std::uint32_t first = 0; first < height; first += rows_at_once) {
        const std::uint32_t count = std::min(rows_at_once, height - first);
        core.parallel.for_each_index(count, [&](std::uint32_t y) {
            double* row = &rows[row_size * y];
            std::fill_n(row, row_size, 0.0);
            for (std::uint32_t x = 0; x < width; ++x) {
                const Share share = share_of(plane[std::size_t{first + y} * width + x]);
                for (std::uint32_t k = 0; k < share.count; ++k)
                    add_scaled(row + std::size_t{share.index[k]} * grid.columns, &across[std::size_t{x} * grid.columns],
                               share.amount[k], grid.columns);
            }
        });
        core.parallel.for_each_index(grid.rows, [&](std::uint32_t place) {
            for (std::uint32_t y = 0; y < count; ++y)
                add_scaled(&by_sum[row_size * place], &rows[row_size * y],
                           down[std::size_t{first + y} * grid.rows + place], row_size);
        });
        progress.at(static_cast<double>(first + count) / height);
    }
    Array<double> result(&core.memory, by_sum.size(), Array<double>::unset);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const std::size_t k = i % sums, position = i / sums, row = position / grid.columns,
                          column = position % grid.columns;
        result[i] = by_sum[row * row_size + k * grid.columns + column];
    }
    return result;
}

} // namespace weft
