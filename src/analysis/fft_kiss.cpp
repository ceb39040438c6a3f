/// Fourier transforms by kissfft, for those who cannot use FFTW. The only file that includes kiss_fft.h.
#include "analysis/fft.h"
#include "base/array.h"
#include "base/error.h"
#include <algorithm>
#include <cmath>
#include <kiss_fft.h>

namespace weft {
namespace {

kiss_fft_cpx* kiss(Complex* values) { return reinterpret_cast<kiss_fft_cpx*>(values); }
const kiss_fft_cpx* kiss(const Complex* values) { return reinterpret_cast<const kiss_fft_cpx*>(values); }

Complex product(Complex a, Complex b) noexcept
{
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

bool is_smooth(std::uint32_t length) noexcept
{
    for (const std::uint32_t factor : {2u, 3u, 5u})
        while (length % factor == 0) length /= factor;
    return length == 1;
}

/// kissfft on a length whose prime factors are 2, 3 and 5; its other ones are slow and allocate behind our back.
class Smooth {
public:
    Smooth(std::pmr::memory_resource* memory, std::uint32_t length, bool backward)
    {
        std::size_t bytes = 0;
        kiss_fft_alloc(static_cast<int>(length), backward, nullptr, &bytes);
        state_ = Array<std::byte>(memory, bytes);
        plan_ = kiss_fft_alloc(static_cast<int>(length), backward, state_.data(), &bytes);
        if (!plan_) throw Error(WEFT_ERROR_INTERNAL, "kissfft refuses a transform of length ", length);
    }
    void run(const Complex* from, Complex* to) const { kiss_fft(plan_, kiss(from), kiss(to)); }

private:
    Array<std::byte> state_;
    kiss_fft_cfg plan_ = nullptr;
};

/// A transform of any length: other lengths by a convolution with a chirp (Bluestein 1970), of the next power of two
/// that holds it.
class Transform {
public:
    Transform(std::pmr::memory_resource* memory, std::uint32_t length, bool backward)
        : length_(length), padded_(is_smooth(length) ? length : padded_length(length)),
          first_(memory, padded_, backward)
    {
        if (padded_ == length_) return;
        second_ = std::make_unique<Smooth>(memory, padded_, !backward);
        chirp_ = Array<Complex>(memory, length_);
        Array<Complex> filter(memory, padded_);
        for (std::uint32_t k = 0; k < length_; ++k) {
            const double angle =
                3.141592653589793 * static_cast<double>(std::uint64_t{k} * k % (2 * std::uint64_t{length_})) / length_;
            const double sine = std::sin(angle);
            chirp_[k] = Complex(std::complex<double>(std::cos(angle), backward ? sine : -sine));
            filter[k] = std::conj(chirp_[k]) / static_cast<float>(padded_);
            if (k) filter[padded_ - k] = filter[k];
        }
        filter_ = Array<Complex>(memory, padded_);
        first_.run(filter.data(), filter_.data());
    }

    std::size_t workspace() const noexcept { return padded_ == length_ ? 0 : 2 * std::size_t{padded_}; }
    std::uint32_t length() const noexcept { return length_; }

    /// `work` has workspace() numbers.
    void run(const Complex* from, Complex* to, Complex* work) const
    {
        if (padded_ == length_) return first_.run(from, to);
        Complex* spectrum = work + padded_;
        for (std::uint32_t k = 0; k < length_; ++k) work[k] = product(from[k], chirp_[k]);
        std::fill(work + length_, work + padded_, Complex());
        first_.run(work, spectrum);
        for (std::uint32_t k = 0; k < padded_; ++k) spectrum[k] = product(spectrum[k], filter_[k]);
        second_->run(spectrum, work);
        for (std::uint32_t k = 0; k < length_; ++k) to[k] = product(work[k], chirp_[k]);
    }

private:
    static std::uint32_t padded_length(std::uint32_t length) noexcept
    {
        std::uint32_t padded = 1;
        while (padded < 2 * length - 1) padded *= 2;
        return padded;
    }

    std::uint32_t length_, padded_;
    Smooth first_;
    std::unique_ptr<Smooth> second_;
    Array<Complex> chirp_, filter_;
};

struct TransformPair {
    TransformPair(std::pmr::memory_resource* resource, std::uint32_t length)
        : memory(resource), forward(resource, length, false), backward(resource, length, true)
    {
    }

    std::pmr::memory_resource* memory;
    Transform forward, backward;
};

void run_columns(std::pmr::memory_resource* memory, const Transform& transform, Complex* block)
{
    const std::size_t length = transform.length();
    Array<Complex> column(memory, length), result(memory, length), work(memory, transform.workspace());
    for (std::size_t lane = 0; lane < fft_lanes; ++lane) {
        for (std::size_t y = 0; y < length; ++y) column[y] = block[y * fft_lanes + lane];
        transform.run(column.data(), result.data(), work.data());
        for (std::size_t y = 0; y < length; ++y) block[y * fft_lanes + lane] = result[y];
    }
}

} // namespace

struct RowTransform::Plan : TransformPair {
    using TransformPair::TransformPair;
};

RowTransform::RowTransform(std::pmr::memory_resource* memory, std::uint32_t length) : plan_(new Plan(memory, length)) {}

RowTransform::~RowTransform() = default;

void RowTransform::forward(float* values, Complex* half) const
{
    const std::size_t length = plan_->forward.length();
    Array<Complex> row(plan_->memory, length), whole(plan_->memory, length),
        work(plan_->memory, plan_->forward.workspace());
    std::copy_n(values, length, row.data());
    plan_->forward.run(row.data(), whole.data(), work.data());
    std::copy_n(whole.data(), length / 2 + 1, half);
}

void RowTransform::backward(Complex* half, float* values) const
{
    const std::size_t length = plan_->backward.length();
    Array<Complex> whole(plan_->memory, length), row(plan_->memory, length),
        work(plan_->memory, plan_->backward.workspace());
    for (std::size_t k = 0; k < length; ++k) whole[k] = k <= length / 2 ? half[k] : std::conj(half[length - k]);
    plan_->backward.run(whole.data(), row.data(), work.data());
    for (std::size_t k = 0; k < length; ++k) values[k] = row[k].real();
}

struct ColumnTransform::Plan : TransformPair {
    using TransformPair::TransformPair;
};

ColumnTransform::ColumnTransform(std::pmr::memory_resource* memory, std::uint32_t length)
    : plan_(new Plan(memory, length))
{
}

ColumnTransform::~ColumnTransform() = default;

void ColumnTransform::forward(Complex* block) const { run_columns(plan_->memory, plan_->forward, block); }

void ColumnTransform::backward(Complex* block) const { run_columns(plan_->memory, plan_->backward, block); }

} // namespace weft
