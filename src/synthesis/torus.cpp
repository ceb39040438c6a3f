/// Rows side by side; every sum in a fixed order, so that the number of threads changes nothing.
#include "synthesis/torus.h"
#include "base/elementary.h"
#include "base/hash.h"
#include <algorithm>

namespace weft {

namespace {

/// to[i] += factor * from[(i + shift) mod n]; shift < n.
void add_rotated(float* to, const float* from, std::uint32_t n, std::uint32_t shift, float factor) noexcept
{
    const std::uint32_t straight = n - shift;
    for (std::uint32_t i = 0; i < straight; ++i) to[i] += factor * from[i + shift];
    for (std::uint32_t i = straight; i < n; ++i) to[i] += factor * from[i - straight];
}

/// to[i] = sum over taps of value * source[i]; four at a time, in their order.
void sum_rows(float* to, const float* const* sources, const Taps& taps, std::uint32_t n) noexcept
{
    std::fill_n(to, n, 0.0F);
    std::uint32_t j = 0;
    for (; j + 4 <= taps.count; j += 4) {
        const float *a = sources[j], *b = sources[j + 1], *c = sources[j + 2], *d = sources[j + 3];
        const float va = taps.value[j], vb = taps.value[j + 1], vc = taps.value[j + 2], vd = taps.value[j + 3];
        for (std::uint32_t i = 0; i < n; ++i) to[i] = (((to[i] + va * a[i]) + vb * b[i]) + vc * c[i]) + vd * d[i];
    }
    for (; j < taps.count; ++j) {
        const float* a = sources[j];
        const float va = taps.value[j];
        for (std::uint32_t i = 0; i < n; ++i) to[i] += va * a[i];
    }
}

std::uint32_t reduce(std::int64_t index, std::uint32_t n) noexcept
{
    const std::int64_t rest = index % n;
    return static_cast<std::uint32_t>(rest < 0 ? rest + n : rest);
}

/// The row `offset` rows further along axis 1 or 2.
std::size_t row_beyond(const Sides& sides, std::size_t row, unsigned axis, std::uint32_t offset) noexcept
{
    const std::size_t y = row % sides.height, z = row / sides.height;
    return axis == 1 ? z * sides.height + (y + offset) % sides.height : (z + offset) % sides.depth * sides.height + y;
}

} // namespace

void for_each_row(const Torus& torus, Parallel& parallel, const std::function<void(std::size_t)>& row)
{
    const std::size_t step = std::max(std::size_t{1}, std::size_t{16384} / torus.sides.width);
    const auto work = [&](std::uint32_t task) {
        const std::size_t end = std::min(torus.rows(), (task + 1) * step);
        for (std::size_t r = task * step; r < end; ++r) row(r);
    };
    parallel.for_each_index(static_cast<std::uint32_t>((torus.rows() + step - 1) / step), std::ref(work));
}

void correlate(Core& core, const Torus& from, Torus& to, unsigned axis, const Taps& taps, std::uint32_t dilation)
{
    const Sides sides = from.sides;
    const std::uint32_t n = sides.width;
    const auto filter = [&](std::size_t r) {
        Array<float> twice(&core.memory, axis == 0 ? std::size_t{2} * n : 0,
                           Array<float>::unset); // so that no tap is split
        if (axis == 0)
            for (std::uint32_t half = 0; half < 2; ++half) std::copy_n(from.row(r), n, &twice[std::size_t{half} * n]);
        const float* sources[sizeof taps.value / sizeof(float)];
        for (std::uint32_t j = 0; j < taps.count; ++j) {
            const std::uint32_t offset = reduce((taps.first + std::int64_t{j}) * dilation, sides[axis]);
            sources[j] = axis == 0 ? &twice[offset] : from.row(row_beyond(sides, r, axis, offset));
        }
        sum_rows(to.row(r), sources, taps, n);
    };
    for_each_row(to, core.parallel, std::ref(filter));
}

void add_shifted(const Torus& from, Torus& to, const Sides& shift, float factor, Parallel& parallel)
{
    const Sides sides = from.sides;
    const auto add = [&](std::size_t r) {
        const std::size_t row = row_beyond(sides, row_beyond(sides, r, 1, shift.height), 2, shift.depth);
        add_rotated(to.row(r), from.row(row), sides.width, shift.width % sides.width, factor);
    };
    for_each_row(to, parallel, std::ref(add));
}

void fill_with_white_noise(Torus& torus, std::uint64_t key, Parallel& parallel)
{
    constexpr std::size_t step = 16384; // numbers: an even number of them
    const std::size_t count = torus.values.size();
    const auto work = [&](std::uint32_t task) {
        const std::size_t end = std::min(count, (task + std::size_t{1}) * step);
        for (std::size_t i = task * step; i < end; i += 2) {
            const Normal_pair pair = normal_pair_of(mix_in(key, i / 2));
            torus.values[i] = static_cast<float>(pair.first);
            if (i + 1 < end) torus.values[i + 1] = static_cast<float>(pair.second);
        }
    };
    parallel.for_each_index(static_cast<std::uint32_t>((count + step - 1) / step), std::ref(work));
}

double inner_product(Core& core, const Torus& a, const Torus& b)
{
    Array<double> sums(&core.memory, a.rows(), Array<double>::unset);
    const auto multiply = [&](std::size_t r) {
        double sum = 0;
        for (std::uint32_t i = 0; i < a.sides.width; ++i)
            sum += static_cast<double>(a.row(r)[i]) * static_cast<double>(b.row(r)[i]);
        sums[r] = sum;
    };
    for_each_row(a, core.parallel, std::ref(multiply));
    double total = 0;
    for (const double sum : sums) total += sum;
    return total;
}

} // namespace weft
