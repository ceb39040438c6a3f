/// Is every one of many floats finite, or small? In integers, so that the loop vectorises.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace weft {

constexpr std::uint32_t infinity_bits = 0x7f800000;
constexpr std::uint32_t two_to_64_bits = 0x5f800000; ///< below it no scaling, sum or square of a texture's overflows

/// Is the magnitude of every value below the positive float with these bits? Never so for a NaN.
inline bool all_below(const float* values, std::size_t count, std::uint32_t bound_bits) noexcept
{
    std::uint32_t spoiled = 0;
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t bits;
        std::memcpy(&bits, &values[i], sizeof bits);
        spoiled |= (bits & 0x7fffffffU) >= bound_bits ? 1U : 0U;
    }
    return spoiled == 0;
}

} // namespace weft
