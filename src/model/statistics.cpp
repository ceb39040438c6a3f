/// Sums over rows side by side, then over the rows in order: the number of threads changes nothing.
#include "model/statistics.h"
#include "model/tone.h"
#include <algorithm>
#include <cmath>
#include <functional>

namespace weft {

namespace {

/// Samples at the integers of the autocorrelation of the B-spline of order taps - 1: the B-spline of order 2 taps - 1,
/// whose samples are Eulerian numbers over a factorial. From lag 0 on.
struct Autocorrelation {
    explicit Autocorrelation(std::uint32_t taps) noexcept
    {
        static constexpr double nearest[] = {1}, linear[] = {4, 1}, cubic[] = {2416, 1191, 120, 1},
                                quintic[] = {15724248, 9738114, 2203488, 152637, 2036, 1};
        values = taps == 1 ? nearest : taps == 2 ? linear : taps == 4 ? cubic : quintic;
        reach = static_cast<std::int64_t>(taps) - 1;
        total = taps == 1 ? 1 : taps == 2 ? 6 : taps == 4 ? 5040 : 39916800;
    }
    const double* values;
    std::int64_t reach;
    double total;
};

/// row * kernel, zero outside.
double filtered(const float* row, std::int64_t width, std::int64_t x, const Autocorrelation& b) noexcept
{
    double sum = b.values[0] * static_cast<double>(row[x]);
    for (std::int64_t d = 1; d <= b.reach; ++d) {
        const double left = x - d >= 0 ? static_cast<double>(row[x - d]) : 0.0,
                     right = x + d < width ? static_cast<double>(row[x + d]) : 0.0;
        sum += b.values[d] * (left + right);
    }
    return sum;
}

/// sum over lags d of b(d) times the autocorrelation of alpha at d: for row y the lags (dx, dy) that end in it.
double power_of_row(const Planes& alpha, std::uint32_t c, std::uint32_t y, const Autocorrelation& b) noexcept
{
    const float* row = alpha.row(c, y);
    const auto width = static_cast<std::int64_t>(alpha.width);
    double sum = 0;
    for (std::int64_t dy = 0; dy <= b.reach && dy <= y; ++dy) {
        const float* above = alpha.row(c, y - static_cast<std::uint32_t>(dy));
        double inner = 0;
        for (std::int64_t x = 0; x < width; ++x) inner += static_cast<double>(row[x]) * filtered(above, width, x, b);
        sum += (dy == 0 ? 1.0 : 2.0) * b.values[dy] * inner;
    }
    return sum / (b.total * b.total);
}

/// The sum of row_sum(c, y) over the rows of each of the first `channels` planes.
std::array<double, most_channels> sums_over_rows(const Planes& planes, std::uint32_t channels,
                                                 std::pmr::memory_resource* memory, Parallel& parallel,
                                                 const std::function<double(std::uint32_t, std::uint32_t)>& row_sum)
{
    Array<double> rows(memory, std::size_t{channels} * planes.height, Array<double>::unset);
    const std::uint32_t step = std::max(1U, 65536U / planes.width), tasks = (planes.height + step - 1) / step;
    const auto work = [&](std::uint32_t task) {
        const std::uint32_t end = std::min(planes.height, (task + 1) * step);
        for (std::uint32_t c = 0; c < channels; ++c)
            for (std::uint32_t y = task * step; y < end; ++y) rows[std::size_t{c} * planes.height + y] = row_sum(c, y);
    };
    parallel.for_each_index(tasks, std::ref(work));
    std::array<double, most_channels> sums{};
    for (std::uint32_t c = 0; c < channels; ++c)
        for (std::uint32_t y = 0; y < planes.height; ++y) sums[c] += rows[std::size_t{c} * planes.height + y];
    return sums;
}

/// The noise is normal: its moments are those of its principal axes, after their tone curves.
void add_axes(const Model& model, std::array<double, most_channels>& mean,
              std::array<double, most_channels>& variance) noexcept
{
    const Wavelet& wavelet = model.wavelet;
    for (std::uint32_t p = 0; p < model.channels; ++p) {
        double power = 0;
        for (std::uint32_t b = 0; b < wavelet.bands; ++b)
            power += static_cast<double>(wavelet.weight[b][p]) * static_cast<double>(wavelet.weight[b][p]);
        const Tone_moments moments = tone_moments(wavelet, p, power);
        for (std::uint32_t o = 0; o < model.channels; ++o) {
            const double axis = static_cast<double>(wavelet.axes[p][o]);
            mean[o] += axis * moments.mean;
            variance[o] += axis * axis * moments.variance;
        }
    }
}

} // namespace

std::array<double, most_channels> texton_variance(const Planes& coefficients, std::uint32_t planes, std::uint32_t taps,
                                                  std::pmr::memory_resource* memory, Parallel& parallel)
{
    const Autocorrelation b(taps);
    const auto row_power = [&](std::uint32_t c, std::uint32_t y) { return power_of_row(coefficients, c, y, b); };
    return sums_over_rows(coefficients, planes, memory, parallel, std::ref(row_power));
}

Statistics statistics_of(const Model& model, std::pmr::memory_resource* memory, Parallel& parallel)
{
    Statistics result;
    std::array<double, most_channels> variance{};
    if (model.method == WEFT_METHOD_TEXTON) {
        variance = texton_variance(model.texton.coefficients, model.channels, model.texton.taps, memory, parallel);
        result.mean = model.mean;
    } else if (model.method == WEFT_METHOD_BILAYER) {
        return bilayer_statistics(model, memory, parallel);
    } else if (model.method == WEFT_METHOD_WAVELET) {
        std::array<double, most_channels> mean{};
        for (std::uint32_t c = 0; c < model.channels; ++c) mean[c] = static_cast<double>(model.mean[c]);
        add_axes(model, mean, variance);
        for (std::uint32_t c = 0; c < model.channels; ++c) result.mean[c] = static_cast<float>(mean[c]);
    } else {
        const Planes& picture = model.picture;
        const auto area = static_cast<double>(picture.area());
        const auto row_sum = [&](std::uint32_t c, std::uint32_t y) {
            double sum = 0;
            for (std::uint32_t x = 0; x < picture.width; ++x) sum += static_cast<double>(picture.row(c, y)[x]);
            return sum;
        };
        const auto sums = sums_over_rows(picture, model.channels, memory, parallel, std::ref(row_sum));
        const auto row_power = [&](std::uint32_t c, std::uint32_t y) {
            double sum = 0;
            for (std::uint32_t x = 0; x < picture.width; ++x) {
                const double d = static_cast<double>(picture.row(c, y)[x]) - sums[c] / area;
                sum += d * d;
            }
            return sum;
        };
        variance = sums_over_rows(picture, model.channels, memory, parallel, std::ref(row_power));
        for (std::uint32_t c = 0; c < picture.count; ++c) {
            variance[c] /= area;
            result.mean[c] = static_cast<float>(sums[c] / area);
        }
    }
    for (std::uint32_t c = 0; c < model.channels; ++c)
        result.deviation[c] = static_cast<float>(std::sqrt(std::max(variance[c], 0.0)));
    return result;
}

} // namespace weft
