/// Gaussian-weighted sums of functions of an image's values, around the positions of a grid.
#pragma once
#include "base/array.h"
#include "base/core.h"
#include "base/progress.h"
#include <functional>

namespace weft {

/// Positions in the middles of equal parts of an image that repeats.
struct Local_grid {
    std::uint32_t columns, rows;
    std::size_t count() const noexcept { return std::size_t{columns} * rows; }
};

/// What one value adds: up to four sums and how much to each.
struct Share {
    std::uint32_t count;
    std::uint32_t index[4];
    double amount[4];
};

/// For each grid position and each of `sums` sums, the mean of the shares of all pixels: weights are those of a
/// Gaussian of deviation `sigma` pixels in the distance around the torus, along each axis. Sums of a position lie
/// together.
Array<double> local_sums(Core& core, const float* plane, std::uint32_t width, std::uint32_t height,
                         const Local_grid& grid, double sigma, std::uint32_t sums,
                         const std::function<Share(float)>& share_of, const Progress& progress);

} // namespace weft
