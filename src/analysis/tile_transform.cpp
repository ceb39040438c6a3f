/// Small square Fourier transforms: rows, then blocks of columns in place.
#include "analysis/tile_transform.h"
#include <algorithm>

namespace weft {

void TileTransform::forward(const float* tile, Complex* spectrum) const
{
    Array<Complex> half(memory_, std::size_t{blocks_} * fft_lanes);
    Array<float> row(memory_, edge_, Array<float>::unset);
    for (std::size_t y = 0; y < edge_; ++y) {
        std::copy_n(tile + y * edge_, edge_, row.data());
        rows_.forward(row.data(), half.data());
        for (std::size_t b = 0; b < blocks_; ++b)
            std::copy_n(half.data() + b * fft_lanes, fft_lanes, spectrum + b * block_size() + y * fft_lanes);
    }
    for (std::size_t b = 0; b < blocks_; ++b) columns_.forward(spectrum + b * block_size());
}

void TileTransform::backward(Complex* spectrum, float* tile) const
{
    Array<Complex> half(memory_, std::size_t{blocks_} * fft_lanes);
    Array<float> row(memory_, edge_, Array<float>::unset);
    for (std::size_t b = 0; b < blocks_; ++b) columns_.backward(spectrum + b * block_size());
    for (std::size_t y = 0; y < edge_; ++y) {
        for (std::size_t b = 0; b < blocks_; ++b)
            std::copy_n(spectrum + b * block_size() + y * fft_lanes, fft_lanes, half.data() + b * fft_lanes);
        rows_.backward(half.data(), row.data());
        std::copy_n(row.data(), edge_, tile + y * edge_);
    }
}

} // namespace weft
