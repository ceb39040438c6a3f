/// Dynamic programming along the contour: at each knot the depths of its cone, by steps of one interval at most.
#include "analysis/wang_cut.h"
#include <algorithm>
#include <limits>

namespace weft {
namespace {

constexpr float bend = 1.4142136f; ///< length of a step that changes the depth by one interval

std::size_t texel(float position, std::uint32_t size) noexcept
{
    return static_cast<std::size_t>(std::clamp(position, 0.0f, static_cast<float>(size - 1)));
}

/// How much the two views differ there.
class Difference {
public:
    Difference(const Features& features, const Quarter& quarter, Wang::Diamond north, Wang::Diamond west) noexcept
        : features_(features), quarter_(quarter)
    {
        const auto half = [](std::uint32_t size, std::uint32_t after) {
            return static_cast<float>(size / 2) * (after ? -1.0f : 1.0f);
        };
        north_ = {static_cast<float>(north.x), static_cast<float>(north.y) + half(quarter.height, quarter.south)};
        west_ = {static_cast<float>(west.x) + half(quarter.width, quarter.east), static_cast<float>(west.y)};
    }
    float at(float knot, float depth) const noexcept
    {
        const Place place = place_in(quarter_, knot, depth);
        return distance(view(north_, place), view(west_, place));
    }

private:
    const Feature& view(Place origin, Place place) const noexcept
    {
        return features_.at(texel(origin.x + place.x, features_.width), texel(origin.y + place.y, features_.height));
    }

    const Features& features_;
    const Quarter& quarter_;
    Place north_{}, west_{};
};

/// What the cut has cost up to each depth of each knot, and whence it came.
struct Paths {
    std::int32_t reach; ///< greatest depth of all
    Array<float> cost;  ///< of one knot: depth -reach..reach, and infinity on either side
    Array<std::int8_t> step;

    Paths(std::pmr::memory_resource* memory, std::uint32_t knots)
        : reach(most_depth(knots / 2, knots)), cost(memory, 2 * width()), step(memory, (knots + 1) * width())
    {
    }
    std::size_t width() const noexcept { return static_cast<std::size_t>(2 * reach + 3); }
    std::size_t index(std::int32_t depth) const noexcept { return static_cast<std::size_t>(depth + reach + 1); }
};

/// Differences at one knot, smoothed across the contour, since both views are seen in its feather.
void differences_at(const Difference& difference, std::uint32_t knot, std::int32_t most, float* smooth)
{
    const auto at = [&](std::int32_t depth) {
        return difference.at(static_cast<float>(knot), static_cast<float>(depth));
    };
    float before = at(-most - 1), here = at(-most);
    for (std::int32_t depth = -most; depth <= most; ++depth) {
        const float after = at(depth + 1);
        smooth[depth + most] = 0.25f * (before + after) + 0.5f * here;
        before = here;
        here = after;
    }
}

} // namespace

Place place_in(const Quarter& quarter, float knot, float depth) noexcept
{
    const auto knots = static_cast<float>(quarter.knots);
    const float w = static_cast<float>(quarter.width), h = static_cast<float>(quarter.height);
    const float x = (knot + depth) * 0.5f / knots * w, y = (knot - depth) * 0.5f / knots * h;
    return {quarter.east ? w - x : x, quarter.south ? h - y : y};
}

Cut cut_quarter(std::pmr::memory_resource* memory, const Features& features, const Quarter& quarter,
                Wang::Diamond north, Wang::Diamond west, std::int8_t* depths)
{
    const Difference difference(features, quarter, north, west);
    Paths paths(memory, quarter.knots);
    Array<float> smooth(memory, paths.width());
    constexpr float never = std::numeric_limits<float>::max() / 4;
    float *last = paths.cost.data(), *next = last + paths.width();
    std::fill(paths.cost.begin(), paths.cost.end(), never);
    last[paths.index(0)] = 0;
    for (std::uint32_t knot = 1; knot <= quarter.knots; ++knot) {
        const std::int32_t most = most_depth(knot, quarter.knots);
        differences_at(difference, knot, most, smooth.data());
        std::fill_n(next, paths.width(), never);
        for (std::int32_t depth = -most; depth <= most; ++depth) {
            const std::size_t i = paths.index(depth);
            const float here = smooth[static_cast<std::size_t>(depth + most)];
            const float straight = last[i] + here, down = last[i - 1] + bend * here, up = last[i + 1] + bend * here;
            next[i] = std::min(straight, std::min(down, up));
            paths.step[knot * paths.width() + i] = straight <= next[i] ? 0 : down <= up ? -1 : 1;
        }
        std::swap(last, next);
    }
    Cut cut{last[paths.index(0)], 0};
    std::int32_t depth = 0;
    for (std::uint32_t knot = quarter.knots; knot > 0; --knot) {
        if (depths) depths[knot] = static_cast<std::int8_t>(depth);
        const std::int32_t step = paths.step[knot * paths.width() + paths.index(depth)];
        cut.length += step == 0 ? 1 : bend;
        depth += step;
    }
    if (depths) depths[0] = 0;
    cut.error /= cut.length;
    return cut;
}

} // namespace weft
