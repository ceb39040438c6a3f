/// Exhaustive search of a picture's first channel for the nearest 9 x 9 window.
#pragma once
#include "analysis/compare_pair.h"

namespace weft {

constexpr std::size_t window_side = 9, window_features = 9;

/// A window that is searched for, and the nearest found so far: least squared distance, then first in reading order.
struct Window {
    float pixels[window_side * window_side];
    float features[window_features]; ///< its lowest cosine coefficients: an orthogonal projection
    float distance;
    std::uint32_t nearest_x, nearest_y;
    bool settled;  ///< nothing nearer is of interest
    bool expected; ///< only whether the nearest is the one expected is of interest
};

Window window_at(const Planes& planes, std::uint64_t x, std::uint64_t y) noexcept;

/// Sets the window's nearest to that at (x, y), if there is one; the search then stops at whatever comes before it.
void expect(const Planes& planes, Window& window, std::uint32_t x, std::uint32_t y) noexcept;

void find_nearest(Core& core, const Planes& planes, Window* windows, std::uint32_t count, const Progress& progress);

} // namespace weft
