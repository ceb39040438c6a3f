/// What the pixels of a structure are compared by: the principal axes of its colours and masks.
#pragma once
#include "base/array.h"
#include "base/core.h"

namespace weft {

/// Four numbers stand for a pixel's colours and masks.
struct Feature {
    float value[4];
};

inline float distance(const Feature& a, const Feature& b) noexcept
{
    const float d0 = a.value[0] - b.value[0], d1 = a.value[1] - b.value[1], d2 = a.value[2] - b.value[2],
                d3 = a.value[3] - b.value[3];
    return (d0 * d0 + d1 * d1) + (d2 * d2 + d3 * d3);
}

/// How far a pixel is from the mean of all; 1/2 on average.
inline float square_of(const Feature& a) noexcept { return distance(a, Feature{}); }

inline Feature lerp(const Feature& a, const Feature& b, float t) noexcept
{
    Feature result{};
    for (int c = 0; c < 4; ++c) result.value[c] = a.value[c] + t * (b.value[c] - a.value[c]);
    return result;
}

/// A picture of features. Their unit: the mean squared distance of two random pixels is 1, so that an error is chance
/// at 1, whatever the contrast.
struct Features {
    std::uint32_t width = 0, height = 0;
    Array<Feature> pixels;

    Features() = default;
    Features(std::pmr::memory_resource* memory, std::uint32_t w, std::uint32_t h)
        : width(w), height(h), pixels(memory, std::size_t{w} * h)
    {
    }
    bool empty() const noexcept { return pixels.empty(); }
    const Feature& at(std::size_t x, std::size_t y) const noexcept { return pixels[y * width + x]; }
    Feature& at(std::size_t x, std::size_t y) noexcept { return pixels[y * width + x]; }
};

/// Of planes whose first `channels` are colours and the others masks; empty if all pixels are alike.
Features features_of(Core& core, std::uint32_t channels, const Planes& structure);

/// Means of 2 x 2 pixels; a last odd row or column is left out.
Features halved(Core& core, const Features& features);

/// Each pixel mixed with its neighbours in both directions: a tent of 3 pixels at `amount` 1/2, 0: as it is.
Features blurred(Core& core, const Features& features, float amount);

} // namespace weft
