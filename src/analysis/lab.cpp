/// Lab from tables that are read linearly.
#include "analysis/lab.h"
#include "base/elementary.h"
#include <algorithm>

namespace weft {
namespace {

constexpr double ln2 = 0.6931471805599453;

/// x^2.4 for 0 < x <= 1.
double power_2_4(double x) noexcept { return exponential_of_minus(-2.4 * ln2 * log2_of(x)); }

/// By Newton's method from above, where it falls until rounding stops it.
double cube_root(double x) noexcept
{
    double root = 1;
    for (int i = 0; i < 40; ++i) root = (2 * root + x / (root * root)) / 3;
    return root;
}

float at(const Array<float>& table, float position) noexcept
{
    const auto last = static_cast<std::uint32_t>(table.size() - 2);
    const std::uint32_t i = std::min(static_cast<std::uint32_t>(position), last);
    const float fraction = position - static_cast<float>(i);
    return table[i] + (table[i + 1] - table[i]) * fraction;
}

} // namespace

Lab_curves::Lab_curves(std::pmr::memory_resource* memory)
    : light_(memory, light_steps + 1, Array<float>::unset), response_(memory, response_steps + 1, Array<float>::unset)
{
    for (std::uint32_t i = 0; i <= light_steps; ++i) {
        const double v = static_cast<double>(i) / light_steps;
        light_[i] = static_cast<float>(v <= 0.04045 ? v / 12.92 : power_2_4((v + 0.055) / 1.055));
    }
    constexpr double knee = 216.0 / 24389, slope = 24389.0 / 27 / 116, offset = 16.0 / 116;
    for (std::uint32_t i = 0; i <= response_steps; ++i) {
        const double t = static_cast<double>(i) / response_steps;
        response_[i] = static_cast<float>(t > knee ? cube_root(t) : slope * t + offset);
    }
}

float Lab_curves::light(float value) const noexcept
{
    return at(light_, std::min(std::max(value, 0.0f), 1.0f) * static_cast<float>(light_steps));
}

float Lab_curves::response(float light) const noexcept
{
    return at(response_, std::min(light, 1.0f) * static_cast<float>(response_steps));
}

/// sRGB's primaries; each row divided by its sum, which is the white's coordinate.
Lab Lab_curves::of(float red, float green, float blue) const noexcept
{
    const float r = light(red), g = light(green), b = light(blue);
    const float x = response(0.43395f * r + 0.37621f * g + 0.18984f * b);
    const float y = response(0.212673f * r + 0.715152f * g + 0.072175f * b);
    const float z = response(0.017757f * r + 0.109469f * g + 0.872774f * b);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

float Lab_curves::lightness(float grey) const noexcept { return 116 * response(light(grey)) - 16; }

} // namespace weft
