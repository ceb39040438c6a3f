/// Where in the structure the surroundings of a patch are found again, turned and scaled.
#pragma once
#include "analysis/exchange_shape.h"

namespace weft {

/// A part of the structure, in texels; right and bottom lie beyond it.
struct Bounds {
    std::int32_t left, top, right, bottom;
};

/// The structure at full resolution, as contents of each scale show it, and at the search's.
struct Search_pictures {
    Features scaled[scales_offered];
    Planes coarse; ///< the four features
    std::uint32_t level = 0;
    Bounds bounds{}; ///< contents lie within: the border of a torus may be visible
};
Search_pictures search_pictures_of(Core& core, const Features& features, const Bounds& bounds);

struct Found {
    std::uint32_t turn, scale; ///< of those offered
    std::int32_t x, y;         ///< texel corner of the structure under the anchor
    float error;               ///< mean, near the patch's border
};

constexpr std::uint32_t most_found = 4;

/// Fills `found` with the best places for one transform, which do not overlap much; returns how many.
std::uint32_t find_contents(std::pmr::memory_resource* memory, const Search_pictures& pictures,
                            const Patch_shape& shape, std::uint32_t turn, std::uint32_t scale, Found* found);

} // namespace weft
