/// Distances of many pixels side by side, and their exponentials.
#include "analysis/similarity.h"
#include <algorithm>
#include <cstring>

namespace weft {
namespace {

constexpr std::uint32_t lanes = 16;
constexpr float farthest = 80; // of the exponent: more would leave float's range

/// e^-x for 0 <= x <= 80, to float's last bits, with + - * alone: the same on every machine.
float exponential_of_minus(float x) noexcept
{
    const float t = x * -1.44269504F;
    const auto n = static_cast<std::int32_t>(t - 0.5F);
    const float f = (t - static_cast<float>(n)) * 0.693147181F; // |f| <= ln 2 / 2
    const float e = 1 + f * (1 + f * (0.5F + f * (1.0F / 6 + f * (1.0F / 24 + f * (1.0F / 120 + f * (1.0F / 720))))));
    const std::int32_t bits = (n + 127) * (1 << 23);
    float power;
    std::memcpy(&power, &bits, sizeof power);
    return e * power;
}

/// `count` is a constant where this is inlined, but for pictures narrower than it.
inline void similarities_at(const float* a, const float* b, std::size_t stride, std::uint32_t size, float scale,
                            float share, float* to, std::uint32_t count) noexcept
{
    float sum[lanes] = {};
    for (std::uint32_t i = 0; i < size; ++i, a += stride, b += stride)
        for (std::uint32_t lane = 0; lane < count; ++lane) {
            const float difference = a[lane] - b[lane];
            sum[lane] += difference * difference;
        }
    for (std::uint32_t lane = 0; lane < count; ++lane) {
        const float x = sum[lane] * scale;
        to[lane] = share * exponential_of_minus(x < farthest ? x : farthest);
    }
}

} // namespace

void similarities(const Local_spectra& spectra, std::uint32_t y, std::uint32_t other, std::int32_t dx, float scale,
                  float share, float* to) noexcept
{
    const auto width = static_cast<std::int32_t>(spectra.width);
    const std::int32_t begin = std::max(0, -dx), end = std::max(begin, std::min(width, width - dx));
    const float *a = spectra.row(y, 0), *b = spectra.row(other, 0);
    std::fill_n(to, std::min(begin, width), 0.0F);
    std::fill(to + std::min(end, width), to + width, 0.0F);
    constexpr auto step = static_cast<std::int32_t>(lanes);
    if (end - begin < step)
        return similarities_at(a + begin, b + begin + dx, spectra.width, spectra.size, scale, share, to + begin,
                               static_cast<std::uint32_t>(end - begin));
    for (std::int32_t next = begin; next < end; next += step) {
        const std::int32_t x = std::min(next, end - step);
        similarities_at(a + x, b + x + dx, spectra.width, spectra.size, scale, share, to + x, lanes);
    }
}

} // namespace weft
