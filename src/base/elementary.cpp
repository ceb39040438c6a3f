/// Range reductions that are exact, and series that end below the last bit.
#include "base/elementary.h"
#include <cmath>
#include <cstring>

namespace weft {

double exponential_of_minus(double x) noexcept
{
    constexpr double ln2_high = 0x1.62e42fefa0000p-1, ln2_low = 0x1.cf79abc9e3b3ap-40; // high * n is exact for n < 2^13
    const auto halvings = static_cast<int>(x / (ln2_high + ln2_low) + 0.5);
    const double r = (x - halvings * ln2_high) - halvings * ln2_low; // |r| <= ln 2 / 2
    double sum = 1;
    for (int k = 18; k > 0; --k) sum = 1 - r * sum / k;
    for (int i = 0; i < halvings; ++i) sum *= 0.5;
    return sum;
}

/// The exponent, and a series in (m - 1) / (m + 1) for the mantissa.
double log2_of(double x) noexcept
{
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    auto exponent = static_cast<int>(bits >> 52) - 1023;
    bits = (bits & 0x000fffffffffffffU) | 0x3ff0000000000000U;
    double m;
    std::memcpy(&m, &bits, sizeof m);
    if (m > 1.4142135623730951) {
        m *= 0.5;
        ++exponent;
    }
    const double s = (m - 1) / (m + 1), s2 = s * s;
    const double series =
        1 + s2 * (1.0 / 3 + s2 * (1.0 / 5 + s2 * (1.0 / 7 + s2 * (1.0 / 9 + s2 * (1.0 / 11 + s2 * (1.0 / 13))))));
    return exponent + 2.8853900817779268 * s * series;
}

namespace {

/// Cosine and sine of `eighths` / 8 of a turn, |eighths| <= 1, by their series.
struct Circle {
    double cosine, sine;
};

Circle circle_at(double eighths) noexcept
{
    const double x = eighths * 0.78539816339744831, x2 = x * x;
    double cosine = 1, sine = 1;
    static constexpr double even[] = {1.0 / 240, 1.0 / 182, 1.0 / 132, 1.0 / 90, 1.0 / 56, 1.0 / 30, 1.0 / 12, 1.0 / 2};
    static constexpr double odd[] = {1.0 / 272, 1.0 / 210, 1.0 / 156, 1.0 / 110, 1.0 / 72, 1.0 / 42, 1.0 / 20, 1.0 / 6};
    for (int k = 0; k < 8; ++k) {
        cosine = 1 - x2 * even[k] * cosine;
        sine = 1 - x2 * odd[k] * sine;
    }
    return {cosine, x * sine};
}

} // namespace

Normal_pair normal_pair_of(std::uint64_t bits) noexcept
{
    constexpr double twice_ln2 = 1.3862943611198906;
    const auto high = static_cast<std::uint32_t>(bits >> 32), low = static_cast<std::uint32_t>(bits);
    const double uniform = (static_cast<double>(high) + 0.5) * 0x1p-32; // in (0, 1)
    const double radius = std::sqrt(-twice_ln2 * log2_of(uniform));
    const Circle at = circle_at(static_cast<double>(low & 0x3fffffffU) * 0x1p-29 - 1);
    const double c = radius * at.cosine, s = radius * at.sine;
    switch (low >> 30) {
    case 0:
        return {c, s};
    case 1:
        return {-s, c};
    case 2:
        return {-c, -s};
    default:
        return {s, -c};
    }
}

} // namespace weft
