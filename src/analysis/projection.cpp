/// The projections' pass: rows in, blocks of columns through, rows out.
#include "analysis/projection.h"
#include "analysis/projection_rows.h"
#include "analysis/white_noise.h"
#include <algorithm>

namespace weft {
namespace {

constexpr std::uint32_t most_runs = 64;

/// DFT of white noise at one frequency of one channel. Columns that hold their own conjugates get them from one half.
Complex noise_at(const Spectra& target, std::uint64_t seed, std::uint32_t c, std::uint32_t x, std::uint32_t y) noexcept
{
    const std::uint32_t opposite = y ? target.height - y : 0;
    const bool folded = x == 0 || 2 * x == target.width;
    const std::uint32_t from = folded ? std::min(y, opposite) : y;
    const Complex value = normal_pair(seed, (std::uint64_t{c} << 32 | x) << 16 | from);
    if (!folded) return value;
    if (y == opposite) return value.real() * 1.41421356f;
    return y == from ? value : std::conj(value);
}

} // namespace

Projection::Projection(Core& core, const Spectra& target, const SplineSamples& samples, std::uint32_t support)
    : core_(core), target_(target), support_(support),
      runs_(std::min({core.parallel.width(), target.blocks(), most_runs})), rows_(&core.memory, target.width),
      columns_(&core.memory, target.height),
      b_x_(spline_spectrum(&core.memory, samples, target.width, target.blocks() * fft_lanes)),
      b_y_(spline_spectrum(&core.memory, samples, target.height, target.height)),
      half_(&core.memory, std::size_t{target.blocks()} * target.count * support * fft_lanes),
      scratch_(&core.memory, std::size_t{runs_} * target.count * target.block_size())
{
}

template <class Body> void Projection::for_each_block(const Body& body)
{
    const std::size_t size = target_.count * target_.block_size();
    core_.parallel.for_each_index(runs_, [&](std::uint32_t run) {
        const std::uint32_t last = target_.blocks() * (run + 1) / runs_;
        for (std::uint32_t b = target_.blocks() * run / runs_; b < last; ++b) body(b, scratch_.data() + run * size);
    });
}

void Projection::rows_forward(const Planes& coefficients)
{
    for_each_run(core_.parallel, target_.count * support_, [&](std::uint32_t first, std::uint32_t last) {
        Array<float> row(&core_.memory, target_.width, Array<float>::unset);
        Array<Complex> half(&core_.memory, std::size_t{target_.blocks()} * fft_lanes);
        const std::size_t block = std::size_t{target_.count} * support_ * fft_lanes;
        for (std::size_t i = first; i < last; ++i) { // row i % support of channel i / support
            std::fill(std::copy_n(coefficients.values.data() + i * support_, support_, row.data()), row.end(), 0.0f);
            rows_.forward(row.data(), half.data());
            for (std::size_t b = 0; b < target_.blocks(); ++b)
                std::copy_n(half.data() + b * fft_lanes, fft_lanes, half_.data() + b * block + i * fft_lanes);
        }
    });
}

void Projection::rows_backward(Planes& result)
{
    for_each_run(core_.parallel, target_.count * support_, [&](std::uint32_t first, std::uint32_t last) {
        Array<float> row(&core_.memory, target_.width, Array<float>::unset);
        Array<Complex> half(&core_.memory, std::size_t{target_.blocks()} * fft_lanes);
        const std::size_t block = std::size_t{target_.count} * support_ * fft_lanes;
        const float scale = 1.0f / (static_cast<float>(target_.width) * static_cast<float>(target_.height));
        for (std::size_t i = first; i < last; ++i) {
            for (std::size_t b = 0; b < target_.blocks(); ++b)
                std::copy_n(half_.data() + b * block + i * fft_lanes, fft_lanes, half.data() + b * fft_lanes);
            rows_.backward(half.data(), row.data());
            float* to = result.values.data() + i * support_;
            for (std::uint32_t x = 0; x < support_; ++x) to[x] = row[x] * scale;
        }
    });
}

void Projection::columns_forward(std::uint32_t b, Complex* block) const
{
    const std::size_t size = target_.block_size(), rows = std::size_t{support_} * fft_lanes;
    for (std::size_t c = 0; c < target_.count; ++c) {
        Complex* to = block + c * size;
        std::fill(std::copy_n(half_.data() + (b * target_.count + c) * rows, rows, to), to + size, Complex());
        columns_.forward(to);
    }
}

void Projection::columns_backward(std::uint32_t b, Complex* block)
{
    const std::size_t size = target_.block_size(), rows = std::size_t{support_} * fft_lanes;
    for (std::size_t c = 0; c < target_.count; ++c) {
        columns_.backward(block + c * size);
        std::copy_n(block + c * size, rows, half_.data() + (b * target_.count + c) * rows);
    }
}

void Projection::start(std::uint64_t seed, Planes& result)
{
    for_each_block([&](std::uint32_t b, Complex* block) {
        for (std::uint32_t c = 0; c < target_.count; ++c)
            for (std::uint32_t y = 0; y < target_.height; ++y)
                for (std::uint32_t i = 0; i < fft_lanes; ++i)
                    block[c * target_.block_size() + y * fft_lanes + i] =
                        noise_at(target_, seed, c, b * fft_lanes + i, y);
        project_rows(target_, b, b_x_.data(), b_y_.data(), true, 0, block);
        columns_backward(b, block);
    });
    rows_backward(result);
}

void Projection::apply(Form form, float smoothing, const Planes& coefficients, Planes& result)
{
    rows_forward(coefficients);
    for_each_block([&](std::uint32_t b, Complex* block) {
        columns_forward(b, block);
        project_rows(target_, b, b_x_.data(), b_y_.data(), form == algorithm_1, smoothing, block);
        columns_backward(b, block);
    });
    rows_backward(result);
}

ModelSums Projection::measure(const Planes& coefficients)
{
    Array<ModelSums> sums(&core_.memory, target_.blocks());
    rows_forward(coefficients);
    for_each_block([&](std::uint32_t b, Complex* block) {
        columns_forward(b, block);
        sums[b] = measure_rows(target_, b, b_x_.data(), b_y_.data(), block);
    });
    ModelSums total;
    for (const ModelSums& part : sums) {
        total.agreement += part.agreement;
        total.power += part.power;
    }
    return total;
}

} // namespace weft
