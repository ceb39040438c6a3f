/// Prepares two pictures for comparison: mean, covariance and principal axes of the exemplar, applied to both.
#include "analysis/compare_pair.h"
#include "analysis/matrix.h"
#include "base/image.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr double float_rounding = 1e-13; // relative to the greatest square: a variance below it is rounding
constexpr double farthest = 1e9;         // in standard deviations of the exemplar: squares and sums stay finite floats

std::uint32_t run_count(const Planes& planes) { return std::min(planes.height, 256u); }

/// Calls body(run, first row, last row) for a number of runs that depends on the picture alone.
template <class Body> void for_each_rows(Core& core, const Planes& planes, const Progress& progress, const Body& body)
{
    const std::uint32_t runs = run_count(planes);
    const double cost = static_cast<double>(planes.area()) / runs * planes.count * planes.count;
    for_each_step(core, runs, cost, progress, [&](std::uint32_t run) {
        const auto bound = [&](std::uint64_t i) { return static_cast<std::uint32_t>(i * planes.height / runs); };
        body(run, bound(run), bound(run + 1u));
    });
}

struct Moments {
    double mean[most_channels] = {};
    double greatest = 0; ///< modulus of any value
    Matrix covariance;
};

void add_sums(const Planes& planes, std::uint32_t first, std::uint32_t last, Moments& sums) noexcept
{
    for (std::uint32_t c = 0; c < planes.count; ++c)
        for (std::size_t y = first; y < last; ++y) {
            const float* row = planes.row(c, y);
            for (std::size_t x = 0; x < planes.width; ++x) {
                sums.mean[c] += static_cast<double>(row[x]);
                sums.greatest = std::max(sums.greatest, std::abs(static_cast<double>(row[x])));
            }
        }
}

void add_products(const Planes& planes, std::uint32_t first, std::uint32_t last, const double* mean,
                  Matrix& sums) noexcept
{
    for (std::uint32_t c = 0; c < planes.count; ++c)
        for (std::uint32_t d = 0; d <= c; ++d)
            for (std::size_t y = first; y < last; ++y) {
                const float *a = planes.row(c, y), *b = planes.row(d, y);
                double sum = 0;
                for (std::size_t x = 0; x < planes.width; ++x)
                    sum += (static_cast<double>(a[x]) - mean[c]) * (static_cast<double>(b[x]) - mean[d]);
                sums[c][d] += sum;
            }
}

Moments moments_of(Core& core, const Planes& planes, const Progress& progress)
{
    Array<Moments> parts(&core.memory, run_count(planes));
    const double area = static_cast<double>(planes.area());
    Moments moments;
    moments.covariance.size = planes.count;
    for_each_rows(core, planes, progress.part(0, 0.5), [&](std::uint32_t run, std::uint32_t first, std::uint32_t last) {
        add_sums(planes, first, last, parts[run]);
    });
    for (const Moments& part : parts) {
        for (std::uint32_t c = 0; c < planes.count; ++c) moments.mean[c] += part.mean[c] / area;
        moments.greatest = std::max(moments.greatest, part.greatest);
    }
    for_each_rows(core, planes, progress.part(0.5, 1), [&](std::uint32_t run, std::uint32_t first, std::uint32_t last) {
        add_products(planes, first, last, moments.mean, parts[run].covariance);
    });
    for (std::uint32_t c = 0; c < planes.count; ++c)
        for (std::uint32_t d = 0; d <= c; ++d) {
            for (const Moments& part : parts) moments.covariance[c][d] += part.covariance[c][d] / area;
            moments.covariance[d][c] = moments.covariance[c][d];
        }
    return moments;
}

double trace(const Matrix& matrix) noexcept
{
    double sum = 0;
    for (std::uint32_t c = 0; c < matrix.size; ++c) sum += matrix[c][c];
    return sum;
}

bool varies(const Moments& moments) noexcept
{
    return trace(moments.covariance) > float_rounding * moments.greatest * moments.greatest;
}

