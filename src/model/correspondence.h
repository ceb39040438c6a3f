/// Where the patches of a tile come from.
#pragma once
#include "base/array.h"

namespace weft {

constexpr std::uint32_t most_patch_side = 31, most_vote = 16;

/// For one pixel of the tile, the centre of the photo's patch that it was matched to, and the weight of its vote.
struct Match {
    std::uint16_t x, y;
    std::uint16_t weight; ///< 1..16
};

/// The correspondence between a tile and its photo: each pixel of the tile is the mean, by the votes' weights, of what
/// the patches around it propose.
struct Correspondence {
    std::uint32_t width = 0, height = 0;             ///< of the tile
    std::uint32_t photo_width = 0, photo_height = 0; ///< every patch lies within
    std::uint32_t patch_side = 0;                    ///< odd, 1..31
    Array<Match> matches;                            ///< row by row

    std::uint32_t reach() const noexcept { return patch_side / 2; }
};

} // namespace weft
