/// Normal equations of least squares, one axis at a time: Gram matrix of the wide B-splines, inner products with the
/// filtered narrow ones. All in double, in a fixed order.
#include "synthesis/refinement.h"
#include <algorithm>
#include <functional>

namespace weft {

namespace {

/// Centred B-spline of order taps - 1 at x, by the recurrence of de Boor (1972) on the knots -taps/2 .. taps/2.
double spline(std::uint32_t taps, double x) noexcept
{
    const double at = x + 0.5 * taps;
    if (!(at >= 0 && at < taps)) return 0;
    double values[8] = {};
    for (std::uint32_t i = 0; i < taps; ++i) values[i] = at >= i && at < i + 1.0 ? 1.0 : 0.0;
    for (std::uint32_t order = 1; order < taps; ++order)
        for (std::uint32_t i = 0; i + order < taps; ++i)
            values[i] = ((at - i) * values[i] + (i + order + 1 - at) * values[i + 1]) / order;
    return values[0];
}

/// The integral of the function from `begin` to `end`, by Gauss's rule of six points on intervals of a half: exact for
/// polynomials of degree 11 between knots at multiples of a half.
template <class Function> double integral(double begin, double end, const Function& function) noexcept
{
    static constexpr double points[3] = {0.2386191860831969, 0.6612093864662645, 0.9324695142031521};
    static constexpr double weights[3] = {0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
    double sum = 0;
    for (double left = begin; left < end; left += 0.5)
        for (int i = 0; i < 3; ++i) {
            const double middle = left + 0.25, reach = 0.25 * points[i];
            sum += 0.25 * weights[i] * (function(middle - reach) + function(middle + reach));
        }
    return sum;
}

/// What one axis needs. Fine texel j has its centre at j + 1/2, coarse texel k at 2 k + 1.
struct Axis {
    static constexpr int most = 24;
    double gram[6] = {};       ///< of wide splines 0..taps - 1 texels apart
    double product[most] = {}; ///< of a wide spline with the filtered narrow one `first` + i fine texels from 2 k
    int first = 0, count = 0;

    Axis(std::uint32_t taps, bool from_unfiltered) noexcept
    {
        const double wide = taps; // half its support
        for (std::uint32_t d = 0; d < taps; ++d)
            gram[d] = integral(-wide, wide, [&](double y) { return spline(taps, y / 2) * spline(taps, y / 2 - d); });
        const auto box = [&](double y) {
            return 0.5 * integral(y - 1, y + 1, [&](double z) { return spline(taps, z); });
        };
        const auto pair = [&](double y) { return 0.5 * (spline(taps, y - 0.5) + spline(taps, y + 0.5)); };
        const int reach = static_cast<int>(taps) + static_cast<int>(taps + 1) / 2 + 2;
        first = -reach;
        count = 2 * reach + 2;
        for (int i = 0; i < count; ++i) {
            const double shift = first + i - 0.5; // of the narrow spline's centre from the wide one's
            product[i] = integral(-wide, wide, [&](double y) {
                return spline(taps, y / 2) * (from_unfiltered ? box(y - shift) : pair(y - shift));
            });
        }
    }
};

/// One row or column: its products, then Gram^-1 of them. The Gram matrix is banded: L D L' without roots.
class Solver {
public:
    Solver(const Axis& axis, std::uint32_t taps, std::uint32_t fine, std::uint32_t coarse,
           std::pmr::memory_resource* memory)
        : axis_(axis), band_(taps - 1), fine_(fine), coarse_(coarse), factor_(memory, std::size_t{coarse} * (band_ + 1))
    {
        for (std::uint32_t i = 0; i < coarse_; ++i)
            for (std::uint32_t j = i < band_ ? 0 : i - band_; j <= i; ++j) {
                double sum = axis_.gram[i - j];
                for (std::uint32_t k = i < band_ ? 0 : i - band_; k < j; ++k)
                    if (j - k <= band_) sum -= at(i, k) * at(j, k) * at(k, k);
                at(i, j) = i == j ? sum : sum / at(j, j);
            }
    }

    /// Values `step` apart, as doubles; `to` has room for coarse ones.
    void run(const double* from, std::size_t step, double* to, std::size_t to_step) const noexcept
    {
        for (std::uint32_t k = 0; k < coarse_; ++k) {
            double sum = 0;
            for (int i = 0; i < axis_.count; ++i) {
                const std::int64_t j = 2 * std::int64_t{k} + axis_.first + i;
                if (j >= 0 && j < fine_) sum += axis_.product[i] * from[static_cast<std::size_t>(j) * step];
            }
            for (std::uint32_t d = 1; d <= std::min(band_, k); ++d) sum -= at(k, k - d) * to[(k - d) * to_step];
            to[k * to_step] = sum;
        }
        for (std::uint32_t k = coarse_; k-- > 0;) {
            double value = to[k * to_step] / at(k, k);
            for (std::uint32_t d = 1; d <= band_ && k + d < coarse_; ++d) value -= at(k + d, k) * to[(k + d) * to_step];
            to[k * to_step] = value;
        }
    }

private:
    double& at(std::uint32_t i, std::uint32_t j) noexcept { return factor_[std::size_t{i} * (band_ + 1) + (i - j)]; }
    double at(std::uint32_t i, std::uint32_t j) const noexcept
    {
        return factor_[std::size_t{i} * (band_ + 1) + (i - j)];
    }

    const Axis& axis_;
    const std::uint32_t band_, fine_, coarse_;
    Array<double> factor_;
};

double sum_of(const double* values, std::size_t count) noexcept
{
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += values[i];
    return sum;
}

} // namespace

Planes coarser(const Planes& fine, std::uint32_t taps, bool first, std::pmr::memory_resource* memory,
               Parallel& parallel)
{
    Planes result(memory, (fine.width + 1) / 2, (fine.height + 1) / 2, fine.count, Array<float>::unset);
    const Axis axis(taps, first);
    const Solver along_x(axis, taps, fine.width, result.width, memory),
        along_y(axis, taps, fine.height, result.height, memory);
    const auto plane = [&](std::uint32_t c) {
        Array<double> source(memory, fine.area(), Array<double>::unset);
        Array<double> rows(memory, std::size_t{result.width} * fine.height, Array<double>::unset);
        Array<double> both(memory, result.area(), Array<double>::unset);
        std::copy_n(fine.plane(c), fine.area(), source.begin());
        for (std::uint32_t y = 0; y < fine.height; ++y)
            along_x.run(source.data() + std::size_t{y} * fine.width, 1, rows.data() + std::size_t{y} * result.width, 1);
        for (std::uint32_t x = 0; x < result.width; ++x)
            along_y.run(rows.data() + x, result.width, both.data() + x, result.width);
        const double area = static_cast<double>(result.area());
        const double missing = (sum_of(source.data(), source.size()) * 0.25 - sum_of(both.data(), both.size())) / area;
        for (std::size_t i = 0; i < both.size(); ++i) result.plane(c)[i] = static_cast<float>(both[i] + missing);
    };
    parallel.for_each_index(fine.count, std::ref(plane));
    return result;
}

} // namespace weft
