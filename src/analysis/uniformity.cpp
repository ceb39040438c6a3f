/// Counts, smoothed over the reach of two patches.
#include "analysis/uniformity.h"
#include "analysis/compare_pair.h"
#include <algorithm>

namespace weft {
namespace {

constexpr std::uint32_t reach = 2,
                        weights[2 * reach + 1] = {1, 2, 3, 2, 1}; ///< the tent that two boxes of about a patch make

} // namespace

/// Even use: as many patches cover a pixel of the exemplar as one of the tile, but for a tile that is the larger.
Uniformity::Uniformity(Core& core, const Lab_picture& exemplar, const Match_field& field)
    : across_((exemplar.width + cell - 1) / cell), down_((exemplar.height + cell - 1) / cell),
      counts_(&core.memory, std::size_t{across_} * down_), smooth_(&core.memory, counts_.size()),
      penalties_(&core.memory, std::size_t{across_} * down_)
{
    const double pixels = static_cast<double>(exemplar.width) * exemplar.height;
    constexpr double tent = 81;
    even_ = static_cast<float>(std::max(1.0, static_cast<double>(field.area()) / pixels) * cell * cell * tent);
}

void Uniformity::count(Core& core, const Match_field& field, double unit, const Progress& progress)
{
    std::fill_n(counts_.data(), counts_.size(), 0u);
    for (const Place place : field.places) ++counts_[std::size_t{place.y / cell} * across_ + place.x / cell];
    constexpr float most = 1e9f;
    const auto scale = static_cast<float>(unit);
    for_each_step(core, down_, 8.0 * across_, progress.part(0, 0.5), [&](std::uint32_t y) {
        const std::uint32_t *counts = counts_.data() + std::size_t{y} * across_, last = across_ - 1;
        for (std::uint32_t x = 0; x < across_; ++x) {
            std::uint32_t sum = 0;
            for (std::uint32_t k = x < reach ? reach - x : 0; k <= 2 * reach && x + k - reach <= last; ++k)
                sum += weights[k] * counts[x + k - reach];
            smooth_[std::size_t{y} * across_ + x] = sum;
        }
    });
    for_each_step(core, down_, 8.0 * across_, progress.part(0.5, 1), [&](std::uint32_t y) {
        std::uint32_t* penalties = penalties_.data() + std::size_t{y} * across_;
        std::fill_n(penalties, across_, 0u);
        for (std::uint32_t k = y < reach ? reach - y : 0; k <= 2 * reach && y + k - reach < down_; ++k)
            for (std::uint32_t x = 0; x < across_; ++x)
                penalties[x] += weights[k] * smooth_[std::size_t{y + k - reach} * across_ + x];
        for (std::uint32_t x = 0; x < across_; ++x) {
            const float excess = static_cast<float>(penalties[x]) / even_ - 1;
            penalties[x] = static_cast<std::uint32_t>(std::min(std::max(excess, 0.0f) * scale, most));
        }
    });
}

} // namespace weft
