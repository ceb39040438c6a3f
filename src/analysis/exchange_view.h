/// What of a structure a map of patches is made for: all of it, as a torus, or one diamond of Wang tiles.
#pragma once
#include "analysis/structure_features.h"
#include "model/bilayer.h"

namespace weft {

/// A rectangle of the structure, and which of its texels may be exchanged.
struct View {
    std::uint32_t width = 0, height = 0;
    std::int32_t x = 0, y = 0; ///< of its upper left texel in the structure
    bool torus = false;
    Array<std::uint8_t> domain; ///< 1: a texel that may be exchanged

    std::size_t area() const noexcept { return std::size_t{width} * height; }
};

/// The whole structure.
View torus_view(std::pmr::memory_resource* memory, const Features& features);

/// The view of edge `edge` (north edges' colours, then west edges'): what is seen of it whatever its neighbours are,
/// but for the feathers of the contours.
View diamond_view(std::pmr::memory_resource* memory, const Wang& wang, std::uint32_t edge);

} // namespace weft
