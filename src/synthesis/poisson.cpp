/// Poisson thresholds, by the recurrence of the probabilities.
#include "synthesis/poisson.h"
#include "base/elementary.h"
#include <cmath>

namespace weft {

Array<std::uint32_t> poisson_thresholds(std::pmr::memory_resource* memory, double mean)
{
    constexpr std::uint32_t most = 255;
    constexpr double scale = 4294967296.0;
    std::uint32_t thresholds[most], count = 0;
    double probability = exponential_of_minus(mean), sum = probability;
    while (count < most) {
        const double threshold = std::floor(sum * scale + 0.5);
        if (threshold >= scale) break;
        thresholds[count++] = static_cast<std::uint32_t>(threshold);
        probability = probability * mean / count;
        sum += probability;
    }
    if (count == 0) thresholds[count++] = UINT32_MAX;
    Array<std::uint32_t> result(memory, count, Array<std::uint32_t>::unset);
    for (std::uint32_t i = 0; i < count; ++i) result[i] = thresholds[i];
    return result;
}

std::uint32_t choose_cell_log2(double rate, double width, double height, std::uint32_t period_x,
                               std::uint32_t period_y) noexcept
{
    constexpr double cell_cost = 2; // in impacts: measured on points, which visit every cell within reach
    std::uint32_t best = 0;
    double least = 0;
    for (std::uint32_t log2 = 0; log2 <= 15; ++log2) {
        const double edge = static_cast<double>(1U << log2);
        if (log2 > 0 && rate * edge * edge > most_mean) break;
        if ((period_x != 0 && edge >= 2.0 * period_x) || (period_y != 0 && edge >= 2.0 * period_y)) break;
        const double area = (width + edge) * (height + edge), cost = cell_cost * area / (edge * edge) + area * rate;
        if (log2 == 0 || cost < least) {
            best = log2;
            least = cost;
        }
    }
    return best;
}

std::uint32_t choose_cell_log2_in_space(double rate, double side) noexcept
{
    constexpr double cell_cost = 2, diagonal = 1.7320508075688772;
    std::uint32_t best = 0;
    double least = 0;
    for (std::uint32_t log2 = 0; log2 <= 15; ++log2) {
        const double edge = static_cast<double>(1U << log2), reach = diagonal * side + edge;
        if (log2 > 0 && rate * edge * edge * edge > most_mean) break;
        const double volume = reach * reach * reach, cost = cell_cost * volume / (edge * edge * edge) + volume * rate;
        if (log2 == 0 || cost < least) {
            best = log2;
            least = cost;
        }
    }
    return best;
}

} // namespace weft
