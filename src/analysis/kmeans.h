/// K-means (Lloyd 1982) of points in many dimensions, from spread starts (Arthur and Vassilvitskii 2007).
#pragma once
#include "base/array.h"
#include "base/core.h"
#include "base/progress.h"

namespace weft {

/// Points in blocks of `lanes`, number by number, so that distances are computed side by side. The last block is filled
/// up with copies of the last point, which do not count.
struct Points {
    static constexpr std::uint32_t lanes = 16;

    Points(std::pmr::memory_resource* memory, std::uint32_t points, std::uint32_t numbers)
        : count(points), size(numbers), values(memory, std::size_t{blocks()} * numbers * lanes)
    {
    }
    std::uint32_t blocks() const noexcept { return (count + lanes - 1) / lanes; }
    const float* block(std::size_t b) const noexcept { return values.data() + b * size * lanes; }
    float& at(std::size_t point, std::size_t number) noexcept
    {
        return values[(point / lanes * size + number) * lanes + point % lanes];
    }
    float at(std::size_t point, std::size_t number) const noexcept
    {
        return values[(point / lanes * size + number) * lanes + point % lanes];
    }

    std::uint32_t count, size;
    Array<float> values;
};

struct Means {
    std::uint32_t count = 0;
    Array<float> centres;         ///< count * size
    Array<std::uint32_t> members; ///< points of each
    double squares = 0;           ///< sum of squared distances to the nearest centre
};

/// Starts at `count` points, fewer if no more are different: each chosen at random, as likely as its squared distance
/// to those before it is great.
Means spread_means(Core& core, const Points& points, std::uint32_t count, std::uint64_t seed);

/// Moves centres to the means of their points until no point changes, or `rounds` times. Those left without points
/// stay.
void refine_means(Core& core, const Points& points, std::uint32_t rounds, Means& means, const Progress& progress);

} // namespace weft