/// Row c: what channel c of the result takes of each channel.
Matrix principal_axes(const Matrix& covariance, double scale, double* variance) noexcept
{
    const Eigen eigen = eigen_of(covariance);
    std::uint32_t order[most_channels];
    for (std::uint32_t c = 0; c < covariance.size; ++c) order[c] = c;
    std::sort(order, order + covariance.size, [&](std::uint32_t a, std::uint32_t b) {
        return eigen.values[a] != eigen.values[b] ? eigen.values[a] > eigen.values[b] : a < b;
    });
    Matrix axes;
    axes.size = covariance.size;
    for (std::uint32_t c = 0; c < axes.size; ++c) {
        variance[c] = std::max(eigen.values[order[c]], 0.0) * scale * scale;
        for (std::uint32_t d = 0; d < axes.size; ++d) axes[c][d] = eigen.vectors[d][order[c]] * scale;
    }
    return axes;
}

void apply(Core& core, const Matrix& axes, const double* mean, Planes& planes, const Progress& progress)
{
    for_each_rows(core, planes, progress, [&](std::uint32_t, std::uint32_t first, std::uint32_t last) {
        const std::size_t begin = std::size_t{first} * planes.width, end = std::size_t{last} * planes.width;
        for (std::size_t i = begin; i < end; ++i) {
            double value[most_channels];
            for (std::uint32_t c = 0; c < planes.count; ++c)
                value[c] = static_cast<double>(planes.plane(c)[i]) - mean[c];
            for (std::uint32_t c = 0; c < planes.count; ++c) {
                double sum = 0;
                for (std::uint32_t d = 0; d < planes.count; ++d) sum += axes[c][d] * value[d];
                planes.plane(c)[i] = static_cast<float>(std::clamp(sum, -farthest, farthest));
            }
        }
    });
}

} // namespace

void for_each_step(Core& core, std::uint32_t count, double cost, const Progress& progress,
                   const std::function<void(std::uint32_t)>& body)
{
    const double many = std::max(1.0, 0x1p24 / std::max(cost, 1.0));
    const std::uint32_t batch =
        std::max(core.parallel.width(), static_cast<std::uint32_t>(std::min<double>(many, count)));
    for (std::uint32_t first = 0; first < count;) {
        const std::uint32_t size = std::min(batch, count - first);
        core.parallel.for_each_index(size, [&](std::uint32_t i) { body(first + i); });
        first += size;
        progress.at(static_cast<double>(first) / count);
    }
}

Pair prepare_pair(Core& core, const weft_image& exemplar, const weft_image& output, const Progress& progress)
{
    Pair pair;
    pair.exemplar = read_image(exemplar, &core.memory, core.parallel, "weft_compare", "exemplar");
    progress.at(0.05);
    pair.output = read_image(output, &core.memory, core.parallel, "weft_compare", "output");
    progress.at(0.2);
    const Moments moments = moments_of(core, pair.exemplar, progress.part(0.2, 0.4));
    const Moments output_moments = moments_of(core, pair.output, progress.part(0.4, 0.6));
    pair.exemplar_varies = varies(moments);
    pair.output_varies = varies(output_moments);

    const double variance = trace(pair.exemplar_varies ? moments.covariance : output_moments.covariance);
    const double scale = variance > 0 ? 1 / std::sqrt(variance) : 1;
    const Matrix axes = principal_axes(moments.covariance, scale, pair.variance);
    apply(core, axes, moments.mean, pair.exemplar, progress.part(0.6, 0.7));
    apply(core, axes, moments.mean, pair.output, progress.part(0.7, 0.85));
    const Moments turned = moments_of(core, pair.output, progress.part(0.85, 1));
    for (std::uint32_t c = 0; c < pair.channels(); ++c) {
        pair.output_mean[c] = turned.mean[c];
        pair.output_variance[c] = turned.covariance[c][c];
    }
    return pair;
}

} // namespace weft
