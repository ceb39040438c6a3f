/// Clusters in colour and place: each texel goes to the nearest centre, centres to the middle of their texels.
#include "analysis/exchange_patches.h"
#include "analysis/compare_pair.h"
#include "analysis/exchange_pieces.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace weft {
namespace {

constexpr float compactness = 16, reach = 1.6f; ///< squared, of places in sides against features; in sides
constexpr std::uint32_t iterations = 5, band_rows = 32;

struct Centre {
    float x, y;
    Feature feature;
};

class Clustering {
public:
    Clustering(Core& core, const Features& features, const View& view, float side, const Progress& progress)
        : core_(core), features_(features), view_(view), grid_(view), side_(side),
          patch_(&core.memory, view.area(), Array<std::uint32_t>::unset), nearest_(&core.memory, view.area())
    {
        seed();
        for (std::uint32_t i = 0; i < iterations && count_ > 0; ++i) {
            assign(progress.part(i / (iterations + 1.0), (i + 1) / (iterations + 1.0)));
            move();
        }
        assign(progress.part(iterations / (iterations + 1.0), 1));
    }
    Array<std::uint32_t>& patch() noexcept { return patch_; }
    std::uint32_t count() const noexcept { return count_; }

private:
    const Feature& feature(std::uint32_t x, std::uint32_t y) const noexcept
    {
        return features_.at((static_cast<std::uint32_t>(view_.x) + x) % features_.width,
                            (static_cast<std::uint32_t>(view_.y) + y) % features_.height);
    }
    /// On a grid of sides, where patches may be.
    void seed()
    {
        const auto cells = [this](std::uint32_t size) {
            return std::max(1U, static_cast<std::uint32_t>(static_cast<float>(size) / side_ + 0.5f));
        };
        const std::uint32_t across = cells(view_.width), down = cells(view_.height);
        centres_ = Array<Centre>(&core_.memory, std::size_t{across} * down);
        for (std::uint32_t j = 0; j < down; ++j)
            for (std::uint32_t i = 0; i < across; ++i) {
                const std::uint32_t x = (2 * i + 1) * view_.width / (2 * across),
                                    y = (2 * j + 1) * view_.height / (2 * down);
                if (view_.domain[std::size_t{y} * view_.width + x] == 0) continue;
                centres_[count_++] = {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, feature(x, y)};
            }
    }
    void assign(const Progress& progress)
    {
        std::fill(patch_.begin(), patch_.end(), no_patch);
        std::fill(nearest_.begin(), nearest_.end(), std::numeric_limits<float>::max());
        const std::uint32_t bands = (view_.height + band_rows - 1) / band_rows;
        for_each_step(core_, bands, 150.0 * band_rows * view_.width, progress, [this](std::uint32_t band) {
            const auto top = static_cast<std::int32_t>(band * band_rows),
                       bottom = std::min(top + static_cast<std::int32_t>(band_rows), grid_.height());
            for (std::uint32_t k = 0; k < count_; ++k)
                for (const std::int32_t around : {-1, 0, 1})
                    if (around == 0 || view_.torus) take(k, top, bottom, around * grid_.height());
        });
    }
    /// Texels of some rows that are nearer to a centre than to those before it; `down`: rows below its place on a
    /// torus.
    void take(std::uint32_t k, std::int32_t top, std::int32_t bottom, std::int32_t down)
    {
        const Centre& centre = centres_[k];
        const float unit = compactness / (side_ * side_), far = reach * side_;
        const auto down_f = static_cast<float>(down);
        const std::int32_t first_y = std::max(top, static_cast<std::int32_t>(std::floor(centre.y + down_f - far))),
                           last_y =
                               std::min(bottom - 1, static_cast<std::int32_t>(std::floor(centre.y + down_f + far))),
                           first_x = static_cast<std::int32_t>(std::floor(centre.x - far)),
                           last_x = static_cast<std::int32_t>(std::floor(centre.x + far));
        for (std::int32_t y = first_y; y <= last_y; ++y)
            for (std::int32_t x = first_x; x <= last_x; ++x) {
                const std::size_t i = grid_.at(x, y);
                if (i == Grid::none || view_.domain[i] == 0) continue;
                const float dx = static_cast<float>(x) + 0.5f - centre.x,
                            dy = static_cast<float>(y) + 0.5f - centre.y - down_f;
                const auto at_x = static_cast<std::uint32_t>(i % view_.width), at_y = static_cast<std::uint32_t>(y);
                const float from = 2 * distance(feature(at_x, at_y), centre.feature) + unit * (dx * dx + dy * dy);
                if (from >= nearest_[i]) continue;
                nearest_[i] = from;
                patch_[i] = k;
            }
    }
    void move()
    {
        struct Sum {
            double x, y, count, feature[4];
        };
        Array<Sum> sums(&core_.memory, count_);
        for (std::uint32_t y = 0; y < view_.height; ++y)
            for (std::uint32_t x = 0; x < view_.width; ++x) {
                const std::uint32_t k = patch_[std::size_t{y} * view_.width + x];
                if (k == no_patch) continue;
                sums[k].x += wrapped(static_cast<float>(x) + 0.5f - centres_[k].x, view_.width);
                sums[k].y += wrapped(static_cast<float>(y) + 0.5f - centres_[k].y, view_.height);
                sums[k].count += 1;
                for (int c = 0; c < 4; ++c) sums[k].feature[c] += static_cast<double>(feature(x, y).value[c]);
            }
        for (std::uint32_t k = 0; k < count_; ++k) {
            if (sums[k].count == 0) continue;
            centres_[k].x = held(centres_[k].x + static_cast<float>(sums[k].x / sums[k].count), view_.width);
            centres_[k].y = held(centres_[k].y + static_cast<float>(sums[k].y / sums[k].count), view_.height);
            for (int c = 0; c < 4; ++c)
                centres_[k].feature.value[c] = static_cast<float>(sums[k].feature[c] / sums[k].count);
        }
    }
    double wrapped(float difference, std::uint32_t size) const noexcept
    {
        const auto period = static_cast<float>(size);
        if (view_.torus && difference > period / 2) difference -= period;
        if (view_.torus && difference < -period / 2) difference += period;
        return static_cast<double>(difference);
    }
    float held(float place, std::uint32_t size) const noexcept
    {
        const auto period = static_cast<float>(size);
        return place < 0 ? place + period : place >= period ? place - period : place;
    }

    Core& core_;
    const Features& features_;
    const View& view_;
    const Grid grid_;
    float side_;
    std::uint32_t count_ = 0;
    Array<std::uint32_t> patch_;
    Array<float> nearest_;
    Array<Centre> centres_;
};

} // namespace

Patches_of_view patches_of(Core& core, const Features& features, const View& view, float side, const Progress& progress)
{
    Clustering clustering(core, features, view, side, progress);
    Patches_of_view result;
    result.patch = std::move(clustering.patch());
    const auto least = static_cast<std::uint32_t>(side * side / 6);
    result.count = keep_connected(&core.memory, Grid(view), clustering.count(), least, result.patch);
    result.depth = depths_of(&core.memory, Grid(view), result.patch);
    return result;
}

} // namespace weft
