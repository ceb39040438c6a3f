/// Feathers are as wide as 5 texels, or 1 1/4 pixels of the level; contents are those that the options allow.
#include "synthesis/structure_tables.h"
#include "base/elementary.h"
#include "synthesis/grid.h"
#include <algorithm>

namespace weft {

namespace {

double feather_width(std::uint32_t level) noexcept { return std::max(5.0, 1.25 * static_cast<double>(1U << level)); }

/// Rows of the matrix that turns by eighths of a turn and divides by the scale.
void set_turn(float* turn, std::uint32_t eighths, float scale) noexcept
{
    constexpr double half = 0.70710678118654752440;
    static constexpr double cosines[] = {1, half, 0, -half, -1}, sines[] = {0, half, 1, half, 0};
    const double s = static_cast<double>(scale), c = cosines[eighths] / s, d = sines[eighths] / s;
    turn[0] = static_cast<float>(c);
    turn[1] = static_cast<float>(0 - d);
    turn[2] = static_cast<float>(d);
    turn[3] = static_cast<float>(c);
}

} // namespace

void Structure_tables::make(Core& core, const Bilayer& bilayer, const weft_texture_options& options)
{
    make_picture_mips(mips_, bilayer.structure, &core.memory, core.parallel);
    const bool wang = bilayer.wang.colours > 0;
    tile = repeated_tile(mips_.mips, wang ? bilayer.wang.width : bilayer.structure.width,
                         wang ? bilayer.wang.height : bilayer.structure.height, 1, options.period_x, options.period_y);
    if (wang) {
        make_wang(core, bilayer.wang);
        tile.address = WEFT_ADDRESS_WANG;
        tile.wang = &wang_;
    }
    if (!bilayer.exchange.patches.empty()) {
        make_exchange(core, bilayer, options);
        tile.exchange = &exchange_;
    }
}

void Structure_tables::make_wang(Core& core, const Wang& from)
{
    wang_.size = sizeof wang_;
    wang_.colours = from.colours;
    wang_.knots = from.knots;
    wang_.unit_x = static_cast<float>(from.knots) / static_cast<float>(from.width);
    wang_.unit_y = static_cast<float>(from.knots) / static_cast<float>(from.height);
    diamonds_ = Array<weft_diamond>(&core.memory, from.diamonds.size());
    for (std::size_t i = 0; i < diamonds_.size(); ++i) diamonds_[i] = {from.diamonds[i].x, from.diamonds[i].y};
    wang_.diamonds = diamonds_.data();
    wang_.contours = from.contours.data();
    const std::uint32_t knots = from.knots, levels = mips_.mips.levels;
    sharp_ = Array<float>(&core.memory, std::size_t{levels} * (knots + 1));
    const double unit = (static_cast<double>(wang_.unit_x) + static_cast<double>(wang_.unit_y)) / 2;
    for (std::uint32_t l = 0; l < levels; ++l)
        for (std::uint32_t k = 0; k <= knots; ++k) {
            // A feather ends where two quarters meet: contours keep to 0.8 of the way there.
            const std::uint32_t end = std::max(1U, std::min(k, knots - k));
            const double sharp = std::max(1 / (2 * feather_width(l) * unit), 1 / (0.4 * end));
            sharp_[std::size_t{l} * (knots + 1) + k] = static_cast<float>(std::min(sharp, 16.0));
        }
    wang_.sharp = sharp_.data();
}

/// Every patch keeps its first content, which is itself.
void Structure_tables::make_exchange(Core& core, const Bilayer& bilayer, const weft_texture_options& options)
{
    const Exchange& from = bilayer.exchange;
    const std::uint32_t turns = options.rotation == WEFT_ROTATION_NONE  ? 1
                                : options.rotation == WEFT_ROTATION_ALL ? 31
                                                                        : bilayer.turns | 1;
    const float least = options.scale_min > 0 ? options.scale_min : bilayer.least_scale;
    patches_ = Array<weft_patch>(&core.memory, from.patches.size());
    contents_ = Array<weft_content>(&core.memory, from.contents.size());
    contours_ = Array<std::uint8_t>(&core.memory, from.contours.size());
    std::uint32_t kept = 0;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
        const Exchange::Patch& patch = from.patches[p];
        const std::uint32_t first = kept;
        for (std::uint32_t i = 0; i < patch.count; ++i) {
            const Exchange::Content& content = from.contents[patch.first + i];
            if (i > 0 && ((turns >> content.turn & 1) == 0 || content.scale < least)) continue;
            weft_content& to = contents_[kept];
            to.x = content.x;
            to.y = content.y;
            set_turn(to.turn, content.turn, content.scale);
            to.level = static_cast<float>(std::max(0.0, -log2_of(static_cast<double>(content.scale))));
            std::copy_n(&from.contours[std::size_t{patch.first + i} * contour_knots], contour_knots,
                        &contours_[std::size_t{kept++} * contour_knots]);
        }
        const std::uint32_t count = kept - first;
        for (std::uint32_t i = 0; i < count; ++i)
            contents_[first + i].until = static_cast<std::uint32_t>(((std::uint64_t{i} + 1) << 32) / count - 1);
        patches_[p] = {patch.x, patch.y, first, count};
    }
    feather_ = Array<float>(&core.memory, mips_.mips.levels);
    for (std::uint32_t l = 0; l < mips_.mips.levels; ++l) feather_[l] = static_cast<float>(1 / (8 * feather_width(l)));
    exchange_ = {sizeof exchange_, static_cast<std::uint32_t>(patches_.size()),
                 from.map.data(),  patches_.data(),
                 contents_.data(), contours_.data(),
                 feather_.data()};
}

} // namespace weft
