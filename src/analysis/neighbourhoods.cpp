/// Gaussians on the torus of cells, separable; where deviations differ, blurs of a few deviations are blended.
#include "analysis/neighbourhoods.h"
#include "analysis/compare_pair.h"
#include "base/elementary.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr float least_sigma = 0.02f; ///< of the shorter side

/// The weights of a Gaussian at distances 0, 1, ... cells around a torus of `cells`, sum 1.
Array<float> weights_of(Core& core, std::uint32_t cells, float sigma)
{
    Array<double> exact(&core.memory, cells);
    const double scale = 1 / (2.0 * static_cast<double>(sigma) * static_cast<double>(sigma));
    const auto reach = static_cast<std::int64_t>(std::ceil(3.5 * static_cast<double>(sigma)));
    double sum = 0;
    for (std::int64_t d = -reach; d <= reach; ++d) {
        const double weight = exponential_of_minus(static_cast<double>(d * d) * scale);
        const std::int64_t n = cells;
        exact[static_cast<std::size_t>(((d % n) + n) % n)] += weight;
        sum += weight;
    }
    Array<float> weights(&core.memory, cells);
    for (std::uint32_t i = 0; i < cells; ++i) weights[i] = static_cast<float>(exact[i] / sum);
    return weights;
}

/// The plane at a place in parts of its sides, bilinear and periodic.
float sample(const Planes& plane, float x, float y) noexcept
{
    const auto corner = [](float at, std::uint32_t size, float& fraction) {
        const float shifted = at * static_cast<float>(size) + static_cast<float>(size) - 0.5f;
        const auto whole = static_cast<std::uint32_t>(shifted);
        fraction = shifted - static_cast<float>(whole);
        return whole % size;
    };
    float u, v;
    const std::uint32_t i = corner(x, plane.width, u), j = corner(y, plane.height, v);
    const float *upper = plane.row(0, j), *lower = plane.row(0, (j + 1) % plane.height);
    const std::uint32_t next = (i + 1) % plane.width;
    return (upper[i] * (1 - u) + upper[next] * u) * (1 - v) + (lower[i] * (1 - u) + lower[next] * u) * v;
}

} // namespace

Neighbourhoods::Neighbourhoods(Core& core, std::uint32_t width, std::uint32_t height, float sigma,
                               const Planes* factors, std::uint32_t spacing)
    : width_(width), height_(height)
{
    const float side = static_cast<float>(std::min(width, height));
    float least = std::max(sigma, least_sigma), greatest = least;
    if (factors) {
        const auto [low, high] = std::minmax_element(factors->values.begin(), factors->values.end());
        least = std::max(sigma * *low, least_sigma);
        greatest = std::max(sigma * *high, least_sigma);
    }
    const std::uint32_t cell = std::max(spacing, static_cast<std::uint32_t>(least * side / 4));
    columns_ = std::max(1u, (width + cell / 2) / cell);
    rows_ = std::max(1u, (height + cell / 2) / cell);
    for (float reached = least; reached < greatest && steps_ < most_steps; reached *= 2) ++steps_;
    for (std::uint32_t s = 0; s < steps_; ++s) {
        Step& step = step_[s];
        step.sigma = side * std::min(least * static_cast<float>(1u << s), greatest);
        step.across = weights_of(core, columns_, step.sigma * static_cast<float>(columns_) / static_cast<float>(width));
        step.down = weights_of(core, rows_, step.sigma * static_cast<float>(rows_) / static_cast<float>(height));
    }
    if (steps_ == 1) return;
    positions_ = Array<float>(&core.memory, cells());
    for (std::size_t i = 0; i < cells(); ++i) {
        const float x = (static_cast<float>(i % columns_) + 0.5f) / static_cast<float>(columns_);
        const float y = (static_cast<float>(i / columns_) + 0.5f) / static_cast<float>(rows_);
        const float wanted = side * std::max(sigma * sample(*factors, x, y), least_sigma);
        std::uint32_t s = 0;
        while (s + 2 < steps_ && step_[s + 1].sigma < wanted) ++s;
        const float part = (wanted - step_[s].sigma) / (step_[s + 1].sigma - step_[s].sigma);
        positions_[i] = static_cast<float>(s) + std::min(std::max(part, 0.0f), 1.0f);
    }
}

/// How much of a step's blur a cell takes.
float Neighbourhoods::share(std::uint32_t step, std::size_t cell) const noexcept
{
    if (positions_.empty()) return 1;
    return std::max(0.0f, 1 - std::abs(positions_[cell] - static_cast<float>(step)));
}

/// Adds each cell's share of the blur to `to`.
void Neighbourhoods::blur(Core& core, const Step& step, const Array<float>& from, std::uint32_t size, Array<float>& to,
                          const Progress& progress) const
{
    const std::size_t line = std::size_t{columns_} * size;
    const auto number = static_cast<std::uint32_t>(&step - step_);
    const auto add = [](float* target, float weight, const float* source, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) target[i] += weight * source[i];
    };
    Array<float> half(&core.memory, from.size());
    const auto rows = static_cast<std::uint32_t>(from.size() / line);
    const double cost =
        2.0 * static_cast<double>(line) * std::min<double>(columns_, 7.0 * static_cast<double>(step.sigma));
    for_each_step(core, rows, cost, progress.part(0, 0.5), [&](std::uint32_t y) {
        const float* source = from.data() + y * line;
        float* target = half.data() + y * line;
        for (std::uint32_t d = 0; d < columns_; ++d) { // what lies d cells to the right, around the torus
            if (step.across[d] == 0) continue;
            add(target, step.across[d], source + std::size_t{d} * size, line - std::size_t{d} * size);
            add(target + (line - std::size_t{d} * size), step.across[d], source, std::size_t{d} * size);
        }
    });
    for_each_step(core, rows, cost, progress.part(0.5, 1), [&](std::uint32_t y) {
        const std::uint32_t plane = y / rows_, row = y % rows_;
        Array<float> sums(&core.memory, line);
        for (std::uint32_t d = 0; d < rows_; ++d)
            if (step.down[d] != 0)
                add(sums.data(), step.down[d], half.data() + (std::size_t{plane} * rows_ + (row + d) % rows_) * line,
                    line);
        float* target = to.data() + y * line;
        for (std::uint32_t x = 0; x < columns_; ++x) {
            const float part = share(number, std::size_t{row} * columns_ + x);
            if (part != 0) add(target + std::size_t{x} * size, part, sums.data() + std::size_t{x} * size, size);
        }
    });
}

void Neighbourhoods::average(Core& core, Array<float>& values, std::uint32_t size, const Progress& progress) const
{
    Array<float> result(&core.memory, values.size());
    for (std::uint32_t s = 0; s < steps_; ++s)
        blur(core, step_[s], values, size, result,
             progress.part(static_cast<double>(s) / steps_, static_cast<double>(s + 1) / steps_));
    values = std::move(result);
}

} // namespace weft
