/// Patches as connected regions of a grid of texels, and how deep texels lie in them.
#pragma once
#include "analysis/exchange_view.h"
#include <limits>

namespace weft {

constexpr std::uint32_t no_patch = 0xffffffffU;

/// Neighbours in a view, which may be a torus.
class Grid {
public:
    explicit Grid(const View& view) noexcept
        : width_(static_cast<std::int32_t>(view.width)), height_(static_cast<std::int32_t>(view.height)),
          torus_(view.torus)
    {
    }
    /// Index of the texel, or that of none beyond the border.
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::size_t at(std::int32_t x, std::int32_t y) const noexcept
    {
        if (torus_) {
            x = (x + width_) % width_;
            y = (y + height_) % height_;
        } else if (x < 0 || y < 0 || x >= width_ || y >= height_)
            return none;
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    std::int32_t width() const noexcept { return width_; }
    std::int32_t height() const noexcept { return height_; }

private:
    std::int32_t width_, height_;
    bool torus_;
};

/// Each of the `count` patches keeps its largest piece; the others, and patches of less than `least` texels, go to the
/// patches around them. Patches are numbered anew; returns how many are left.
std::uint32_t keep_connected(std::pmr::memory_resource* memory, const Grid& grid, std::uint32_t count,
                             std::uint32_t least, Array<std::uint32_t>& patch);

/// In eighths of a texel: 0 on texels that touch, also at a corner, another patch or the border of a grid that is no
/// torus; then the length of the shortest way there.
Array<std::uint8_t> depths_of(std::pmr::memory_resource* memory, const Grid& grid, const Array<std::uint32_t>& patch);

} // namespace weft
