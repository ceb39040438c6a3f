/// The contour between two diamonds of Wang tiles in a quarter of a cell: a minimal cut from the corner to the centre.
#pragma once
#include "analysis/structure_features.h"
#include "model/bilayer.h"

namespace weft {

/// A quarter of a cell, and how its contours are cut into intervals.
struct Quarter {
    std::uint32_t width, height, knots; ///< of the cell
    std::uint32_t south, east;          ///< 1: the lower, the right half
};

struct Cut {
    float error;  ///< mean along the cut
    float length; ///< in intervals
};

/// Where depth `depth` at knot `knot` lies in the cell, in texels.
struct Place {
    float x, y;
};
Place place_in(const Quarter& quarter, float knot, float depth) noexcept;

/// Finds the contour on which the views of `north` and `west` (upper left corners of their rectangles) differ least,
/// within 0.8 of the distance to the nearer end so that it neither touches the cell's edges nor leaves the quarter.
/// `depths`, of knots + 1, may be NULL.
Cut cut_quarter(std::pmr::memory_resource* memory, const Features& features, const Quarter& quarter,
                Wang::Diamond north, Wang::Diamond west, std::int8_t* depths);

/// Largest depth of a knot.
inline std::int32_t most_depth(std::uint32_t knot, std::uint32_t knots) noexcept
{
    const std::uint32_t end = knot < knots - knot ? knot : knots - knot;
    return static_cast<std::int32_t>(4 * end / 5);
}

} // namespace weft
