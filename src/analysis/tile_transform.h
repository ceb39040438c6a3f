/// Fourier transforms of small square tiles, each on one thread, for estimates that average over many of them.
#pragma once
#include "analysis/spectra.h"

namespace weft {

/// A tile's spectrum is laid out as one picture of Spectra: `frequencies` complex numbers, in blocks of columns, whose
/// padding is zero. The inverse is unnormalised.
class TileTransform {
public:
    TileTransform(Core& core, std::uint32_t edge)
        : edge_(edge), blocks_((edge / 2 + fft_lanes) / fft_lanes), rows_(&core.memory, edge),
          columns_(&core.memory, edge), memory_(&core.memory)
    {
    }

    std::uint32_t edge() const noexcept { return edge_; }
    std::uint32_t blocks() const noexcept { return blocks_; }
    std::size_t block_size() const noexcept { return std::size_t{edge_} * fft_lanes; }
    std::size_t frequencies() const noexcept { return blocks_ * block_size(); }
    /// How often frequency `i` counts in a sum over all: twice if its conjugate is left out, padding never.
    double weight(std::size_t i) const noexcept
    {
        const std::size_t x = i / block_size() * fft_lanes + i % fft_lanes;
        return 2 * x > edge_ ? 0 : x == 0 || 2 * x == edge_ ? 1 : 2;
    }

    void forward(const float* tile, Complex* spectrum) const;
    void backward(Complex* spectrum, float* tile) const; ///< destroys `spectrum`

private:
    std::uint32_t edge_, blocks_;
    RowTransform rows_;
    ColumnTransform columns_;
    std::pmr::memory_resource* memory_;
};

} // namespace weft
