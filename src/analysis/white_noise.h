/// Gaussian white noise by counter: the same number for the same seed and position, in whatever order it is asked for.
#pragma once
#include "base/hash.h"
#include <cmath>
#include <complex>
#include <cstdint>

namespace weft {

/// Two independent normal numbers, as one complex number (Box and Muller 1958).
inline std::complex<float> normal_pair(std::uint64_t seed, std::uint64_t counter) noexcept
{
    const std::uint64_t bits = mix_bits(mix_bits(seed) ^ counter);
    const float u = (static_cast<float>(bits >> 40) + 0.5f) * 0x1p-24f; // in (0, 1)
    const float angle = static_cast<float>(bits & 0xffffffu) * (6.2831853f * 0x1p-24f);
    const float radius = std::sqrt(-2.0f * std::log(u));
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

} // namespace weft
