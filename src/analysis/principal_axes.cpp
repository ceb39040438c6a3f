/// Covariance, its eigenvectors in order, and pictures along them.
#include "analysis/principal_axes.h"
#include "analysis/statistics.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

Matrix covariance_of(Core& core, const Planes& planes)
{
    const std::uint32_t parts = std::min(planes.height, 64U);
    Array<Matrix> sums(&core.memory, parts);
    core.parallel.for_each_index(parts, [&](std::uint32_t part) {
        const auto bound = [&](std::uint64_t i) { return static_cast<std::uint32_t>(i * planes.height / parts); };
        for (std::uint32_t y = bound(part); y < bound(part + 1U); ++y)
            for (std::uint32_t c = 0; c < planes.count; ++c)
                for (std::uint32_t d = c; d < planes.count; ++d) {
                    const float *a = planes.row(c, y), *b = planes.row(d, y);
                    double sum[4] = {};
                    for (std::uint32_t x = 0; x < planes.width; ++x)
                        sum[x % 4] += static_cast<double>(a[x]) * static_cast<double>(b[x]);
                    sums[part][c][d] += (sum[0] + sum[1]) + (sum[2] + sum[3]);
                }
    });
    Matrix covariance = sum_of(sums, planes.count);
    for (std::uint32_t c = 0; c < planes.count; ++c)
        for (std::uint32_t d = 0; d < planes.count; ++d) covariance[c][d] /= static_cast<double>(planes.area());
    return covariance;
}

} // namespace

Principal_axes principal_axes_of(Core& core, const Planes& planes)
{
    const Eigen eigen = eigen_of(covariance_of(core, planes));
    const std::uint32_t size = planes.count;
    std::uint32_t order[most_channels];
    for (std::uint32_t p = 0; p < size; ++p) order[p] = p;
    std::stable_sort(order, order + size,
                     [&](std::uint32_t a, std::uint32_t b) { return eigen.values[a] > eigen.values[b]; });
    Principal_axes result;
    result.axes.size = size;
    for (std::uint32_t p = 0; p < size; ++p) {
        result.variance[p] = std::max(eigen.values[order[p]], 0.0);
        double greatest = 0;
        for (std::uint32_t c = 0; c < size; ++c) {
            const double value = eigen.vectors[c][order[p]];
            result.axes[p][c] = value;
            if (std::abs(value) > std::abs(greatest)) greatest = value;
        }
        for (std::uint32_t c = 0; greatest < 0 && c < size; ++c) result.axes[p][c] = -result.axes[p][c];
    }
    return result;
}

void project_on_axis(Core& core, const Planes& planes, const Matrix& axes, std::uint32_t p, float* plane)
{
    for_each_run(core.parallel, planes.height, [&](std::uint32_t first, std::uint32_t last) {
        const std::size_t begin = std::size_t{first} * planes.width, end = std::size_t{last} * planes.width;
        std::fill(plane + begin, plane + end, 0.0f);
        for (std::uint32_t c = 0; c < planes.count; ++c) {
            const float factor = static_cast<float>(axes[p][c]);
            const float* from = planes.plane(c);
            for (std::size_t i = begin; i < end; ++i) plane[i] += factor * from[i];
        }
    });
}

} // namespace weft
