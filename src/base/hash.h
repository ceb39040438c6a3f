/// Random bits by counter: the same number for the same place, in whatever order it is asked for.
#pragma once
#include <cstdint>

namespace weft {

/// The finaliser of SplitMix64 (Steele, Lea, Flood 2014): every bit of the result depends on every bit of `x`.
inline std::uint64_t mix_bits(std::uint64_t x) noexcept
{
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

/// `key` with one more number in it.
inline std::uint64_t mix_in(std::uint64_t key, std::uint64_t number) noexcept
{
    return mix_bits(mix_bits(key) ^ number);
}

} // namespace weft
