/// Flood filling, and a chamfer distance from the borders.
#include "analysis/exchange_pieces.h"
#include <algorithm>
#include <utility>

namespace weft {
namespace {

constexpr std::uint32_t straight = 8, diagonal = 11; ///< steps of the distance, in eighths

/// Texels of like labels that are connected: their number, and that of each texel.
struct Components {
    Array<std::uint32_t> component, size, label;
    std::uint32_t count = 0;
};

template <class Body> void for_each_neighbour(const Grid& grid, std::size_t i, const Body& body)
{
    const auto width = static_cast<std::size_t>(grid.width());
    const auto x = static_cast<std::int32_t>(i % width), y = static_cast<std::int32_t>(i / width);
    for (const auto& [dx, dy] : {std::pair{1, 0}, std::pair{-1, 0}, std::pair{0, 1}, std::pair{0, -1}})
        if (const std::size_t next = grid.at(x + dx, y + dy); next != Grid::none) body(next);
}

Components components_of(std::pmr::memory_resource* memory, const Grid& grid, const Array<std::uint32_t>& patch)
{
    Components found;
    found.component = Array<std::uint32_t>(memory, patch.size());
    found.size = Array<std::uint32_t>(memory, patch.size());
    found.label = Array<std::uint32_t>(memory, patch.size());
    Array<std::uint32_t> queue(memory, patch.size());
    std::fill(found.component.begin(), found.component.end(), no_patch);
    for (std::size_t start = 0; start < patch.size(); ++start) {
        if (patch[start] == no_patch || found.component[start] != no_patch) continue;
        const std::uint32_t own = found.count++;
        found.label[own] = patch[start];
        std::size_t head = 0, tail = 0;
        queue[tail++] = static_cast<std::uint32_t>(start);
        found.component[start] = own;
        while (head < tail)
            for_each_neighbour(grid, queue[head++], [&](std::size_t next) {
                if (patch[next] != found.label[own] || found.component[next] != no_patch) return;
                found.component[next] = own;
                queue[tail++] = static_cast<std::uint32_t>(next);
            });
        found.size[own] = static_cast<std::uint32_t>(tail);
    }
    return found;
}

} // namespace

/// Nearest texels first.
std::uint32_t keep_connected(std::pmr::memory_resource* memory, const Grid& grid, std::uint32_t count,
                             std::uint32_t least, Array<std::uint32_t>& patch)
{
    const Components found = components_of(memory, grid, patch);
    Array<std::uint32_t> largest(memory, count), number(memory, found.count);
    std::fill(largest.begin(), largest.end(), no_patch);
    for (std::uint32_t c = 0; c < found.count; ++c) {
        std::uint32_t& best = largest[found.label[c]];
        if (found.size[c] >= least && (best == no_patch || found.size[c] > found.size[best])) best = c;
    }
    std::uint32_t kept = 0;
    std::fill(number.begin(), number.end(), no_patch);
    for (std::uint32_t k = 0; k < count; ++k)
        if (largest[k] != no_patch) number[largest[k]] = kept++;
    Array<std::uint32_t> queue(memory, patch.size());
    Array<std::uint8_t> orphan(memory, patch.size());
    std::size_t head = 0, tail = 0;
    for (std::size_t i = 0; i < patch.size(); ++i) {
        if (patch[i] == no_patch) continue;
        patch[i] = number[found.component[i]];
        orphan[i] = patch[i] == no_patch;
        if (!orphan[i]) queue[tail++] = static_cast<std::uint32_t>(i);
    }
    while (head < tail) {
        const std::size_t i = queue[head++];
        for_each_neighbour(grid, i, [&](std::size_t next) {
            if (orphan[next] == 0) return;
            orphan[next] = 0;
            patch[next] = patch[i];
            queue[tail++] = static_cast<std::uint32_t>(next);
        });
    }
    return kept;
}

Array<std::uint8_t> depths_of(std::pmr::memory_resource* memory, const Grid& grid, const Array<std::uint32_t>& patch)
{
    Array<std::uint8_t> depth(memory, patch.size());
    const std::int32_t w = grid.width(), h = grid.height();
    const auto each = [&](auto&& body) {
        for (std::int32_t y = 0; y < h; ++y)
            for (std::int32_t x = 0; x < w; ++x) body(x, y);
    };
    each([&](std::int32_t x, std::int32_t y) {
        const std::size_t i = grid.at(x, y);
        bool inside = patch[i] != no_patch;
        for (std::int32_t k = 0; k < 9 && inside; ++k) {
            const std::size_t next = grid.at(x + k % 3 - 1, y + k / 3 - 1);
            inside = next != Grid::none && patch[next] == patch[i];
        }
        depth[i] = inside ? static_cast<std::uint8_t>(most_map_depth) : 0;
    });
    const auto relax = [&](std::int32_t x, std::int32_t y, std::int32_t dx, std::int32_t dy) {
        const std::size_t i = grid.at(x, y), next = grid.at(x + dx, y + dy);
        const std::uint32_t far = next == Grid::none ? 0 : depth[next] + (dx != 0 && dy != 0 ? diagonal : straight);
        if (far < depth[i]) depth[i] = static_cast<std::uint8_t>(far);
    };
    for (int pass = 0; pass < 2; ++pass) { // twice, since a torus has no first row
        each([&](std::int32_t x, std::int32_t y) {
            for (const auto& [dx, dy] : {std::pair{-1, 0}, std::pair{-1, -1}, std::pair{0, -1}, std::pair{1, -1}})
                relax(x, y, dx, dy);
        });
        each([&](std::int32_t x, std::int32_t y) {
            for (const auto& [dx, dy] : {std::pair{-1, 0}, std::pair{-1, -1}, std::pair{0, -1}, std::pair{1, -1}})
                relax(w - 1 - x, h - 1 - y, -dx, -dy);
        });
    }
    return depth;
}

} // namespace weft
