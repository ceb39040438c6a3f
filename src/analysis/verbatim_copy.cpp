/// How often neighbouring windows of an output have neighbouring nearest windows in the exemplar.
#include "analysis/compare_metrics.h"
#include "analysis/white_noise.h"
#include "analysis/window_search.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr double most_windows = 500; // its standard error is then below 0.022
constexpr double least_windows = 64, most_comparisons = 0x1p28;

} // namespace

double verbatim_copy(Core& core, const Pair& pair, std::uint64_t seed, const Progress& progress)
{
    const bool constant = pair.output_variance[0] <= 1e-12 * pair.variance[0];
    if (!pair.exemplar_varies || constant) return undefined;
    const double places = static_cast<double>(pair.exemplar.area());
    const auto count = static_cast<std::uint32_t>(std::clamp(most_comparisons / places, least_windows, most_windows));
    const std::uint64_t across = pair.output.width - window_side, down = pair.output.height - window_side + 1;

    Array<Window> left(&core.memory, count), right(&core.memory, count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint64_t x = mix_bits(mix_bits(seed) ^ (2 * i)) % across,
                            y = mix_bits(mix_bits(seed) ^ (2 * i + 1)) % down;
        left[i] = window_at(pair.output, x, y);
        right[i] = window_at(pair.output, x + 1, y);
    }
    find_nearest(core, pair.exemplar, left.data(), count, progress.part(0, 0.5));
    for (std::uint32_t i = 0; i < count; ++i) expect(pair.exemplar, right[i], left[i].nearest_x + 1, left[i].nearest_y);
    find_nearest(core, pair.exemplar, right.data(), count, progress.part(0.5, 1));
    std::uint32_t coherent = 0;
    for (std::uint32_t i = 0; i < count; ++i)
        coherent += right[i].nearest_x == left[i].nearest_x + 1 && right[i].nearest_y == left[i].nearest_y ? 1 : 0;
    return static_cast<double>(coherent) / count;
}

} // namespace weft
