/// Sums of squared differences at all places of a coarse picture, then downhill at full resolution.
#include "analysis/exchange_search.h"
#include "analysis/spectra.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace weft {
namespace {

constexpr std::uint32_t most_samples = 72, coarse_side = 160, band_depth = 8 * 8;
constexpr float never = std::numeric_limits<float>::max();

struct Sample {
    float x, y; ///< from the place of the anchor in the structure
    Feature feature;
};

struct Samples {
    Sample of[most_samples];
    std::uint32_t count = 0;
};

/// Evenly from the texels near the patch's border.
Samples samples_of(const Patch_shape& shape, const Turning& turning) noexcept
{
    Samples samples;
    std::size_t many = 0, seen = 0;
    for (const auto& texel : shape.texels) many += texel.depth <= band_depth;
    for (const auto& texel : shape.texels) {
        if (texel.depth > band_depth) continue;
        if (seen++ * most_samples / many != samples.count || samples.count == most_samples) continue;
        samples.of[samples.count++] = {turning.x(texel.dx, texel.dy), turning.y(texel.dx, texel.dy), texel.feature};
    }
    return samples;
}

/// Places of the anchor at which the whole patch lies within the bounds.
Bounds places_of(const Patch_shape& shape, const Turning& turning, const Bounds& bounds) noexcept
{
    float left = 0, top = 0, right = 0, bottom = 0;
    for (const auto& texel : shape.texels) {
        const float x = turning.x(texel.dx, texel.dy), y = turning.y(texel.dx, texel.dy);
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
    }
    const auto down = [](float value) { return static_cast<std::int32_t>(std::ceil(value)) + 1; };
    return {bounds.left + down(-left), bounds.top + down(-top), bounds.right - down(right),
            bounds.bottom - down(bottom)};
}

/// A patch's own place is no other content, nor is its scaled copy; nor is what lies next to it, which would be seen
/// twice side by side.
struct Own_place {
    std::int32_t x, y, far;

    bool holds(std::int32_t at_x, std::int32_t at_y) const noexcept
    {
        const std::int64_t dx = at_x - x, dy = at_y - y;
        return dx * dx + dy * dy < std::int64_t{far} * far;
    }
};

/// Mean squared differences at the places of a coarse picture.
struct Error_map {
    std::int32_t left, top, width, height; ///< in coarse texels
    Array<float> error;

