/// Local spectra: Welch's mean of windowed periodograms around every pixel (Guingo et al. 2017, section 3.3).
#pragma once
#include "base/array.h"
#include "base/core.h"
#include "base/progress.h"

namespace weft {

/// `size` numbers per pixel: the magnitudes of half the plane of frequencies, those that stand for two of them times
/// the root of 2, so that the distance of two pixels' numbers is that of their whole spectra.
struct Local_spectra {
    std::uint32_t width = 0, height = 0, size = 0;
    Array<float> values; ///< [y][number][x]

    float* row(std::size_t y, std::size_t number) noexcept { return values.data() + (y * size + number) * width; }
    const float* row(std::size_t y, std::size_t number) const noexcept
    {
        return values.data() + (y * size + number) * width;
    }
};

/// Of `window` x `window` pixels, 2, 4, 8 or 16, at most half the picture's shorter side. The periodograms, under a
/// Hann window of unit sum, are those of nine segments at half overlap around the pixel, moved inwards at borders.
Local_spectra local_spectra_of(Core& core, const float* luminance, std::uint32_t width, std::uint32_t height,
                               std::uint32_t window, const Progress& progress);

/// Calls body(first, last) for groups of rows that take a moment each, reporting progress before every one.
template <class Body>
void for_each_group(std::uint32_t rows, std::size_t work_per_row, const Progress& progress, const Body& body)
{
    constexpr std::size_t moment = 1U << 24;
    const auto step =
        static_cast<std::uint32_t>(work_per_row < moment ? moment / (work_per_row ? work_per_row : 1) : 1);
    for (std::uint32_t first = 0; first < rows; first += step) {
        progress.at(static_cast<double>(first) / rows);
        body(first, rows - first < step ? rows : first + step);
    }
}

} // namespace weft
