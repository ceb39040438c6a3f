/// B-spline samples, their spectrum, and the banded Cholesky solver.
#include "analysis/spline.h"
#include <algorithm>
#include <cmath>

namespace weft {

SplineSamples spline_samples(std::uint32_t taps) noexcept
{
    switch (taps) {
    case 1:
        return {1, {1}};
    case 2:
        return {2, {4 / 6.0, 1 / 6.0}};
    case 4:
        return {4, {2416 / 5040.0, 1191 / 5040.0, 120 / 5040.0, 1 / 5040.0}};
    default:
        return {6,
                {15724248 / 39916800.0, 9738114 / 39916800.0, 2203488 / 39916800.0, 152637 / 39916800.0,
                 2036 / 39916800.0, 1 / 39916800.0}};
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
            sum +=
                2 * samples.values[j] * std::cos(two_pi * static_cast<double>(std::uint64_t{j} * k % length) / length);
        spectrum[k] = static_cast<float>(sum);
    }
    return spectrum;
}

AxisFactor::AxisFactor(std::pmr::memory_resource* memory, const SplineSamples& samples, std::uint32_t length,
                       std::uint32_t support)
    : support_(support), first_(memory, support), diagonal_(memory, support)
{
    Array<double> folded(memory, length); // b at each distance along the axis, which is a circle
    for (std::uint32_t d = 0; d < samples.count; ++d) {
        folded[d % length] += samples.values[d];
        if (d) folded[(std::uint64_t{length} * samples.count - d) % length] += samples.values[d];
    }
    std::size_t size = 0;
    for (std::uint32_t i = 0; i < support; ++i) {
        while (folded[i - first_[i]] == 0) ++first_[i];
        size += i - first_[i] + 1;
        diagonal_[i] = size - 1;
    }
    Array<double> lower(memory, size);
    factor_ = Array<float>(memory, size);
    const auto row = [&](std::uint32_t i) { return lower.data() + diagonal_[i] - i; }; // row(i)[j] is L(i, j)
    for (std::uint32_t i = 0; i < support; ++i) {
        for (std::uint32_t j = first_[i]; j <= i; ++j) {
            double sum = folded[i - j];
            for (std::uint32_t k = std::max(first_[i], first_[j]); k < j; ++k) sum -= row(i)[k] * row(j)[k];
            row(i)[j] = i == j ? std::sqrt(sum) : sum / row(j)[j];
            factor_[diagonal_[i] - i + j] = static_cast<float>(i == j ? 1 / row(i)[j] : row(i)[j]);
        }
    }
}

void AxisFactor::solve(float* values, std::size_t step, std::uint32_t count) const noexcept
{
    const auto eliminate = [=](std::uint32_t to, std::uint32_t from, float factor) {
        for (std::uint32_t k = 0; k < count; ++k) values[to * step + k] -= factor * values[from * step + k];
    };
    const auto divide = [&](std::uint32_t i) {
        for (std::uint32_t k = 0; k < count; ++k) values[i * step + k] *= factor_[diagonal_[i]];
    };
    for (std::uint32_t i = 0; i < support_; ++i) {
        for (std::uint32_t j = first_[i]; j < i; ++j) eliminate(i, j, factor_[diagonal_[i] - i + j]);
        divide(i);
    }
    for (std::uint32_t i = support_; i-- > 0;) {
        divide(i);
        for (std::uint32_t j = first_[i]; j < i; ++j) eliminate(j, i, factor_[diagonal_[i] - i + j]);
    }
}

SplineSolver::SplineSolver(Core& core, const SplineSamples& samples, std::uint32_t width, std::uint32_t height,
                           std::uint32_t support)
    : core_(core), support_(support), along_x_(&core.memory, samples, width, support),
      along_y_(&core.memory, samples, height, support)
{
}

void SplineSolver::solve(Planes& planes) const
{
    for (std::uint32_t c = 0; c < planes.count; ++c) {
        for_each_run(core_.parallel, support_, [&](std::uint32_t first, std::uint32_t last) {
            for (std::uint32_t y = first; y < last; ++y) along_x_.solve(planes.row(c, y), 1, 1);
        });
        for_each_run(core_.parallel, support_, [&](std::uint32_t first, std::uint32_t last) {
            along_y_.solve(planes.plane(c) + first, support_, last - first);
        });
    }
}

} // namespace weft
