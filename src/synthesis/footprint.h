/// From a shading point to spots: what part of the texture a screen pixel covers.
#pragma once
#include <cstdint>
#include <weft/backend.h>

namespace weft {

constexpr std::uint32_t most_probes = 16;

constexpr double most_coordinate = 4503599627370496.0; ///< 2^52: positions lie within

/// Is every number of the point finite, and its position within 2^52?
bool is_good(const weft_point& point) noexcept;

/// Writes the point's spots and returns their number, 1..16: probes along the major axis of its footprint, whose mean
/// is its colour. Up to the last bit the same on every machine.
std::uint32_t make_spots(const weft_point& point, weft_spot* spots) noexcept;

/// A position in space, every coordinate within 2^52, and a level.
weft_spot spot_in_space(const double* position, float level) noexcept;

/// Of a footprint `width` pixels wide; 0 up to one pixel.
float level_of(float width) noexcept;

} // namespace weft
