/// Gaussian neighbourhoods around the cells of a grid, and the distributions of values in them.
#pragma once
#include "base/array.h"
#include "base/core.h"
#include "base/progress.h"

namespace weft {

/// Cells of equal size that cover a tile, around the torus; the deviation of a cell's neighbourhood may differ from
/// cell to cell.
class Neighbourhoods {
public:
    /// `factors` of `sigma` (in parts of the shorter side), one plane stretched over the tile, or NULL. Cells are
    /// `spacing` pixels wide, or a quarter of the least deviation if that is more.
    Neighbourhoods(Core& core, std::uint32_t width, std::uint32_t height, float sigma, const Planes* factors,
                   std::uint32_t spacing);

    std::uint32_t width() const noexcept { return width_; }
    std::uint32_t height() const noexcept { return height_; }
    std::uint32_t columns() const noexcept { return columns_; }
    std::uint32_t rows() const noexcept { return rows_; }
    std::size_t cells() const noexcept { return std::size_t{columns_} * rows_; }

    /// Each cell's `size` values become their weighted mean in its neighbourhood.
    void average(Core& core, Array<float>& values, std::uint32_t size, const Progress& progress) const;

private:
    /// A deviation that cells have, or between two of which theirs lies.
    struct Step {
        float sigma; ///< in pixels
        Array<float> across, down;
    };
    static constexpr std::uint32_t most_steps = 8;

    float share(std::uint32_t step, std::size_t cell) const noexcept;
    void blur(Core& core, const Step& step, const Array<float>& from, std::uint32_t size, Array<float>& to,
              const Progress& progress) const;

    std::uint32_t width_, height_, columns_, rows_;
    std::uint32_t steps_ = 1;
    Step step_[most_steps];
    Array<float> positions_; ///< for each cell, between which steps; empty for a single step
};

constexpr std::uint32_t local_bins = 32, local_edges = local_bins + 1;

/// Histograms of planes: of each plane as a whole, and in the neighbourhood of each cell. Values are counted in the
/// coordinate z that goes from 0.5 for the least to local_bins - 0.5 for the greatest; each goes to the two nearest
/// bins, whose middles lie at 0.5, 1.5, ...
struct Local_distributions {
    struct Range {
        float low, scale; ///< z = (value - low) * scale + 0.5

        float to_z(float value) const noexcept { return (value - low) * scale + 0.5f; }
        float from_z(float z) const noexcept { return (z - 0.5f) / scale + low; }
    };
    Array<Range> ranges;
    Array<float> whole; ///< plane after plane, sum 1
    Array<float> local; ///< cell after cell of plane after plane, sum 1

    Local_distributions(Core& core, const Planes& planes, const Neighbourhoods& neighbourhoods,
                        const Progress& progress);
};

} // namespace weft
