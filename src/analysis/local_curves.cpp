/// A curve has a new value for each edge of the bins and is read linearly; between cells, curves are blended.
#include "analysis/local_curves.h"
#include "analysis/compare_pair.h"
#include "analysis/pearson.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

/// Shares below each edge.
struct Cumulative {
    float at[local_edges];

    explicit Cumulative(const float* bins) noexcept
    {
        at[0] = 0;
        for (std::uint32_t b = 0; b < local_bins; ++b) at[b + 1] = at[b] + bins[b];
    }
};

/// The edge coordinates at which `whole` has reached what `local` has at each edge.
void match(const Cumulative& local, const Cumulative& whole, float* curve) noexcept
{
    std::uint32_t bin = 0;
    for (std::uint32_t e = 0; e < local_edges; ++e) {
        while (bin + 1 < local_bins && whole.at[bin + 1] < local.at[e]) ++bin;
        const float mass = whole.at[bin + 1] - whole.at[bin];
        const float part = mass > 0 ? (local.at[e] - whole.at[bin]) / mass : 0;
        curve[e] = static_cast<float>(bin) + std::min(std::max(part, 0.0f), 1.0f);
    }
}

/// The line that gives local moments of order 1, or 1 and 2, the values that the whole has.
void line_between(const Moments& local, const Moments& whole, std::uint32_t order, float* curve) noexcept
{
    constexpr double steepest = 8;
    const double slope =
        order == 1 ? 1 : std::min(steepest, whole.deviation / std::max(local.deviation, whole.deviation / steepest));
    for (std::uint32_t e = 0; e < local_edges; ++e)
        curve[e] = static_cast<float>(whole.mean + (e - local.mean) * slope);
}

class Curves {
public:
    Curves(Core& core, const Planes& planes, const Neighbourhoods& around, std::uint32_t moments,
           const Progress& progress)
        : around_(around), distributions_(core, planes, around, progress.part(0, 0.8)),
          curves_(&core.memory, planes.count * around.cells() * local_edges, Array<float>::unset)
    {
        const std::uint32_t rows = around.rows(), columns = around.columns();
        const double cost = (moments > 2 ? 4000.0 : 100.0) * columns;
        for_each_step(core, planes.count * rows, cost, progress.part(0.8, 1), [&](std::uint32_t task) {
            const float* whole = distributions_.whole.data() + std::size_t{task / rows} * local_bins;
            for (std::size_t cell = std::size_t{task} * columns; cell < std::size_t{task + 1} * columns; ++cell)
                make(distributions_.local.data() + cell * local_bins, whole, moments,
                     curves_.data() + cell * local_edges);
        });
    }

    /// Replaces a row of a plane. `blend` holds a row of curves.
    void apply(std::uint32_t plane, std::uint32_t y, float* values, float* blend) const noexcept
    {
        const std::uint32_t columns = around_.columns(), rows = around_.rows();
        const std::size_t line = std::size_t{columns} * local_edges;
        const Between down = between(y, around_.height(), rows);
        const float* upper = curves_.data() + (std::size_t{plane} * rows + down.first) * line;
        const float* lower = curves_.data() + (std::size_t{plane} * rows + down.second) * line;
        for (std::size_t i = 0; i < line; ++i) blend[i] = upper[i] + (lower[i] - upper[i]) * down.part;
        const Local_distributions::Range range = distributions_.ranges[plane];
        for (std::uint32_t x = 0; x < around_.width(); ++x) {
            const Between across = between(x, around_.width(), columns);
            const float z = range.to_z(values[x]);
            const std::uint32_t edge = std::min(static_cast<std::uint32_t>(z), local_bins - 1);
            const float part = z - static_cast<float>(edge);
            const float* left = blend + std::size_t{across.first} * local_edges + edge;
            const float* right = blend + std::size_t{across.second} * local_edges + edge;
            const float from = left[0] + (left[1] - left[0]) * part, to = right[0] + (right[1] - right[0]) * part;
            values[x] = range.from_z(from + (to - from) * across.part);
        }
    }

private:
    /// The two cells between whose middles a pixel lies.
    struct Between {
        std::uint32_t first, second;
        float part;
    };
    static Between between(std::uint32_t pixel, std::uint32_t pixels, std::uint32_t cells) noexcept
    {
        const float at = (static_cast<float>(pixel) + 0.5f) * static_cast<float>(cells) / static_cast<float>(pixels) +
                         0.5f; // from the middle of the last cell of the period before
        const auto second = static_cast<std::uint32_t>(at);
        return {second == 0 ? cells - 1 : second - 1, second < cells ? second : 0, at - static_cast<float>(second)};
    }

    static void make(const float* local, const float* whole, std::uint32_t moments, float* curve) noexcept
    {
        if (moments == 0) return match(Cumulative(local), Cumulative(whole), curve);
        const Moments of_local = moments_of(local, local_bins), of_whole = moments_of(whole, local_bins);
        if (moments <= 2) return line_between(of_local, of_whole, moments, curve);
        float local_fit[local_bins], whole_fit[local_bins];
        fit_pearson(of_local, moments, local_bins, local_fit);
        fit_pearson(of_whole, moments, local_bins, whole_fit);
        match(Cumulative(local_fit), Cumulative(whole_fit), curve);
    }

    const Neighbourhoods& around_;
    const Local_distributions distributions_;
    Array<float> curves_;
};

} // namespace

void equalise(Core& core, Planes& planes, const Neighbourhoods& around, std::uint32_t moments, const Progress& progress)
{
    const Curves curves(core, planes, around, moments, progress.part(0, 0.8));
    constexpr std::uint32_t rows_a_task = 16;
    const std::uint32_t bands = (planes.height + rows_a_task - 1) / rows_a_task;
    const double cost = 12.0 * rows_a_task * planes.width;
    for_each_step(core, planes.count * bands, cost, progress.part(0.8, 1), [&](std::uint32_t task) {
        Array<float> blend(&core.memory, std::size_t{around.columns()} * local_edges, Array<float>::unset);
        const std::uint32_t plane = task / bands, first = task % bands * rows_a_task;
        for (std::uint32_t y = first; y < std::min(planes.height, first + rows_a_task); ++y)
            curves.apply(plane, y, planes.row(plane, y), blend.data());
    });
}

} // namespace weft
