/// The projections' pass: rows in, blocks of columns through, rows out.
#include "analysis/projection.h"
#include "analysis/white_noise.h"
#include <algorithm>
#include <cmath>

namespace weft {

namespace { constexpr std::uint32_t most_runs = 64; }

Projection::Projection(Core& core, const Spectra& target, const SplineSamples& samples, std::uint32_t support, Form form)
    : core_(core), target_(target), support_(support), form_(form), rows_(&core.memory, target.width),
      columns_(&core.memory, target.height),
      b_x_(spline_spectrum(&core.memory, samples, target.width, target.blocks() * fft_lanes)),
      b_y_(spline_spectrum(&core.memory, samples, target.height, target.height)),
      half_(&core.memory, std::size_t{target.blocks()} * target.count * support * fft_lanes),
      runs_(std::min({core.parallel.width(), target.blocks(), most_runs}))
{
    scratch_ = Array<Complex>(&core.memory, std::size_t{runs_} * target.count * target.block_size());
}

template <class Fill, class Use> void Projection::for_each_block(const Fill& fill, const Use& use)
{
    const std::size_t size = target_.count * target_.block_size();
    core_.parallel.for_each_index(runs_, [&](std::uint32_t run) {
        const std::uint32_t first = target_.blocks() * run / runs_, last = target_.blocks() * (run + 1) / runs_;
        Complex* block = scratch_.data() + run * size;
        for (std::uint32_t b = first; b < last; ++b) {
            fill(b, block);
            use(b, block);
        }
    });
}

void Projection::rows_forward(const Planes& coefficients)
{
    const std::size_t row_size = fft_lanes, plane_size = support_ * row_size, block_size = target_.count * plane_size;
    for_each_run(core_.parallel, target_.count * support_, [&](std::uint32_t first, std::uint32_t last) {
        Array<float> row(&core_.memory, target_.width, Array<float>::unset);
        Array<Complex> half(&core_.memory, std::size_t{target_.blocks()} * fft_lanes);
        for (std::uint32_t i = first; i < last; ++i) {
            std::fill(std::copy_n(coefficients.values.data() + std::size_t{i} * support_, support_, row.data()), row.end(), 0.0f);
            rows_.forward(row.data(), half.data());
            Complex* to = half_.data() + i / support_ * plane_size + i % support_ * row_size;
            for (std::size_t b = 0; b < target_.blocks(); ++b)
                std::copy_n(half.data() + b * fft_lanes, fft_lanes, to + b * block_size);
        }
    });
}

void Projection::rows_backward(Planes& result)
{
    const std::size_t row_size = fft_lanes, plane_size = support_ * row_size, block_size = target_.count * plane_size;
    const float scale = 1.0f / (static_cast<float>(target_.width) * static_cast<float>(target_.height));
    for_each_run(core_.parallel, target_.count * support_, [&](std::uint32_t first, std::uint32_t last) {
        Array<float> row(&core_.memory, target_.width, Array<float>::unset);
        Array<Complex> half(&core_.memory, std::size_t{target_.blocks()} * fft_lanes);
        for (std::uint32_t i = first; i < last; ++i) {
            const Complex* from = half_.data() + i / support_ * plane_size + i % support_ * row_size;
            for (std::size_t b = 0; b < target_.blocks(); ++b)
                std::copy_n(from + b * block_size, fft_lanes, half.data() + b * fft_lanes);
            rows_.backward(half.data(), row.data());
            float* to = result.values.data() + std::size_t{i} * support_;
            for (std::uint32_t x = 0; x < support_; ++x) to[x] = row[x] * scale;
        }
    });
}

/// Projects one block of all channels in place, or only measures it.
ModelSums Projection::project(std::uint32_t b, Complex* block, bool write) const
{
    const std::size_t size = target_.block_size() * 2;
    const std::uint32_t channels = target_.count;
    const float* target = reinterpret_cast<const float*>(target_.block(b, 0));
    float* values = reinterpret_cast<float*>(block);
    float b_x[fft_lanes];
    double weight[fft_lanes], agreement[fft_lanes] = {}, power[fft_lanes] = {};
    for (std::uint32_t i = 0; i < fft_lanes; ++i) {
        b_x[i] = b_x_[b * fft_lanes + i];
        weight[i] = static_cast<double>(target_.weight(b * fft_lanes + i));
    }
    for (std::uint32_t y = 0; y < target_.height; ++y) {
        float real[fft_lanes] = {}, imaginary[fft_lanes] = {}, norm[fft_lanes] = {}, with_target[fft_lanes], with_own[fft_lanes];
        const float* t = target + std::size_t{y} * 2 * fft_lanes;
        float* a = values + std::size_t{y} * 2 * fft_lanes;
        for (std::uint32_t c = 0; c < channels; ++c)
            for (std::uint32_t i = 0; i < fft_lanes; ++i) {
                const float t_r = t[c * size + 2 * i], t_i = t[c * size + 2 * i + 1];
                const float a_r = a[c * size + 2 * i], a_i = a[c * size + 2 * i + 1];
                real[i] += t_r * a_r + t_i * a_i;
                imaginary[i] += t_r * a_i - t_i * a_r;
                norm[i] += a_r * a_r + a_i * a_i;
            }
        for (std::uint32_t i = 0; i < fft_lanes; ++i) {
            const float b_xy = b_x[i] * b_y_[y];
            const float modulus = std::sqrt(real[i] * real[i] + imaginary[i] * imaginary[i]);
            agreement[i] += static_cast<double>(modulus);
            power[i] += static_cast<double>(norm[i] * b_xy);
            with_target[i] = 1.0f / std::max(modulus, 1e-30f);
            with_own[i] = b_xy;
        }
        if (!write) continue;
        if (form_ == algorithm_1)
            for (std::uint32_t i = 0; i < fft_lanes; ++i) {
                with_target[i] /= with_own[i];
                with_own[i] = 0;
            }
        for (std::uint32_t i = 0; i < fft_lanes; ++i) {
            real[i] *= with_target[i];
            imaginary[i] *= with_target[i];
        }
        for (std::uint32_t c = 0; c < channels; ++c)
            for (std::uint32_t i = 0; i < fft_lanes; ++i) {
                const float t_r = t[c * size + 2 * i], t_i = t[c * size + 2 * i + 1];
                float& a_r = a[c * size + 2 * i];
                float& a_i = a[c * size + 2 * i + 1];
                a_r = t_r * real[i] - t_i * imaginary[i] - with_own[i] * a_r;
                a_i = t_r * imaginary[i] + t_i * real[i] - with_own[i] * a_i;
            }
    }
    ModelSums sums;
    for (std::uint32_t i = 0; i < fft_lanes; ++i) {
        sums.agreement += weight[i] * agreement[i];
        sums.power += weight[i] * power[i];
    }
    return sums;
}

/// DFT of white noise at one frequency, of one channel. Columns that hold their own conjugates get them from one half.
static Complex noise_at(const Spectra& target, std::uint64_t seed, std::uint32_t c, std::uint32_t x, std::uint32_t y)
{
    const std::uint32_t opposite = y ? target.height - y : 0;
    const bool folded = x == 0 || 2 * x == target.width;
    const std::uint32_t from = folded ? std::min(y, opposite) : y;
    const Complex value = normal_pair(seed, (std::uint64_t{c} << 32 | x) << 16 | from);
    if (!folded) return value;
    if (y == opposite) return value.real() * 1.41421356f;
    return y == from ? value : std::conj(value);
}

void Projection::start(std::uint64_t seed, Planes& result)
{
    const std::size_t size = target_.block_size(), rows = std::size_t{support_} * fft_lanes;
    for_each_block(
        [&](std::uint32_t b, Complex* block) {
            for (std::uint32_t c = 0; c < target_.count; ++c)
                for (std::uint32_t y = 0; y < target_.height; ++y)
                    for (std::uint32_t i = 0; i < fft_lanes; ++i)
                        block[c * size + y * fft_lanes + i] = noise_at(target_, seed, c, b * fft_lanes + i, y);
        },
        [&](std::uint32_t b, Complex* block) {
            project(b, block, true);
            for (std::uint32_t c = 0; c < target_.count; ++c) {
                columns_.backward(block + c * size);
                std::copy_n(block + c * size, rows, half_.data() + (b * target_.count + c) * rows);
            }
        });
    rows_backward(result);
}

ModelSums Projection::apply(const Planes& coefficients, Planes& result)
{
    const std::size_t size = target_.block_size(), rows = std::size_t{support_} * fft_lanes;
    Array<ModelSums> sums(&core_.memory, target_.blocks());
    rows_forward(coefficients);
    for_each_block(
        [&](std::uint32_t b, Complex* block) {
            for (std::uint32_t c = 0; c < target_.count; ++c) {
                Complex* to = block + c * size;
                std::fill(std::copy_n(half_.data() + (b * target_.count + c) * rows, rows, to), to + size, Complex());
                columns_.forward(to);
            }
        },
        [&](std::uint32_t b, Complex* block) {
            sums[b] = project(b, block, true);
            for (std::uint32_t c = 0; c < target_.count; ++c) {
                columns_.backward(block + c * size);
                std::copy_n(block + c * size, rows, half_.data() + (b * target_.count + c) * rows);
            }
        });
    rows_backward(result);
    ModelSums total;
    for (const ModelSums& part : sums) {
        total.agreement += part.agreement;
        total.power += part.power;
    }
    return total;
}

} // namespace weft
