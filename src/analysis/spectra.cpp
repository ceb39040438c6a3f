/// Two-dimensional Fourier transforms: rows first, then blocks of columns in place.
#include "analysis/spectra.h"
#include <algorithm>

namespace weft {

std::uint32_t fast_length(std::uint32_t least) noexcept
{
    for (std::uint32_t length = least;; ++length) {
        std::uint32_t rest = length;
        for (const std::uint32_t factor : {2u, 3u, 5u})
            while (rest % factor == 0) rest /= factor;
        if (rest == 1) return length;
    }
}

PlaneTransform::PlaneTransform(Core& core, std::uint32_t width, std::uint32_t height)
    : core_(core), width_(width), height_(height), rows_(&core.memory, width), columns_(&core.memory, height)
{
}

void PlaneTransform::forward(const float* plane, Spectra& spectra, std::uint32_t picture) const
{
    for_each_run(core_.parallel, height_, [&](std::uint32_t first, std::uint32_t last) {
        Array<float> row(&core_.memory, width_, Array<float>::unset);
        Array<Complex> half(&core_.memory, std::size_t{spectra.blocks()} * fft_lanes);
        for (std::size_t y = first; y < last; ++y) {
            std::copy_n(plane + y * width_, width_, row.data());
            rows_.forward(row.data(), half.data());
            for (std::size_t b = 0; b < spectra.blocks(); ++b)
                std::copy_n(half.data() + b * fft_lanes, fft_lanes, spectra.block(b, picture) + y * fft_lanes);
        }
    });
    for_each_run(core_.parallel, spectra.blocks(), [&](std::uint32_t first, std::uint32_t last) {
        for (std::size_t b = first; b < last; ++b) columns_.forward(spectra.block(b, picture));
    });
}

void PlaneTransform::backward(Spectra& spectra, std::uint32_t picture, float* plane) const
{
    for_each_run(core_.parallel, spectra.blocks(), [&](std::uint32_t first, std::uint32_t last) {
        for (std::size_t b = first; b < last; ++b) columns_.backward(spectra.block(b, picture));
    });
    for_each_run(core_.parallel, height_, [&](std::uint32_t first, std::uint32_t last) {
        Array<float> row(&core_.memory, width_, Array<float>::unset);
        Array<Complex> half(&core_.memory, std::size_t{spectra.blocks()} * fft_lanes);
        for (std::size_t y = first; y < last; ++y) {
            for (std::size_t b = 0; b < spectra.blocks(); ++b)
                std::copy_n(spectra.block(b, picture) + y * fft_lanes, fft_lanes, half.data() + b * fft_lanes);
            rows_.backward(half.data(), row.data());
            std::copy_n(row.data(), width_, plane + y * width_);
        }
    });
}

} // namespace weft
