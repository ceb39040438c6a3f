/// For each pixel of a tile, where in the exemplar the middle of its patch lies.
#pragma once
#include "analysis/lab_picture.h"

namespace weft {

struct Place {
    std::uint16_t x, y;
};

inline bool operator==(Place a, Place b) noexcept { return a.x == b.x && a.y == b.y; }

struct Match_field {
    std::uint32_t width = 0, height = 0; ///< of the tile
    std::uint32_t reach = 0;             ///< a patch is 2 reach + 1 pixels a side
    Array<Place> places;
    Array<std::uint64_t> costs;  ///< of the last search
    Array<std::uint8_t> weights; ///< of the votes

    Match_field() = default;
    Match_field(std::pmr::memory_resource* memory, std::uint32_t w, std::uint32_t h, std::uint32_t r);

    std::size_t area() const noexcept { return std::size_t{width} * height; }
    std::uint32_t patch_pixels() const noexcept { return (2 * reach + 1) * (2 * reach + 1); }
};

/// Any place of the exemplar for each pixel.
void scatter(Core& core, const Lab_picture& exemplar, std::uint64_t key, Match_field& field);

/// The same correspondence for a tile and an exemplar of another size: patches keep their places relative to each
/// other.
void rescale(Core& core, const Match_field& from, std::uint32_t from_exemplar_width, std::uint32_t from_exemplar_height,
             const Lab_picture& exemplar, Match_field& field);

/// The better a match, the more its patch counts: 1 to 16.
void weigh(Core& core, Match_field& field);

} // namespace weft
