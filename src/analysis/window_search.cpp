/// Nearest windows by projection: the distance of the lowest cosine coefficients bounds the distance from below
/// (Hel-Or and Hel-Or 2005), so that few windows are compared pixel by pixel, and none that could be nearest is missed.
#include "analysis/window_search.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace weft {
namespace {

constexpr std::size_t frequencies = 3; // along each axis
constexpr std::size_t places_at_once = 1u << 15, places_together = 256;
constexpr std::uint32_t windows_together = 16;
// A bound's own rounding shall rule nothing out; pixels are in standard deviations.
constexpr float bound_factor = 1 - 1e-4f, bound_slack = 1e-6f;
static_assert(frequencies * frequencies == window_features);

/// Orthonormal cosines of frequencies 0, 1, 2.
struct Cosines {
    float values[frequencies][window_side];

    Cosines() noexcept
    {
        const double side = window_side;
        for (std::size_t k = 0; k < frequencies; ++k)
            for (std::size_t i = 0; i < window_side; ++i)
                values[k][i] = static_cast<float>(
                    std::sqrt((k == 0 ? 1 : 2) / side) *
                    std::cos(3.141592653589793 * static_cast<double>(k) * (static_cast<double>(i) + 0.5) / side));
    }
};

/// Features of all windows that begin in some rows: feature after feature, place after place.
class Features {
public:
    Features(Core& core, const Planes& planes)
        : across(planes.width - window_side + 1), down(planes.height - window_side + 1),
          rows(std::max<std::size_t>(1, places_at_once / across)), memory_(&core.memory), planes_(planes),
          values_(memory_, window_features * rows * across, Array<float>::unset)
    {
    }
    const float* feature(std::size_t f) const noexcept { return values_.data() + f * rows * across; }

    void compute(Core& core, std::size_t first)
    {
        core.parallel.for_each_index(static_cast<std::uint32_t>(std::min(rows, down - first)), [&](std::uint32_t row) {
            Array<float> sums(memory_, frequencies * planes_.width);
            for (std::size_t k = 0; k < frequencies; ++k)
                for (std::size_t i = 0; i < window_side; ++i)
                    for (std::size_t x = 0; x < planes_.width; ++x)
                        sums[k * planes_.width + x] += cosines_.values[k][i] * planes_.row(0, first + row + i)[x];
            for (std::size_t f = 0; f < window_features; ++f) {
                const float* line = sums.data() + f / frequencies * planes_.width;
                float* result = values_.data() + (f * rows + row) * across;
                std::fill_n(result, across, 0.0f);
                for (std::size_t i = 0; i < window_side; ++i)
                    for (std::size_t x = 0; x < across; ++x)
                        result[x] += cosines_.values[f % frequencies][i] * line[x + i];
            }
        });
    }
    const std::size_t across, down, rows;

private:
    std::pmr::memory_resource* memory_;
    const Planes& planes_;
    const Cosines cosines_;
    Array<float> values_;
};

/// The squared distance, or anything not below `enough` once it is known to be that large.
float distance(const Planes& planes, const Window& window, std::size_t x, std::size_t y, float enough) noexcept
{
    float sum = 0;
    for (std::size_t j = 0; j < window_side && sum <= enough; ++j) {
        const float *a = planes.row(0, y + j) + x, *b = window.pixels + j * window_side;
        float line = 0;
        for (std::size_t i = 0; i < window_side; ++i) line += (a[i] - b[i]) * (a[i] - b[i]);
        sum += line;
    }
    return sum;
}

bool before(std::size_t x, std::size_t y, const Window& window) noexcept
{
    return y != window.nearest_y ? y < window.nearest_y : x < window.nearest_x;
}

void consider(const Planes& planes, std::size_t x, std::size_t y, Window& window) noexcept
{
    const float found = distance(planes, window, x, y, window.distance);
    if (found > window.distance || (found == window.distance && !before(x, y, window))) return;
    window.distance = found;
    window.nearest_x = static_cast<std::uint32_t>(x);
    window.nearest_y = static_cast<std::uint32_t>(y);
    window.settled = window.expected;
}

/// Compares a window with the places [begin, end) of the features, whose first row is the picture's row `first`.
void search(const Planes& planes, const Features& features, std::size_t first, std::size_t begin, std::size_t end,
            Window& window) noexcept
{
    float bounds[places_together];
    const std::size_t size = end - begin;
    std::fill_n(bounds, size, 0.0f);
    for (std::size_t f = 0; f < window_features; ++f) {
        const float* values = features.feature(f) + begin;
        const float own = window.features[f];
        for (std::size_t i = 0; i < size; ++i) bounds[i] += (values[i] - own) * (values[i] - own);
    }
    for (std::size_t i = 0; i < size && !window.settled; ++i)
        if (bounds[i] * bound_factor - bound_slack <= window.distance)
            consider(planes, (begin + i) % features.across, first + (begin + i) / features.across, window);
}

} // namespace

Window window_at(const Planes& planes, std::uint64_t x, std::uint64_t y) noexcept
{
    const Cosines cosines;
    Window window{};
    for (std::size_t j = 0; j < window_side; ++j)
        for (std::size_t i = 0; i < window_side; ++i) {
            const float value = planes.row(0, y + j)[x + i];
            window.pixels[j * window_side + i] = value;
            for (std::size_t f = 0; f < window_features; ++f)
                window.features[f] += cosines.values[f / frequencies][j] * cosines.values[f % frequencies][i] * value;
        }
    window.distance = std::numeric_limits<float>::max();
    return window;
}

void expect(const Planes& planes, Window& window, std::uint32_t x, std::uint32_t y) noexcept
{
    window.expected = true;
    window.settled = x + window_side > planes.width;
    if (window.settled) return;
    window.distance = distance(planes, window, x, y, window.distance);
    window.nearest_x = x;
    window.nearest_y = y;
}

void find_nearest(Core& core, const Planes& planes, Window* windows, std::uint32_t count, const Progress& progress)
{
    Features features(core, planes);
    const std::uint32_t runs = (count + windows_together - 1) / windows_together;
    for (std::size_t first = 0; first < features.down; first += features.rows) {
        const std::size_t rows = std::min(features.rows, features.down - first), places = rows * features.across;
        const double done = static_cast<double>(first), down = static_cast<double>(features.down);
        features.compute(core, first);
        for_each_step(core, runs, 20.0 * windows_together * static_cast<double>(places),
                      progress.part(done / down, (done + static_cast<double>(rows)) / down), [&](std::uint32_t run) {
                          const std::uint32_t last = std::min(count, (run + 1) * windows_together);
                          for (std::size_t begin = 0; begin < places; begin += places_together)
                              for (std::uint32_t w = run * windows_together; w < last; ++w)
                                  if (!windows[w].settled)
                                      search(planes, features, first, begin, std::min(places, begin + places_together),
                                             windows[w]);
                      });
    }
}

} // namespace weft
