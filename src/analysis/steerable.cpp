/// All orientations are sums of the four derivatives along the axes, which are separable: xxx, xxy, xyy, yyy.
#include "analysis/steerable.h"
#include "analysis/compare_pair.h"
#include "base/elementary.h"
#include <algorithm>

namespace weft {
namespace {

constexpr std::uint32_t radius = 7, taps = 2 * radius + 1;
constexpr double sigma = 1.5;

/// [order][offset + radius]
struct Derivatives {
    float values[orientations][taps];

    Derivatives() noexcept
    {
        constexpr double root_of_two_pi = 2.5066282746310002, s2 = sigma * sigma;
        for (std::uint32_t i = 0; i < taps; ++i) {
            const double x = static_cast<double>(i) - radius;
            const double g = exponential_of_minus(x * x / (2 * s2)) / (sigma * root_of_two_pi);
            const double factors[] = {1, -x / s2, (x * x / s2 - 1) / s2, (3 - x * x / s2) * x / (s2 * s2)};
            for (std::uint32_t order = 0; order < orientations; ++order)
                values[order][i] = static_cast<float>(g * factors[order]);
        }
    }
};

/// [orientation][derivatives along y]: binomials times powers of cosine and sine, times what makes the band's greatest
/// power, 5/4 r^6 exp(-r^2 sigma^2) at r^2 = 3 / sigma^2, one.
constexpr float unit = static_cast<float>(sigma * sigma * sigma * 0.7714444), half = 0.35355339f;
constexpr float mixing[orientations][4] = {{unit, 0, 0, 0},
                                           {unit * half, 3 * unit* half, 3 * unit* half, unit* half},
                                           {0, 0, 0, unit},
                                           {-unit * half, 3 * unit* half, -3 * unit* half, unit* half}};

/// target[x] += sum of source[x - offset] * kernel[offset], around.
void add_along(const float* source, std::uint32_t width, const float* kernel, float* padded, float* target) noexcept
{
    for (std::uint32_t i = 0; i < width + 2 * radius; ++i)
        padded[i] = source[(i + width * radius - radius) % width]; // width * radius: not below 0
    for (std::uint32_t k = 0; k < taps; ++k)
        for (std::uint32_t x = 0; x < width; ++x) target[x] += kernel[k] * padded[x + 2 * radius - k];
}

/// The same along columns: row y of the result.
void add_across(const Planes& planes, std::uint32_t c, std::uint32_t y, const float* kernel, float scale,
                float* target) noexcept
{
    const std::uint32_t height = planes.height;
    for (std::uint32_t k = 0; k < taps; ++k) {
        const float* source = planes.row(c, (y + height * radius + radius - k) % height);
        const float weight = kernel[k] * scale;
        for (std::uint32_t x = 0; x < planes.width; ++x) target[x] += weight * source[x];
    }
}

double row_cost(const Planes& planes) noexcept { return 4.0 * taps * planes.width; }

} // namespace

void steerable_responses(Core& core, const Planes& picture, std::uint32_t c, Planes& responses,
                         const Progress& progress)
{
    const Derivatives derivatives;
    const std::uint32_t width = picture.width;
    Planes along(&core.memory, width, picture.height, 4);
    for_each_step(core, picture.height, row_cost(picture), progress.part(0, 0.5), [&](std::uint32_t y) {
        Array<float> padded(&core.memory, width + 2 * radius, Array<float>::unset);
        for (std::uint32_t j = 0; j < 4; ++j)
            add_along(picture.row(c, y), width, derivatives.values[3 - j], padded.data(), along.row(j, y));
    });
    for_each_step(core, picture.height, row_cost(picture), progress.part(0.5, 1), [&](std::uint32_t y) {
        Array<float> sums(&core.memory, std::size_t{4} * width);
        for (std::uint32_t j = 0; j < 4; ++j)
            add_across(along, j, y, derivatives.values[j], 1, sums.data() + std::size_t{j} * width);
        for (std::uint32_t o = 0; o < orientations; ++o) {
            float* row = responses.row(o, y);
            std::fill_n(row, width, 0.0f);
            for (std::uint32_t j = 0; j < 4; ++j)
                for (std::uint32_t x = 0; x < width; ++x) row[x] += mixing[o][j] * sums[std::size_t{j} * width + x];
        }
    });
}

/// The kernels' product is odd, so that its transpose is its negative.
void add_steerable(Core& core, const Planes& responses, Planes& picture, std::uint32_t c, const Progress& progress)
{
    const Derivatives derivatives;
    const std::uint32_t width = picture.width;
    Planes along(&core.memory, width, picture.height, 4);
    for_each_step(core, picture.height, row_cost(picture), progress.part(0, 0.5), [&](std::uint32_t y) {
        Array<float> padded(&core.memory, width + 2 * radius, Array<float>::unset);
        Array<float> mixed(&core.memory, width, Array<float>::unset);
        for (std::uint32_t j = 0; j < 4; ++j) {
            std::fill_n(mixed.data(), width, 0.0f);
            for (std::uint32_t o = 0; o < orientations; ++o)
                for (std::uint32_t x = 0; x < width; ++x) mixed[x] += mixing[o][j] * responses.row(o, y)[x];
            add_along(mixed.data(), width, derivatives.values[3 - j], padded.data(), along.row(j, y));
        }
    });
    for_each_step(core, picture.height, row_cost(picture), progress.part(0.5, 1), [&](std::uint32_t y) {
        for (std::uint32_t j = 0; j < 4; ++j) add_across(along, j, y, derivatives.values[j], -1, picture.row(c, y));
    });
}

} // namespace weft
