/// First guesses of a correspondence, and the weights of its votes.
#include "analysis/match_field.h"
#include "base/elementary.h"
#include "base/hash.h"
#include <algorithm>

namespace weft {
namespace {

/// x scaled down from 32 random bits to 0..count - 1.
std::uint32_t below(std::uint32_t count, std::uint32_t bits) noexcept
{
    return static_cast<std::uint32_t>((std::uint64_t{bits} * count) >> 32);
}

/// Along one axis: where pixel i of `to` reads in `from`, and where that patch's middle goes.
struct Axis {
    std::uint32_t from, to, from_exemplar, to_exemplar, reach;

    std::uint32_t source(std::uint32_t i) const noexcept
    {
        return static_cast<std::uint32_t>((2 * std::uint64_t{i} + 1) * from / (2 * std::uint64_t{to}));
    }
    std::uint16_t middle(std::uint32_t i, std::uint32_t place) const noexcept
    {
        const float offset = (static_cast<float>(i) + 0.5f) * static_cast<float>(from) / static_cast<float>(to) -
                             (static_cast<float>(source(i)) + 0.5f);
        const float scaled = (static_cast<float>(place) + 0.5f + offset) * static_cast<float>(to_exemplar) /
                             static_cast<float>(from_exemplar);
        const auto nearest = static_cast<std::uint32_t>(std::max(scaled, 0.0f));
        return static_cast<std::uint16_t>(std::min(std::max(nearest, reach), to_exemplar - 1 - reach));
    }
};

/// The third quartile, up to the step of a table with eight entries an octave.
std::uint64_t third_quartile(const Array<std::uint64_t>& costs) noexcept
{
    constexpr std::uint32_t steps = 8, bits = 64;
    std::uint32_t counts[bits * steps] = {};
    const auto step_of = [](std::uint64_t cost) -> std::uint32_t {
        if (cost < steps) return static_cast<std::uint32_t>(cost);
        const auto exponent = static_cast<std::uint32_t>(63 - __builtin_clzll(cost));
        return (exponent - 2) * steps + static_cast<std::uint32_t>((cost >> (exponent - 3)) & (steps - 1));
    };
    for (const std::uint64_t cost : costs) ++counts[step_of(cost)];
    std::uint64_t seen = 0;
    std::uint32_t step = 0;
    while (step + 1 < bits * steps && (seen += counts[step]) * 4 < costs.size() * 3) ++step;
    return step < steps ? step : std::uint64_t{steps + step % steps} << (step / steps - 1);
}

} // namespace

Match_field::Match_field(std::pmr::memory_resource* memory, std::uint32_t w, std::uint32_t h, std::uint32_t r)
    : width(w), height(h), reach(r), places(memory, area(), Array<Place>::unset), costs(memory, area()),
      weights(memory, area(), Array<std::uint8_t>::unset)
{
    std::fill_n(weights.data(), weights.size(), std::uint8_t{1});
}

void scatter(Core& core, const Lab_picture& exemplar, std::uint64_t key, Match_field& field)
{
    const std::uint32_t reach = field.reach;
    core.parallel.for_each_index(field.height, [&](std::uint32_t y) {
        for (std::uint32_t x = 0; x < field.width; ++x) {
            const std::size_t i = std::size_t{y} * field.width + x;
            const std::uint64_t bits = mix_in(key, i);
            field.places[i] = {
                static_cast<std::uint16_t>(reach + below(exemplar.width - 2 * reach, static_cast<std::uint32_t>(bits))),
                static_cast<std::uint16_t>(reach +
                                           below(exemplar.height - 2 * reach, static_cast<std::uint32_t>(bits >> 32)))};
        }
    });
}

void rescale(Core& core, const Match_field& from, std::uint32_t from_exemplar_width, std::uint32_t from_exemplar_height,
             const Lab_picture& exemplar, Match_field& field)
{
    const Axis across{from.width, field.width, from_exemplar_width, exemplar.width, field.reach};
    const Axis down{from.height, field.height, from_exemplar_height, exemplar.height, field.reach};
    core.parallel.for_each_index(field.height, [&](std::uint32_t y) {
        for (std::uint32_t x = 0; x < field.width; ++x) {
            const Place place = from.places[std::size_t{down.source(y)} * from.width + across.source(x)];
            field.places[std::size_t{y} * field.width + x] = {across.middle(x, place.x), down.middle(y, place.y)};
        }
    });
}

void weigh(Core& core, Match_field& field)
{
    constexpr int most = 16;
    constexpr double ln2 = 0.6931471805599453;
    const auto scale = 0.5 * static_cast<double>(third_quartile(field.costs));
    std::uint64_t bounds[most - 1]; // 15 exp(-cost / scale) >= k
    for (int k = 1; k < most; ++k)
        bounds[k - 1] = static_cast<std::uint64_t>(scale * ln2 * log2_of(static_cast<double>(most - 1) / k));
    core.parallel.for_each_index(field.height, [&](std::uint32_t y) {
        const std::uint64_t* costs = field.costs.data() + std::size_t{y} * field.width;
        std::uint8_t* weights = field.weights.data() + std::size_t{y} * field.width;
        for (std::uint32_t x = 0; x < field.width; ++x) {
            std::uint8_t weight = 1;
            for (const std::uint64_t bound : bounds) weight = static_cast<std::uint8_t>(weight + (costs[x] <= bound));
            weights[x] = weight;
        }
    });
}

} // namespace weft
