/// Clusters in colour and place, of which only connected ones stay whole; then a chamfer distance from their borders.
#include "analysis/exchange_patches.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace weft {
namespace {

constexpr float compactness = 16, reach = 1.6f; ///< squared, of places in sides against features; in sides
constexpr std::uint32_t iterations = 5;
constexpr std::uint32_t straight = 8, diagonal = 11; ///< steps of the distance, in eighths

struct Centre {
    float x, y;
    Feature feature;
};

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

class Clustering {
public:
    Clustering(std::pmr::memory_resource* memory, const Features& features, const View& view, float side)
        : memory_(memory), features_(features), view_(view), grid_(view), side_(side),
          patch_(memory, view.area(), Array<std::uint32_t>::unset), nearest_(memory, view.area())
    {
        seed();
        for (std::uint32_t i = 0; i < iterations && count_ > 0; ++i) {
            assign();
            move();
        }
        assign();
    }
    Array<std::uint32_t>& patch() noexcept { return patch_; }
    std::uint32_t count() const noexcept { return count_; }

private:
    const Feature& feature(std::uint32_t x, std::uint32_t y) const noexcept
    {
        return features_.at((static_cast<std::uint32_t>(view_.x) + x) % features_.width,
                            (static_cast<std::uint32_t>(view_.y) + y) % features_.height);
    }
    /// On a grid of sides, where patches may be.
    void seed()
    {
        const auto cells = [this](std::uint32_t size) {
            return std::max(1U, static_cast<std::uint32_t>(static_cast<float>(size) / side_ + 0.5f));
        };
        const std::uint32_t across = cells(view_.width), down = cells(view_.height);
        centres_ = Array<Centre>(memory_, std::size_t{across} * down);
        for (std::uint32_t j = 0; j < down; ++j)
            for (std::uint32_t i = 0; i < across; ++i) {
                const std::uint32_t x = (2 * i + 1) * view_.width / (2 * across),
                                    y = (2 * j + 1) * view_.height / (2 * down);
                if (view_.domain[std::size_t{y} * view_.width + x] == 0) continue;
                centres_[count_++] = {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, feature(x, y)};
            }
    }
    void assign()
    {
        std::fill(patch_.begin(), patch_.end(), no_patch);
        std::fill(nearest_.begin(), nearest_.end(), std::numeric_limits<float>::max());
        const float unit = compactness / (side_ * side_);
        for (std::uint32_t k = 0; k < count_; ++k) {
            const Centre& centre = centres_[k];
            const auto first = [&](float at) { return static_cast<std::int32_t>(std::floor(at - reach * side_)); };
            const auto last = [&](float at) { return static_cast<std::int32_t>(std::floor(at + reach * side_)); };
            for (std::int32_t y = first(centre.y); y <= last(centre.y); ++y)
                for (std::int32_t x = first(centre.x); x <= last(centre.x); ++x) {
                    const std::size_t i = texel(x, y);
                    if (i == Grid::none || view_.domain[i] == 0) continue;
                    const float dx = static_cast<float>(x) + 0.5f - centre.x,
                                dy = static_cast<float>(y) + 0.5f - centre.y;
                    const auto at_x = static_cast<std::uint32_t>(i % view_.width),
                               at_y = static_cast<std::uint32_t>(i / view_.width);
                    const float far = 2 * distance(feature(at_x, at_y), centre.feature) + unit * (dx * dx + dy * dy);
                    if (far >= nearest_[i]) continue;
                    nearest_[i] = far;
                    patch_[i] = k;
                }
        }
    }
    /// Wrapped at most once: patches are small.
    std::size_t texel(std::int32_t x, std::int32_t y) const noexcept
    {
        return x >= 2 * grid_.width() || y >= 2 * grid_.height() || x < -grid_.width() || y < -grid_.height()
                   ? Grid::none
                   : grid_.at(x, y);
    }
    void move()
    {
        struct Sum {
            double x, y, count, feature[4];
        };
        Array<Sum> sums(memory_, count_);
        for (std::uint32_t y = 0; y < view_.height; ++y)
            for (std::uint32_t x = 0; x < view_.width; ++x) {
                const std::uint32_t k = patch_[std::size_t{y} * view_.width + x];
                if (k == no_patch) continue;
                sums[k].x += wrapped(static_cast<float>(x) + 0.5f - centres_[k].x, view_.width);
                sums[k].y += wrapped(static_cast<float>(y) + 0.5f - centres_[k].y, view_.height);
                sums[k].count += 1;
                for (int c = 0; c < 4; ++c) sums[k].feature[c] += static_cast<double>(feature(x, y).value[c]);
            }
        for (std::uint32_t k = 0; k < count_; ++k) {
            if (sums[k].count == 0) continue;
            centres_[k].x = held(centres_[k].x + static_cast<float>(sums[k].x / sums[k].count), view_.width);
            centres_[k].y = held(centres_[k].y + static_cast<float>(sums[k].y / sums[k].count), view_.height);
            for (int c = 0; c < 4; ++c)
                centres_[k].feature.value[c] = static_cast<float>(sums[k].feature[c] / sums[k].count);
        }
    }
    double wrapped(float difference, std::uint32_t size) const noexcept
    {
        const auto period = static_cast<float>(size);
        if (view_.torus && difference > period / 2) difference -= period;
        if (view_.torus && difference < -period / 2) difference += period;
        return static_cast<double>(difference);
    }
    float held(float place, std::uint32_t size) const noexcept
    {
        const auto period = static_cast<float>(size);
        return place < 0 ? place + period : place >= period ? place - period : place;
    }

    std::pmr::memory_resource* memory_;
    const Features& features_;
    const View& view_;
    const Grid grid_;
    float side_;
    std::uint32_t count_ = 0;
    Array<std::uint32_t> patch_;
    Array<float> nearest_;
    Array<Centre> centres_;
};

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

/// Each patch keeps its largest piece; the others go to the patches around them, nearest texels first.
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

/// 0 on texels that touch, also at a corner, another patch or the border; farther in the shortest way there.
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

} // namespace

Patches_of_view patches_of(std::pmr::memory_resource* memory, const Features& features, const View& view, float side)
{
    Clustering clustering(memory, features, view, side);
    Patches_of_view result;
    result.patch = std::move(clustering.patch());
    const Grid grid(view);
    const auto least = static_cast<std::uint32_t>(side * side / 6);
    result.count = keep_connected(memory, grid, clustering.count(), least, result.patch);
    result.depth = depths_of(memory, grid, result.patch);
    return result;
}

} // namespace weft
