/// What a bi-layer model holds: the structure layer with its masks, how it is put together anew, and a noise per mask.
#pragma once
#include "base/array.h"
#include "model/colour_axes.h"
#include <cstdint>
#include <vector>

namespace weft {

constexpr std::uint32_t most_noises = 6, most_wang_colours = 16, contour_knots = 96;

/// An entry of Exchange::map: number of the patch; depth in eighths of a texel; two bits for patches that began in the
/// cell to the left, or above. As WEFT_MAP_* of backend.h.
constexpr std::uint32_t map_patch = 0x003fffff, map_depth_shift = 22, most_map_depth = 191;

/// Wang tiles without tile images: a cell is composed of the diamonds of its four edges; as weft_wang of backend.h.
struct Wang {
    struct Diamond {
        std::int32_t x, y; ///< of its upper left corner in the structure: within it
    };
    std::uint32_t colours = 0;           ///< n: 0: no Wang tiles, else 2..16
    std::uint32_t width = 0, height = 0; ///< of a cell: even, 4 or more, not above the structure's
    std::uint32_t knots = 0;             ///< intervals of a contour: 2..254
    Array<Diamond> diamonds;             ///< 2 n: those of north edges, then those of west edges
    Array<std::int8_t> contours;         ///< 4 n^2 (knots + 1): depths, in intervals
};

/// Content exchange (Vanhoey et al. 2013, as Guingo et al. 2017 modify it): what a patch may show instead of itself.
struct Exchange {
    struct Patch {
        std::int32_t x, y;          ///< its anchor, in the cell's texels
        std::uint32_t first, count; ///< of its contents: 1..64, the first one being the patch itself
    };
    struct Content {
        std::int32_t x, y;  ///< texel corner of the structure under the anchor
        std::uint32_t turn; ///< in eighths of a full turn: 0..4
        float scale;        ///< of what is shown, against the structure: 0.5..1
    };
    Array<std::uint32_t>
        map;              ///< views x height x width of the cell: 1 view, or the 2 n of Wang tiles; as weft_exchange
    Array<Patch> patches; ///< empty: no exchange
    Array<Content> contents;
    Array<std::uint8_t> contours; ///< contour_knots per content
};

/// The noise under one mask: a texton per principal axis of its colours. All masks' textons share impacts.
struct Noise : Colour_axes {
    Planes coefficients; ///< a plane per channel: of its principal axis
    float mean[16]{};    ///< per channel, added to the noise
};

/// I' (x) = P' (x) + sum over k of M'_k (x) N_k (x) (Guingo et al. 2017, equation 1).
struct Bilayer {
    Planes structure; ///< P's channels, then the masks M_k, whose sum is 1, or 0 where P is all; a torus. Without
                      ///< structure: masks alone
    std::uint32_t plain = 0;   ///< 1: P is the model's mean alone, and `structure` holds only masks; 0: that mean is 0
    std::vector<Noise> noises; ///< K: 1..6
    Planes residual;           ///< N = I - P as it was in the exemplar, for people; may be empty
    Wang wang;
    Exchange exchange;
    /// What the exemplar bears, from measurements: turns as bits 0..4 of eighths of a turn, least scale, amplitude and
    /// wavelength of the smooth distortion in pixels.
    std::uint32_t turns = 1;
    float least_scale = 1, turbulence = 0, wavelength = 96;
};

} // namespace weft
