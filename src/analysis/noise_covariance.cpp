/// Covariance between the channels of a texton's noise, row by row.
#include "analysis/noise_covariance.h"
#include "analysis/statistics.h"

namespace weft {
namespace {

/// to[x] = sum over d of b(d) times the values at distance d from x; pair(x, d) is the sum of both of them.
template <class Pair>
void filter(const SplineSamples& samples, std::uint32_t count, double* to, const Pair& pair) noexcept
{
    for (std::uint32_t x = 0; x < count; ++x) {
        double sum = samples.values[0] * pair(x, 0u);
        for (std::uint32_t d = 1; d < samples.count; ++d) sum += samples.values[d] * pair(x, d);
        to[x] = sum;
    }
}

/// Row y of b * alpha, one channel; `between` is room for a row.
void filter_row(const SplineSamples& samples, const Planes& planes, std::uint32_t c, std::uint32_t y, double* between,
                double* to) noexcept
{
    filter(samples, planes.width, between, [&](std::uint32_t x, std::uint32_t d) {
        const auto value = [&](std::uint32_t row) { return static_cast<double>(planes.row(c, row)[x]); };
        if (d == 0) return value(y);
        return (d <= y ? value(y - d) : 0) + (d < planes.height - y ? value(y + d) : 0);
    });
    filter(samples, planes.width, to, [&](std::uint32_t x, std::uint32_t d) {
        if (d == 0) return between[x];
        return (d <= x ? between[x - d] : 0) + (d < planes.width - x ? between[x + d] : 0);
    });
}

} // namespace

Matrix noise_covariance(Core& core, const SplineSamples& samples, const Planes& coefficients)
{
    Array<Matrix> rows(&core.memory, coefficients.height);
    for_each_run(core.parallel, coefficients.height, [&](std::uint32_t first, std::uint32_t last) {
        Array<double> between(&core.memory, coefficients.width), filtered(&core.memory, coefficients.width);
        for (std::uint32_t y = first; y < last; ++y)
            for (std::uint32_t j = 0; j < coefficients.count; ++j) {
                filter_row(samples, coefficients, j, y, between.data(), filtered.data());
                for (std::uint32_t i = 0; i <= j; ++i)
                    for (std::uint32_t x = 0; x < coefficients.width; ++x)
                        rows[y][i][j] += static_cast<double>(coefficients.row(i, y)[x]) * filtered[x];
            }
    });
    return sum_of(rows, coefficients.count);
}

} // namespace weft
