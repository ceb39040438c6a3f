/// Two-dimensional Fourier transforms of real pictures, in parallel, in an order that no number of threads changes.
#pragma once
#include "analysis/fft.h"
#include "base/array.h"
#include "base/core.h"

namespace weft {

/// DFTs of `count` real pictures of one size: columns 0 .. width / 2, the others being their conjugates. They lie in
/// blocks of fft_lanes columns, so that a thread takes one block of all pictures through its cache; columns beyond
/// width / 2 in the last block are padding.
struct Spectra {
    std::uint32_t width = 0, height = 0, count = 0;
    Array<Complex> values;

    Spectra() = default;
    Spectra(std::pmr::memory_resource* memory, std::uint32_t w, std::uint32_t h, std::uint32_t n)
        : width(w), height(h), count(n),
          values(memory, std::size_t{(w / 2 + fft_lanes) / fft_lanes} * n * h * fft_lanes)
    {
    }

    std::uint32_t columns() const noexcept { return width / 2 + 1; }
    std::uint32_t blocks() const noexcept { return (columns() + fft_lanes - 1) / fft_lanes; }
    std::size_t block_size() const noexcept { return std::size_t{height} * fft_lanes; }
    Complex* block(std::size_t b, std::size_t picture) noexcept
    {
        return values.data() + (b * count + picture) * block_size();
    }
    const Complex* block(std::size_t b, std::size_t picture) const noexcept
    {
        return values.data() + (b * count + picture) * block_size();
    }
    Complex& at(std::size_t picture, std::size_t x, std::size_t y) noexcept
    {
        return block(x / fft_lanes, picture)[y * fft_lanes + x % fft_lanes];
    }
    const Complex& at(std::size_t picture, std::size_t x, std::size_t y) const noexcept
    {
        return block(x / fft_lanes, picture)[y * fft_lanes + x % fft_lanes];
    }
    /// How often column x counts in a sum over all frequencies: twice if a conjugate column is left out, padding never.
    float weight(std::size_t x) const noexcept
    {
        return x >= columns() ? 0.0f : x == 0 || 2 * x == width ? 1.0f : 2.0f;
    }
};

/// Cuts `count` pieces of work into at most a few runs per thread and calls body(first, last) for each.
template <class Body> void for_each_run(Parallel& parallel, std::uint32_t count, const Body& body)
{
    const std::uint32_t width = parallel.width(),
                        runs = width > 1 ? (count < 4 * width ? count : 4 * width) : (count ? 1 : 0);
    parallel.for_each_index(runs, [&](std::uint32_t run) {
        const auto bound = [&](std::uint32_t i) { return static_cast<std::uint32_t>(std::uint64_t{count} * i / runs); };
        body(bound(run), bound(run + 1));
    });
}

/// The least length from `least` on with no prime factor above 5: transforms of such lengths are fast.
std::uint32_t fast_length(std::uint32_t least) noexcept;

/// DFTs of pictures of one size, unnormalised.
class PlaneTransform {
public:
    PlaneTransform(Core& core, std::uint32_t width, std::uint32_t height);

    /// Picture `picture` of `spectra` <- DFT of the width * height floats at `plane`.
    void forward(const float* plane, Spectra& spectra, std::uint32_t picture) const;
    /// The inverse times width * height; destroys that picture's spectrum.
    void backward(Spectra& spectra, std::uint32_t picture, float* plane) const;

private:
    Core& core_;
    std::uint32_t width_, height_;
    RowTransform rows_;
    ColumnTransform columns_;
};

} // namespace weft
