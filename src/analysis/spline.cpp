/// B-spline samples, their spectrum, and the banded Cholesky solver.
#include "analysis/spline.h"
#include <cmath>

namespace weft {

SplineSamples spline_samples(std::uint32_t taps) noexcept
{
    switch (taps) {
    case 1: return {1, {1}};
    case 2: return {2, {4 / 6.0, 1 / 6.0}};
    case 4: return {4, {2416 / 5040.0, 1191 / 5040.0, 120 / 5040.0, 1 / 5040.0}};
    default:
        return {6, {15724248 / 39916800.0, 9738114 / 39916800.0, 2203488 / 39916800.0, 152637 / 39916800.0, 2036 / 39916800.0,
                    1 / 39916800.0}};
    }
}

Array<float> spline_spectrum(std::pmr::memory_resource* memory, const SplineSamples& samples, std::uint32_t length,
                             std::uint32_t count)
{
    constexpr double two_pi = 6.283185307179586;
    Array<float> spectrum(memory, count);
    for (std::uint32_t k = 0; k < count; ++k) {
        double sum = samples.values[0];
        for (std::uint32_t j = 1; j < samples.count; ++j)
            sum += 2 * samples.values[j] * std::cos(two_pi * static_cast<double>(std::uint64_t{j} * k % length) / length);
        spectrum[k] = static_cast<float>(sum);
    }
    return spectrum;
}

SplineSolver::SplineSolver(Core& core, const SplineSamples& samples, std::uint32_t support)
    : core_(core), support_(support), band_(samples.count - 1), factor_(&core.memory, std::size_t{support} * samples.count)
{
    Array<double> lower(&core.memory, factor_.size()); // lower[i * count + d] = L(i, i - d)
    const std::uint32_t count = samples.count;
    for (std::uint32_t i = 0; i < support; ++i)
        for (std::uint32_t d = i < band_ ? i : band_;; --d) {
            double sum = samples.values[d];
            for (std::uint32_t e = d + 1; e <= band_ && e <= i; ++e)
                sum -= lower[i * count + e] * lower[(i - d) * count + e - d];
            lower[i * count + d] = d ? sum / lower[(i - d) * count] : std::sqrt(sum);
            factor_[i * count + d] = static_cast<float>(d ? lower[i * count + d] : 1 / lower[i * count]);
            if (d == 0) break;
        }
}

void SplineSolver::solve(Planes& planes) const
{
    if (band_ == 0) return;
    for (std::uint32_t c = 0; c < planes.count; ++c) {
        for_each_run(core_.parallel, support_, [&](std::uint32_t first, std::uint32_t last) {
            for (std::uint32_t y = first; y < last; ++y) solve_row(planes.row(c, y));
        });
        for_each_run(core_.parallel, support_, [&](std::uint32_t first, std::uint32_t last) {
            solve_columns(planes.plane(c), first, last);
        });
    }
}

void SplineSolver::solve_row(float* row) const noexcept
{
    const std::uint32_t count = band_ + 1;
    for (std::uint32_t i = 0; i < support_; ++i) {
        float value = row[i];
        for (std::uint32_t d = 1; d <= band_ && d <= i; ++d) value -= factor_[i * count + d] * row[i - d];
        row[i] = value * factor_[i * count];
    }
    for (std::uint32_t i = support_; i-- > 0;) {
        float value = row[i];
        for (std::uint32_t d = 1; d <= band_ && i + d < support_; ++d) value -= factor_[(i + d) * count + d] * row[i + d];
        row[i] = value * factor_[i * count];
    }
}

void SplineSolver::solve_columns(float* plane, std::uint32_t first, std::uint32_t last) const noexcept
{
    const std::uint32_t count = band_ + 1;
    const auto row = [&](std::uint32_t y) { return plane + std::size_t{y} * support_; };
    const auto eliminate = [&](std::uint32_t to, std::uint32_t from, float factor) {
        float* a = row(to);
        const float* b = row(from);
        for (std::uint32_t x = first; x < last; ++x) a[x] -= factor * b[x];
    };
    const auto divide = [&](std::uint32_t y) {
        float* a = row(y);
        for (std::uint32_t x = first; x < last; ++x) a[x] *= factor_[y * count];
    };
    for (std::uint32_t i = 0; i < support_; ++i) {
        for (std::uint32_t d = 1; d <= band_ && d <= i; ++d) eliminate(i, i - d, factor_[i * count + d]);
        divide(i);
    }
    for (std::uint32_t i = support_; i-- > 0;) {
        for (std::uint32_t d = 1; d <= band_ && i + d < support_; ++d) eliminate(i, i + d, factor_[(i + d) * count + d]);
        divide(i);
    }
}

} // namespace weft
