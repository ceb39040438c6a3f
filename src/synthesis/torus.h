/// Lattices of numbers on a torus, and filters along their axes.
#pragma once
#include "base/array.h"
#include "base/core.h"
#include <functional>

namespace weft {

/// In coefficients; depth is 1 in the plane.
struct Sides {
    std::uint32_t width, height, depth;
    std::size_t count() const noexcept { return std::size_t{width} * height * depth; }
    std::uint32_t operator[](unsigned axis) const noexcept { return axis == 0 ? width : axis == 1 ? height : depth; }
    unsigned axes() const noexcept { return depth > 1 ? 3 : 2; }
};
inline bool operator==(const Sides& a, const Sides& b) noexcept
{
    return a.width == b.width && a.height == b.height && a.depth == b.depth;
}

struct Torus {
    Torus(std::pmr::memory_resource* memory, const Sides& size)
        : sides(size), values(memory, size.count(), Array<float>::unset)
    {
    }
    float* row(std::size_t r) noexcept { return values.data() + r * sides.width; }
    const float* row(std::size_t r) const noexcept { return values.data() + r * sides.width; }
    std::size_t rows() const noexcept { return std::size_t{sides.height} * sides.depth; }

    Sides sides;
    Array<float> values; ///< rows of width, height of them, depth times
};

/// Coefficients of a filter, at offsets first, first + 1, ...
struct Taps {
    std::int32_t first;
    std::uint32_t count;
    float value[36];
};

/// to[i] = sum over taps of value * from[i + dilation * offset], along one axis: 0 is x.
void correlate(Core& core, const Torus& from, Torus& to, unsigned axis, const Taps& taps, std::uint32_t dilation);

/// Calls row(r) for each row of the torus.
void for_each_row(const Torus& torus, Parallel& parallel, const std::function<void(std::size_t)>& row);

/// to[i] += factor * from[i + shift], along each axis.
void add_shifted(const Torus& from, Torus& to, const Sides& shift, float factor, Parallel& parallel);

/// Independent normal numbers of unit variance: the n-th one depends on the key and n alone.
void fill_with_white_noise(Torus& torus, std::uint64_t key, Parallel& parallel);

/// The sum of a * b over all coefficients.
double inner_product(Core& core, const Torus& a, const Torus& b);

} // namespace weft