    float& at(std::int32_t x, std::int32_t y) noexcept
    {
        return error[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

void add_sample(const Search_pictures& pictures, const Sample& sample, std::int32_t y, Error_map& map)
{
    const auto unit = static_cast<float>(1U << pictures.level);
    const auto coarse = [unit](float offset) { return static_cast<std::int32_t>(std::floor(offset / unit)); };
    const auto last_y = static_cast<std::int32_t>(pictures.coarse.height) - 1;
    const auto row = static_cast<std::size_t>(std::clamp(map.top + y + coarse(sample.y), 0, last_y));
    const std::int32_t first = map.left + coarse(sample.x),
                       room = static_cast<std::int32_t>(pictures.coarse.width) - map.width;
    const float* plane[4];
    for (std::uint32_t c = 0; c < 4; ++c) plane[c] = pictures.coarse.row(c, row) + std::clamp(first, 0, room);
    const float *a = plane[0], *b = plane[1], *c = plane[2], *d = plane[3];
    const float ta = sample.feature.value[0], tb = sample.feature.value[1], tc = sample.feature.value[2],
                td = sample.feature.value[3];
    float* sum = &map.at(0, y);
    for (std::int32_t x = 0; x < map.width; ++x) {
        const float da = a[x] - ta, db = b[x] - tb, dc = c[x] - tc, dd = d[x] - td;
        sum[x] += (da * da + db * db) + (dc * dc + dd * dd);
    }
}

Error_map error_map_of(std::pmr::memory_resource* memory, const Search_pictures& pictures, const Bounds& places,
                       const Samples& samples, const Own_place* own)
{
    const auto unit = static_cast<std::int32_t>(1U << pictures.level);
    const std::int32_t left = (places.left + unit - 1) / unit, top = (places.top + unit - 1) / unit,
                       right = places.right / unit, bottom = places.bottom / unit;
    Error_map map{left, top, std::max(0, right - left + 1), std::max(0, bottom - top + 1), {}};
    if (map.width == 0 || map.height == 0) return map;
    map.error = Array<float>(memory, static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
    for (std::int32_t y = 0; y < map.height; ++y) {
        for (std::uint32_t s = 0; s < samples.count; ++s) add_sample(pictures, samples.of[s], y, map);
        for (std::int32_t x = 0; x < map.width && own; ++x)
            if (own->holds((left + x) * unit, (top + y) * unit)) map.at(x, y) = never;
    }
    return map;
}

/// Takes the least error, and its surroundings out of the map.
bool take_least(Error_map& map, std::int32_t around, std::int32_t& x, std::int32_t& y) noexcept
{
    const float* least = std::min_element(map.error.begin(), map.error.end());
    if (least == map.error.end() || *least >= never) return false;
    const auto i = static_cast<std::int32_t>(least - map.error.begin());
    x = i % map.width;
    y = i / map.width;
    for (std::int32_t v = std::max(0, y - around); v <= std::min(map.height - 1, y + around); ++v)
        for (std::int32_t u = std::max(0, x - around); u <= std::min(map.width - 1, x + around); ++u)
            map.at(u, v) = never;
    return true;
}

float error_at(const Features& features, const Samples& samples, std::int32_t x, std::int32_t y) noexcept
{
    float sum = 0;
    for (std::uint32_t s = 0; s < samples.count; ++s) {
        const Sample& sample = samples.of[s];
        const auto at_x = static_cast<std::int32_t>(std::floor(sample.x)) + x,
                   at_y = static_cast<std::int32_t>(std::floor(sample.y)) + y;
        sum += distance(features.at(static_cast<std::size_t>(at_x), static_cast<std::size_t>(at_y)), sample.feature);
    }
    return sum / static_cast<float>(std::max(1U, samples.count));
}

/// Downhill by steps of half the coarse texel, of a quarter and so on.
void refine(const Features& features, const Samples& samples, const Bounds& places, std::int32_t step,
            const Own_place* own, Found& found) noexcept
{
    found.error = error_at(features, samples, found.x, found.y);
    for (; step > 0; step /= 2) {
        const std::int32_t middle_x = found.x, middle_y = found.y;
        for (std::int32_t k = 0; k < 9; ++k) {
            const std::int32_t x = middle_x + (k % 3 - 1) * step, y = middle_y + (k / 3 - 1) * step;
            if (x < places.left || y < places.top || x > places.right || y > places.bottom) continue;
            if (own && own->holds(x, y)) continue;
            const float error = error_at(features, samples, x, y);
            if (error >= found.error) continue;
            found.error = error;
            found.x = x;
            found.y = y;
        }
    }
}

} // namespace

Search_pictures search_pictures_of(Core& core, const Features& features, const Bounds& bounds)
{
    Search_pictures pictures;
    pictures.bounds = bounds;
    for (std::uint32_t s = 0; s < scales_offered; ++s)
        pictures.scaled[s] = blurred(core, features, 0.3f * static_cast<float>(s)); // about what smaller pictures lose
    Features small;
    const Features* coarse = &features;
    while (std::max(coarse->width, coarse->height) > coarse_side && std::min(coarse->width, coarse->height) >= 32) {
        small = halved(core, *coarse);
        coarse = &small;
        ++pictures.level;
    }
    pictures.coarse = Planes(&core.memory, coarse->width, coarse->height, 4, Array<float>::unset);
    for (std::uint32_t c = 0; c < 4; ++c)
        for (std::size_t i = 0; i < coarse->pixels.size(); ++i)
            pictures.coarse.plane(c)[i] = coarse->pixels[i].value[c];
    return pictures;
}

std::uint32_t find_contents(std::pmr::memory_resource* memory, const Search_pictures& pictures,
                            const Patch_shape& shape, std::uint32_t turn, std::uint32_t scale, Found* found)
{
    const Turning turning(turn, offered_scale[scale]);
    const Samples samples = samples_of(shape, turning);
    const Bounds places = places_of(shape, turning, pictures.bounds);
    const auto unit = static_cast<std::int32_t>(1U << pictures.level);
    const std::int32_t side =
        static_cast<std::int32_t>(std::max(pictures.scaled[0].width, pictures.scaled[0].height)); // of the structure
    const Own_place own{shape.x % static_cast<std::int32_t>(pictures.scaled[0].width),
                        shape.y % static_cast<std::int32_t>(pictures.scaled[0].height), side / 12};
    const Own_place* const excluded = turn == 0 ? &own : nullptr;
    Error_map map = error_map_of(memory, pictures, places, samples, excluded);
    std::uint32_t count = 0;
    for (std::int32_t x = 0, y = 0; count < most_found && take_least(map, side / 24 / unit, x, y); ++count) {
        found[count] = {turn, scale, (map.left + x) * unit, (map.top + y) * unit, 0};
        refine(pictures.scaled[scale], samples, places, unit / 2, excluded, found[count]);
    }
    return count;
}

} // namespace weft
