/// Impacts with random signs, row by row in their order, so that threads change nothing.
#include "synthesis/noise_tile.h"
#include "base/hash.h"
#include <algorithm>
#include <cmath>
#include <functional>

namespace weft {

namespace {

constexpr std::uint32_t usual_side = 512, least_side = 256, most_tile_side = 1024;
constexpr std::uint32_t mean_impacts = 64; ///< on a pixel: as good as Gaussian

struct Place {
    std::uint32_t x, y;
    float tx, ty, sign;
};

Place place_of(std::uint64_t key, std::uint32_t i, std::uint32_t width, std::uint32_t height) noexcept
{
    const std::uint64_t z = mix_in(key, i);
    const std::uint64_t along = (z & 0xffffffff) * width, down = (z >> 32) * height;
    const auto fraction = [](std::uint64_t number) { return static_cast<float>(number >> 8 & 0xffffff) / 16777216.0F; };
    return {static_cast<std::uint32_t>(along >> 32), static_cast<std::uint32_t>(down >> 32), fraction(along),
            fraction(down), (mix_bits(z) & 1) != 0 ? -1.0F : 1.0F};
}

/// Row `k` of the texton shifted down by ty, k from 0 to its height, and then by tx: one texel longer than the texton.
void shifted_row(const Planes& alpha, std::uint32_t c, std::uint32_t k, const Place& at, float* row) noexcept
{
    const float above = k > 0 ? at.ty * at.sign : 0.0F, here = k < alpha.height ? (1 - at.ty) * at.sign : 0.0F;
    const float* upper = alpha.row(c, k > 0 ? k - 1 : 0);
    const float* lower = alpha.row(c, k < alpha.height ? k : 0);
    float before = 0;
    for (std::uint32_t x = 0; x < alpha.width; ++x) {
        const float value = above * upper[x] + here * lower[x];
        row[x] = at.tx * before + (1 - at.tx) * value;
        before = value;
    }
    row[alpha.width] = at.tx * before;
}

/// Adds the parts of all impacts that lie in rows [first, end) of one plane.
void add_impacts(const Planes& alpha, std::uint32_t c, std::uint64_t key, std::uint32_t count, Planes& tile,
                 std::uint32_t first, std::uint32_t end, float* room) noexcept
{
    for (std::uint32_t i = 0; i < count; ++i) {
        const Place at = place_of(key, i, tile.width, tile.height);
        for (std::uint32_t k = 0; k <= alpha.height; ++k) {
            const std::uint32_t y = (at.y + k) % tile.height;
            if (y < first || y >= end) continue;
            shifted_row(alpha, c, k, at, room);
            float* row = tile.row(c, y);
            for (std::uint32_t done = 0, x = at.x; done <= alpha.width; x = 0) {
                const std::uint32_t run = std::min(alpha.width + 1 - done, tile.width - x);
                for (std::uint32_t j = 0; j < run; ++j) row[x + j] += room[done + j];
                done += run;
            }
        }
    }
}

void normalise(Planes& tile, std::uint32_t c, double scale) noexcept
{
    float* values = tile.plane(c);
    double sum = 0;
    for (std::size_t i = 0; i < tile.area(); ++i) sum += static_cast<double>(values[i]);
    const double mean = sum / static_cast<double>(tile.area());
    for (std::size_t i = 0; i < tile.area(); ++i)
        values[i] = static_cast<float>((static_cast<double>(values[i]) - mean) * scale);
}

} // namespace

std::uint32_t noise_tile_side(std::uint32_t period) noexcept
{
    if (period == 0) return usual_side;
    if (period < least_side) return period;
    for (std::uint32_t side = usual_side; side <= most_tile_side; ++side)
        if (period % side == 0) return side;
    for (std::uint32_t side = usual_side; side >= least_side; --side)
        if (period % side == 0) return side;
    return usual_side;
}

Planes make_noise_tile(Core& core, const Planes& coefficients, std::uint32_t width, std::uint32_t height,
                       std::uint64_t key)
{
    Planes tile(&core.memory, width, height, coefficients.count);
    const double share = static_cast<double>(tile.area()) / static_cast<double>(coefficients.area());
    const auto count = static_cast<std::uint32_t>(std::max(1.0, mean_impacts * std::min(share, 4096.0)));
    constexpr std::uint32_t band = 64;
    const std::uint32_t bands = (height + band - 1) / band;
    Array<float> rooms(&core.memory, std::size_t{bands} * tile.count * (coefficients.width + 1), Array<float>::unset);
    const auto work = [&](std::uint32_t task) {
        const std::uint32_t c = task / bands, first = task % bands * band;
        add_impacts(coefficients, c, key, count, tile, first, std::min(height, first + band),
                    rooms.data() + std::size_t{task} * (coefficients.width + 1));
    };
    core.parallel.for_each_index(bands * tile.count, std::ref(work));
    const double scale = 1.0 / std::sqrt(static_cast<double>(count) / static_cast<double>(tile.area()));
    for (std::uint32_t c = 0; c < tile.count; ++c) normalise(tile, c, scale);
    return tile;
}

} // namespace weft
