/// One-dimensional Fourier transforms, unnormalised: the little that fft_fftw.cpp or fft_kiss.cpp must offer.
#pragma once
#include <complex>
#include <cstdint>
#include <memory>
#include <memory_resource>

namespace weft {

using Complex = std::complex<float>;

/// How many columns are transformed side by side: a cache line of complex numbers.
constexpr std::uint32_t fft_lanes = 8;

/// `length` real values <-> the first length / 2 + 1 values of their transform. Any length from 1 on. Immutable, so
/// that many threads may transform at once; arrays are 64-byte aligned.
class RowTransform {
public:
    RowTransform(std::pmr::memory_resource* memory, std::uint32_t length);
    ~RowTransform();
    void forward(float* values, Complex* half) const;  ///< may destroy `values`
    void backward(Complex* half, float* values) const; ///< destroys `half`; length times the inverse

private:
    struct Plan;
    std::unique_ptr<Plan> plan_;
};

/// Transforms fft_lanes complex columns of `length` in place; value y of column i is block[y * fft_lanes + i].
class ColumnTransform {
public:
    ColumnTransform(std::pmr::memory_resource* memory, std::uint32_t length);
    ~ColumnTransform();
    void forward(Complex* block) const;
    void backward(Complex* block) const; ///< length times the inverse

private:
    struct Plan;
    std::unique_ptr<Plan> plan_;
};

} // namespace weft
