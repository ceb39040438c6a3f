/// The projections' arithmetic, in lanes that a compiler turns into vectors.
#include "analysis/projection_rows.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr std::uint32_t lanes = fft_lanes;
constexpr float least_modulus = 1e-30f; // what is below is 0: its phase means nothing

struct Lanes {
    float real[lanes] = {}, imaginary[lanes] = {};
};

/// The complex numbers of one row, real and imaginary parts apart.
Lanes load(const float* row) noexcept
{
    Lanes value;
    for (std::uint32_t i = 0; i < lanes; ++i) {
        value.real[i] = row[2 * i];
        value.imaginary[i] = row[2 * i + 1];
    }
    return value;
}

/// T*a over the channels. A channel is `step` floats.
Lanes inner_product(const float* target, const float* values, std::size_t step, std::uint32_t channels) noexcept
{
    Lanes sum;
    for (std::uint32_t c = 0; c < channels; ++c) {
        const Lanes t = load(target + c * step), a = load(values + c * step);
        for (std::uint32_t i = 0; i < lanes; ++i) {
            sum.real[i] += t.real[i] * a.real[i] + t.imaginary[i] * a.imaginary[i];
            sum.imaginary[i] += t.real[i] * a.imaginary[i] - t.imaginary[i] * a.real[i];
        }
    }
    return sum;
}

/// a <- T s - own a, channel by channel.
void combine(const float* target, const Lanes& s, const float* own, float* values, std::size_t step,
             std::uint32_t channels) noexcept
{
    for (std::uint32_t c = 0; c < channels; ++c) {
        float* row = values + c * step;
        const Lanes t = load(target + c * step), a = load(row);
        for (std::uint32_t i = 0; i < lanes; ++i) {
            row[2 * i] = t.real[i] * s.real[i] - t.imaginary[i] * s.imaginary[i] - own[i] * a.real[i];
            row[2 * i + 1] = t.real[i] * s.imaginary[i] + t.imaginary[i] * s.real[i] - own[i] * a.imaginary[i];
        }
    }
}

const float* floats(const Complex* values) noexcept { return reinterpret_cast<const float*>(values); }

} // namespace

void project_rows(const Spectra& target, std::uint32_t b, const float* b_x, const float* b_y, bool only_phases,
                  float smoothing, Complex* block) noexcept
{
    const std::size_t step = 2 * target.block_size();
    for (std::uint32_t y = 0; y < target.height; ++y) {
        const float* t = floats(target.block(b, 0)) + std::size_t{y} * 2 * lanes;
        float* a = reinterpret_cast<float*>(block) + std::size_t{y} * 2 * lanes;
        Lanes s = inner_product(t, a, step, target.count);
        float own[lanes];
        for (std::uint32_t i = 0; i < lanes; ++i) {
            const float b_here = b_x[b * lanes + i] * b_y[y];
            const float square = s.real[i] * s.real[i] + s.imaginary[i] * s.imaginary[i] + smoothing * smoothing;
            const float modulus = std::max(std::sqrt(square), least_modulus),
                        factor = only_phases ? 1 / (modulus * b_here) : 1 / modulus;
            s.real[i] *= factor;
            s.imaginary[i] *= factor;
            own[i] = only_phases ? 0 : b_here;
        }
        combine(t, s, own, a, step, target.count);
    }
}

ModelSums measure_rows(const Spectra& target, std::uint32_t b, const float* b_x, const float* b_y,
                       const Complex* block) noexcept
{
    const std::size_t step = 2 * target.block_size();
    ModelSums sums;
    for (std::uint32_t y = 0; y < target.height; ++y) {
        const float* t = floats(target.block(b, 0)) + std::size_t{y} * 2 * lanes;
        const float* a = floats(block) + std::size_t{y} * 2 * lanes;
        const Lanes product = inner_product(t, a, step, target.count);
        for (std::uint32_t i = 0; i < lanes; ++i) {
            const double weight = static_cast<double>(target.weight(b * lanes + i));
            double power = 0;
            for (std::uint32_t c = 0; c < target.count; ++c) {
                const double real = static_cast<double>(a[c * step + 2 * i]),
                             imaginary = static_cast<double>(a[c * step + 2 * i + 1]);
                power += real * real + imaginary * imaginary;
            }
            sums.power += weight * power * static_cast<double>(b_x[b * lanes + i] * b_y[y]);
            sums.agreement += weight * static_cast<double>(std::sqrt(product.real[i] * product.real[i] +
                                                                     product.imaginary[i] * product.imaginary[i]));
        }
    }
    return sums;
}

} // namespace weft
