/// Elementary functions from + - * / and square roots alone: the same bits with every compiler and C library.
#pragma once
#include <cstdint>

namespace weft {

/// e^-x for 0 <= x <= 700.
double exponential_of_minus(double x) noexcept;

/// log2 of a normal x > 0, exact for powers of two.
double log2_of(double x) noexcept;

/// Two independent normal numbers (Box and Muller 1958) from 64 random bits.
struct Normal_pair {
    double first, second;
};
Normal_pair normal_pair_of(std::uint64_t bits) noexcept;

} // namespace weft
