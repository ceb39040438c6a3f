/// Sorted samples and the distance between them (Villani 2009, chapter 6: in one dimension the quantiles are the
/// optimal plan).
#include "analysis/wasserstein.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace weft {
namespace {

constexpr std::uint32_t digit_bits = 11, digits = 3;

/// Bits whose order as integers is that of the floats.
std::uint32_t key_of(float value) noexcept
{
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits ^ ((bits >> 31) != 0 ? 0xffffffffu : 0x80000000u);
}

std::uint32_t digit_of(float value, std::uint32_t digit) noexcept
{
    return (key_of(value) >> (digit * digit_bits)) & ((1u << digit_bits) - 1);
}

} // namespace

void sort_floats(float* values, float* scratch, std::size_t count) noexcept
{
    std::uint32_t places[digits][1u << digit_bits] = {};
    for (std::size_t i = 0; i < count; ++i)
        for (std::uint32_t digit = 0; digit < digits; ++digit) ++places[digit][digit_of(values[i], digit)];
    float *from = values, *to = scratch;
    for (std::uint32_t digit = 0; digit < digits; ++digit) {
        std::uint32_t place = 0;
        for (std::uint32_t& first : places[digit]) place += std::exchange(first, place);
        for (std::size_t i = 0; i < count; ++i) to[places[digit][digit_of(from[i], digit)]++] = from[i];
        std::swap(from, to);
    }
    static_assert(digits % 2 == 1, "the sorted values end up in the scratch");
    std::copy_n(scratch, count, values);
}

double wasserstein_distance(const float* a, std::size_t a_count, const float* b, std::size_t b_count) noexcept
{
    // Every value of a weighs b_count, every value of b weighs a_count: integers, so that no mass is lost.
    std::uint64_t a_left = b_count, b_left = a_count;
    double sum = 0;
    for (std::size_t i = 0, j = 0; i < a_count && j < b_count;) {
        const std::uint64_t mass = std::min(a_left, b_left);
        sum += static_cast<double>(mass) * std::abs(static_cast<double>(a[i]) - static_cast<double>(b[j]));
        a_left -= mass;
        b_left -= mass;
        if (a_left == 0) ++i, a_left = b_count;
        if (b_left == 0) ++j, b_left = a_count;
    }
    return sum / (static_cast<double>(a_count) * static_cast<double>(b_count));
}

} // namespace weft
