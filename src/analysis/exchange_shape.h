/// A patch by itself: its texels around an anchor, and how its surroundings turn into those of a content.
#pragma once
#include "analysis/exchange_patches.h"

namespace weft {

constexpr std::uint32_t turns_offered = 5, scales_offered = 3;
constexpr float offered_scale[scales_offered] = {1, 0.8f, 0.63f};

/// Texels from a patch's anchor -> texels of the structure: a rotation by eighths of a turn, over the scale.
struct Turning {
    float m[4];

    Turning(std::uint32_t eighths, float scale) noexcept;
    float x(float dx, float dy) const noexcept { return m[0] * dx + m[1] * dy; }
    float y(float dx, float dy) const noexcept { return m[2] * dx + m[3] * dy; }
};

/// Where a patch lies in the cell: texels beyond the right or lower border are those of the next cells.
struct Patch_frame {
    std::int32_t left, top, right, bottom; ///< right and bottom beyond its texels
    std::int32_t x, y;                     ///< anchor: its middle
};

Array<Patch_frame> frames_of(std::pmr::memory_resource* memory, const View& view, const Patches_of_view& patches);

struct Patch_shape {
    struct Texel {
        float dx, dy; ///< from the anchor to its middle
        std::uint8_t depth;
        Feature feature;
    };
    std::int32_t x, y;    ///< the anchor, in the structure: it may lie beyond a torus' border
    std::uint8_t deepest; ///< depth
    Array<Texel> texels;  ///< all that are not deeper than the zone in which contours lie
};

constexpr std::uint32_t zone_depth = 14 * 8;

Patch_shape shape_of(std::pmr::memory_resource* memory, const Features& features, const View& view,
                     const Patches_of_view& patches, const Patch_frame& frame, std::uint32_t patch);

} // namespace weft
