/// Gaussian white noise by counter: the same number for the same seed and position, in whatever order it is asked for.
#pragma once
#include <cmath>
#include <complex>
#include <cstdint>

namespace weft {

/// The finaliser of SplitMix64 (Steele, Lea, Flood 2014): every bit of the result depends on every bit of `x`.
inline std::uint64_t mix_bits(std::uint64_t x) noexcept
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

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
