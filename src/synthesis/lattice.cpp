/// R - R down-up for even sides; a pyramid without decimation for all others.
#include "synthesis/lattice.h"
#include "base/hash.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace weft {

namespace {

void keep_even(Torus& torus, unsigned axis, Parallel& parallel)
{
    const auto clear = [&](std::size_t r) {
        const std::size_t y = r % torus.sides.height, z = r / torus.sides.height;
        float* row = torus.row(r);
        if (axis == 0)
            for (std::uint32_t x = 1; x < torus.sides.width; x += 2) row[x] = 0;
        else if ((axis == 1 ? y : z) % 2 == 1)
            std::fill_n(row, torus.sides.width, 0.0F);
    };
    for_each_row(torus, parallel, std::ref(clear));
}

std::uint32_t odd_half(std::uint32_t side) noexcept { return side / 2 | 1U; }

void subtract(Torus& from, const Torus& what, Parallel& parallel)
{
    const auto row = [&](std::size_t r) {
        for (std::uint32_t x = 0; x < from.sides.width; ++x) from.row(r)[x] -= what.row(r)[x];
    };
    for_each_row(from, parallel, std::ref(row));
}

} // namespace

Sides hashed_shift(const Sides& sides, std::uint64_t key) noexcept
{
    const auto of_axis = [&](unsigned axis) {
        return static_cast<std::uint32_t>((mix_in(key, axis) >> 32) * sides[axis] >> 32);
    };
    return {of_axis(0), of_axis(1), of_axis(2)};
}

double power_of(Core& core, const Torus& lattice, const Taps& overlap)
{
    Torus a(&core.memory, lattice.sides), b(&core.memory, lattice.sides);
    correlate(core, lattice, a, 0, overlap, 1);
    correlate(core, a, b, 1, overlap, 1);
    if (lattice.sides.axes() == 3) {
        correlate(core, b, a, 2, overlap, 1);
        std::swap(a, b);
    }
    return inner_product(core, lattice, b) / static_cast<double>(lattice.values.size());
}

Torus make_wavelet_lattice(Core& core, const Sides& sides, std::uint64_t key, const Wavelet_filters& filters)
{
    Torus noise(&core.memory, sides), a(&core.memory, sides), b(&core.memory, sides);
    fill_with_white_noise(noise, key, core.parallel);
    for (unsigned axis = 0; axis < sides.axes(); ++axis) {
        correlate(core, axis == 0 ? noise : b, a, axis, filters.analysis, 1);
        keep_even(a, axis, core.parallel);
        correlate(core, a, b, axis, filters.refinement, 1);
    }
    subtract(noise, b, core.parallel);
    std::copy_n(noise.values.data(), noise.values.size(), a.values.data());
    const Sides odd{odd_half(sides.width), odd_half(sides.height), sides.axes() == 3 ? odd_half(sides.depth) : 0};
    add_shifted(noise, a, odd, 1, core.parallel);
    return a;
}

Torus make_octaves(Core& core, const Sides& sides, std::uint64_t key, const Wavelet_filters& filters,
                   const Taps& overlap, std::uint32_t octaves, const float* deviations)
{
    Torus sum(&core.memory, sides), noise(&core.memory, sides), a(&core.memory, sides), b(&core.memory, sides);
    std::fill_n(sum.values.data(), sum.values.size(), 0.0F);
    fill_with_white_noise(noise, key, core.parallel);
    double expected = 0.1; // an octave holds a quarter of the next finer one's power
    for (std::uint32_t octave = 0; octave < octaves; ++octave, expected *= 0.25) {
        for (unsigned axis = 0; axis < sides.axes(); ++axis) {
            correlate(core, axis == 0 ? noise : b, a, axis, filters.low_pass, 1U << octave);
            std::swap(a, b);
        }
        subtract(noise, b, core.parallel);
        const double power = power_of(core, noise, overlap);
        if (power > 0.1 * expected) {
            const double factor = static_cast<double>(deviations[octave]) / std::sqrt(power);
            add_shifted(noise, sum, hashed_shift(sides, mix_in(key, octave)), static_cast<float>(factor),
                        core.parallel);
        }
        std::swap(noise, b);
    }
    return sum;
}

} // namespace weft
