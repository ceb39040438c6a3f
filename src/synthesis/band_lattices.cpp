/// Sizes by period, one lattice for equal sizes, weights over deviations.
#include "synthesis/band_lattices.h"
#include "base/hash.h"
#include <algorithm>
#include <cmath>

namespace weft {

namespace {

constexpr std::uint32_t plane_side = 256, solid_side = 64;
constexpr std::uint32_t least_side = 16;     ///< of make_wavelet_lattice
constexpr std::uint32_t longest_side = 4096; ///< of an endless axis beside one with an odd period

/// How often 2 divides the period; an endless axis never ends to be even.
std::uint32_t halvings_of(std::uint32_t period) noexcept
{
    std::uint32_t count = 0;
    while (period != 0 && period % 2 == 0) {
        period /= 2;
        ++count;
    }
    return period == 0 ? 32 : count;
}

/// An even divisor of an even `length`: not so small that repeats are seen, not larger than need be.
std::uint32_t even_divisor(std::uint32_t length) noexcept
{
    for (std::uint32_t side = plane_side; side >= plane_side / 2; side -= 2)
        if (length % side == 0) return side;
    for (std::uint32_t side = plane_side + 2; side < length; side += 2)
        if (length % side == 0) return side;
    return length;
}

} // namespace

/// The sides of each band's lattice; the last one holds `octaves` bands.
struct Band_lattices::Plan {
    std::uint32_t count = 0, octaves = 1;
    bool solid = false;
    Sides sides[most_bands]{};
};

Band_lattices::Band_lattices(Core& core, const Wavelet& wavelet, std::uint32_t axes, std::uint64_t seed,
                             std::uint32_t period_x, std::uint32_t period_y)
    : lattices_(&core.memory)
{
    const std::uint32_t halvings = std::min(halvings_of(period_x), halvings_of(period_y));
    Plan plan;
    plan.count = std::min(wavelet.bands, halvings + 1);
    plan.octaves = wavelet.bands + 1 - plan.count;
    for (std::uint32_t b = 0; b < plan.count; ++b) {
        const auto side = [&](std::uint32_t period) {
            if (b < halvings) return period == 0 ? plane_side : even_divisor(period >> b);
            const std::uint32_t long_enough = std::clamp(8U << (plan.octaves - 1), plane_side, longest_side);
            return period == 0 ? long_enough : period >> b;
        };
        plan.sides[b] = {side(period_x), side(period_y), 1};
    }
    make_all(core, wavelet, axes, seed, plan);
}

Band_lattices::Band_lattices(Core& core, const Wavelet& wavelet, std::uint32_t axes, std::uint64_t seed)
    : lattices_(&core.memory)
{
    Plan plan;
    plan.count = wavelet.bands;
    plan.solid = true;
    std::fill_n(plan.sides, plan.count, Sides{solid_side, solid_side, solid_side});
    make_all(core, wavelet, axes, seed, plan);
}

void Band_lattices::make_all(Core& core, const Wavelet& wavelet, std::uint32_t axes, std::uint64_t seed,
                             const Plan& plan)
{
    table_ = Array<weft_band>(&core.memory, std::size_t{plan.count} * axes);
    bands_ = {sizeof bands_, plan.count, table_.data()};
    lattices_.reserve(std::size_t{plan.count} * axes);
    for (std::uint32_t p = 0; p < axes; ++p) make(core, wavelet, p, mix_in(mix_in(seed, plan.solid ? 3 : 2), p), plan);
}

/// All bands of one axis.
void Band_lattices::make(Core& core, const Wavelet& wavelet, std::uint32_t axis, std::uint64_t key, const Plan& plan)
{
    Shared shared;
    const std::size_t axes = table_.size() / plan.count;
    for (std::uint32_t b = 0; b < plan.count; ++b) {
        weft_band& band = table_[b * axes + axis];
        const Sides sides = plan.sides[b];
        band.width = sides.width;
        band.height = sides.height;
        band.depth = sides.depth;
        const std::uint32_t octaves = b + 1 == plan.count ? plan.octaves : 1;
        float deviations[most_bands];
        for (std::uint32_t c = 0; c < octaves; ++c) deviations[c] = wavelet.weight[b + c][axis];
        if (std::all_of(deviations, deviations + octaves, [](float deviation) { return deviation == 0; })) continue;

        const std::uint64_t band_key = mix_in(key, std::uint64_t{sides.width} << 32 | sides.height);
        const std::uint32_t parts_log2 = plan.solid ? most_parts_log2 + 1 : std::min(b, most_parts_log2 + 1);
        const bool even = sides.width % 2 == 0 && sides.height % 2 == 0;
        if (even && octaves == 1 && std::min(sides.width, sides.height) >= least_side) {
            share(core, shared, sides, band_key, parts_log2);
            band.lattice = shared.lattice->values.data();
            band.weight = static_cast<float>(static_cast<double>(deviations[0]) / std::sqrt(shared.power));
            const Sides shift = hashed_shift(sides, mix_in(band_key, 1 + b));
            band.x = shift.width;
            band.y = shift.height;
            band.z = shift.depth;
        } else {
            const Taps overlap = spline_overlap(parts_log2);
            lattices_.push_back(make_octaves(core, sides, band_key, filters_, overlap, octaves, deviations));
            band.lattice = lattices_.back().values.data();
            band.weight = 1;
        }
    }
}

/// Makes a lattice of these sides, unless the last one is, and measures it, unless that was done in the same way.
void Band_lattices::share(Core& core, Shared& shared, const Sides& sides, std::uint64_t key, std::uint32_t parts_log2)
{
    const bool known = shared.lattice && shared.lattice->sides == sides;
    if (!known) {
        lattices_.push_back(make_wavelet_lattice(core, sides, key, filters_));
        shared.lattice = &lattices_.back();
    }
    if (known && parts_log2 == shared.parts_log2) return;
    shared.power = power_of(core, *shared.lattice, spline_overlap(parts_log2));
    shared.parts_log2 = parts_log2;
}

} // namespace weft
