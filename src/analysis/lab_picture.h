/// The pictures whose patches are compared: L*a*b* in sixteenths, so that distances and votes are sums of integers.
#pragma once
#include "base/array.h"
#include "base/core.h"
#include "base/progress.h"

namespace weft {

constexpr int lab_scale = 16;
constexpr std::int16_t lab_bound = 2047; ///< no value is beyond it

/// Pixel by pixel, 1 channel (L*) or 3; around it a margin in which it goes on periodically, once wrap() was called.
struct Lab_picture {
    std::uint32_t width = 0, height = 0, channels = 0, margin = 0;
    Array<std::int16_t> values;

    Lab_picture() = default;
    Lab_picture(std::pmr::memory_resource* memory, std::uint32_t w, std::uint32_t h, std::uint32_t n, std::uint32_t m)
        : width(w), height(h), channels(n), margin(m),
          values(memory, std::size_t{w + 2 * m} * (h + 2 * m) * n, Array<std::int16_t>::unset)
    {
    }

    std::size_t stride() const noexcept { return std::size_t{width + 2 * margin} * channels; }
    std::int16_t* at(std::size_t x, std::size_t y) noexcept
    {
        return values.data() + (y + margin) * stride() + (x + margin) * channels;
    }
    const std::int16_t* at(std::size_t x, std::size_t y) const noexcept
    {
        return const_cast<Lab_picture*>(this)->at(x, y);
    }
    void wrap() noexcept;
};

/// The photo's first three planes as sRGB, or its first as grey. Values outside 0..1 are brought there together.
Lab_picture lab_of(Core& core, const Planes& photo, const Progress& progress);

/// Means of boxes that cut the picture into width x height equal parts.
Lab_picture reduced(Core& core, const Lab_picture& picture, std::uint32_t width, std::uint32_t height,
                    const Progress& progress);

} // namespace weft
