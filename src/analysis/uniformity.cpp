/// Counts, smoothed over the reach of two patches.
#include "analysis/uniformity.h"
#include <algorithm>

namespace weft {
namespace {

/// Along one axis, with `step` from one count to the next: weights 1 2 3 2 1, the tent that two boxes of about a patch
/// make.
void smooth(std::uint32_t* counts, std::uint32_t size, std::size_t step) noexcept
{
    std::uint32_t before2 = 0, before1 = 0;
    const auto at = [&](std::uint32_t i) { return i < size ? counts[i * step] : 0; };
    for (std::uint32_t i = 0; i < size; ++i) {
        const std::uint32_t here = counts[i * step];
        counts[i * step] = before2 + 2 * before1 + 3 * here + 2 * at(i + 1) + at(i + 2);
        before2 = before1;
        before1 = here;
    }
}

} // namespace

/// Even use: as many patches cover a pixel of the exemplar as one of the tile, but for a tile that is the larger.
Uniformity::Uniformity(Core& core, const Lab_picture& exemplar, const Match_field& field)
    : across_((exemplar.width + cell - 1) / cell), down_((exemplar.height + cell - 1) / cell),
      counts_(&core.memory, std::size_t{across_} * down_), penalties_(&core.memory, std::size_t{across_} * down_)
{
    const double pixels = static_cast<double>(exemplar.width) * exemplar.height;
    constexpr double tent = 81;
    even_ = static_cast<float>(std::max(1.0, static_cast<double>(field.area()) / pixels) * cell * cell * tent);
}

void Uniformity::count(const Match_field& field, double unit)
{
    std::fill_n(counts_.data(), counts_.size(), 0u);
    for (const Place place : field.places) ++counts_[std::size_t{place.y / cell} * across_ + place.x / cell];
    for (std::uint32_t y = 0; y < down_; ++y) smooth(counts_.data() + std::size_t{y} * across_, across_, 1);
    for (std::uint32_t x = 0; x < across_; ++x) smooth(counts_.data() + x, down_, across_);
    constexpr float most = 1e9f;
    const auto scale = static_cast<float>(unit);
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        const float excess = static_cast<float>(counts_[i]) / even_ - 1;
        penalties_[i] = static_cast<std::uint32_t>(std::min(std::max(excess, 0.0f) * scale, most));
    }
}

} // namespace weft
