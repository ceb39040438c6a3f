/// Means and extremes row by row; covariances block by block.
#include "analysis/statistics.h"
#include <algorithm>
#include <cmath>

namespace weft {

namespace {

struct ChannelStatistics {
    double mean = 0, deviation = 0; ///< a constant channel's: its value, exactly, and 0
};

ChannelStatistics channel_statistics(Core& core, const float* plane, std::uint32_t width, std::uint32_t height)
{
    struct Row {
        double sum, squares;
        float least, most;
    };
    Array<Row> rows(&core.memory, height);
    const double origin = static_cast<double>(plane[0]); // near the mean, so that squares keep their digits
    for_each_run(core.parallel, height, [&](std::uint32_t first, std::uint32_t last) {
        for (std::size_t y = first; y < last; ++y) {
            const float* row = plane + y * width;
            Row& total = rows[y] = {0, 0, row[0], row[0]};
            for (std::uint32_t x = 0; x < width; ++x) {
                const double value = static_cast<double>(row[x]) - origin;
                total.sum += value;
                total.squares += value * value;
                total.least = std::min(total.least, row[x]);
                total.most = std::max(total.most, row[x]);
            }
        }
    });
    Row all = rows[0];
    for (std::size_t y = 1; y < height; ++y)
        all = {all.sum + rows[y].sum, all.squares + rows[y].squares, std::min(all.least, rows[y].least),
               std::max(all.most, rows[y].most)};
    if (all.least == all.most) return {origin, 0};
    const double pixels = static_cast<double>(width) * height, mean = all.sum / pixels;
    return {origin + mean, std::sqrt(std::max(all.squares / pixels - mean * mean, 0.0))};
}

} // namespace

Centring centre(Core& core, Planes& planes)
{
    Centring centring;
    double largest = 0;
    for (std::uint32_t c = 0; c < planes.count; ++c) {
        const ChannelStatistics channel = channel_statistics(core, planes.plane(c), planes.width, planes.height);
        centring.mean[c] = channel.mean;
        centring.deviation[c] = channel.deviation;
        largest = std::max(largest, channel.deviation);
    }
    if (largest > 0) centring.scale = std::ldexp(1.0, -std::ilogb(largest));
    for_each_run(core.parallel, planes.count * planes.height, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t i = first; i < last; ++i) { // row i % height of channel i / height
            float* row = planes.values.data() + std::size_t{i} * planes.width;
            const double mean = centring.mean[i / planes.height],
                         scale = centring.deviation[i / planes.height] > 0 ? centring.scale : 0;
            for (std::uint32_t x = 0; x < planes.width; ++x)
                row[x] = static_cast<float>((static_cast<double>(row[x]) - mean) * scale);
        }
    });
    return centring;
}

Matrix block_covariance(const Spectra& spectra, std::uint32_t b, const Complex* block, double unit) noexcept
{
    Matrix sum;
    sum.size = spectra.count;
    for (std::uint32_t lane = 0; lane < fft_lanes; ++lane) {
        const double factor = unit * static_cast<double>(spectra.weight(b * fft_lanes + lane));
        if (factor == 0) continue;
        for (std::uint32_t y = 0; y < spectra.height; ++y) {
            const Complex* values = block + std::size_t{y} * fft_lanes + lane;
            for (std::uint32_t i = 0; i < sum.size; ++i)
                for (std::uint32_t j = i; j < sum.size; ++j) {
                    const std::complex<double> u(values[i * spectra.block_size()]), v(values[j * spectra.block_size()]);
                    sum[i][j] += factor * (u.real() * v.real() + u.imag() * v.imag());
                }
        }
    }
    return sum;
}

Matrix sum_of(const Array<Matrix>& parts, std::uint32_t size) noexcept
{
    Matrix sum;
    sum.size = size;
    for (const Matrix& part : parts)
        for (std::uint32_t i = 0; i < size; ++i)
            for (std::uint32_t j = i; j < size; ++j) sum[i][j] += part[i][j];
    for (std::uint32_t i = 0; i < size; ++i)
        for (std::uint32_t j = 0; j < i; ++j) sum[i][j] = sum[j][i];
    return sum;
}

} // namespace weft
