/// Votes by runs of pixels whose patches lie side by side in the exemplar, as most do: a run proposes one exemplar
/// pixel for each pixel in its reach, with the sum of the weights of its patches that cover it.
#include "analysis/vote.h"
#include "analysis/compare_pair.h"
#include <algorithm>

namespace weft {
namespace {

constexpr std::uint32_t rows_a_task = 32;

/// Sums for some rows of the tile, with the field's reach on both sides of each.
class Sums {
public:
    Sums(Core& core, const Match_field& field, const Lab_picture& exemplar, std::uint32_t first, std::uint32_t end)
        : field_(field), exemplar_(exemplar), first_(first), rows_(end - first),
          line_(std::size_t{field.width} + 2 * field.reach), channels_(exemplar.channels),
          values_(&core.memory, rows_ * line_ * channels_), weights_(&core.memory, rows_ * line_),
          run_(&core.memory, line_ * channels_, Array<std::int16_t>::unset)
    {
    }

    /// Row `y` of the field, counted on from 0 or from the tile's height, votes for the rows in its reach.
    void add_row(std::int64_t y)
    {
        const auto height = static_cast<std::int64_t>(field_.height);
        const std::size_t start = static_cast<std::size_t>((y + height) % height) * field_.width;
        const Place* places = field_.places.data() + start;
        for (std::uint32_t begin = 0; begin < field_.width;) {
            std::uint32_t end = begin + 1;
            while (end < field_.width && places[end].y == places[begin].y &&
                   places[end].x == places[begin].x + (end - begin))
                ++end;
            add_run(y, field_.weights.data() + start, begin, end, places[begin]);
            begin = end;
        }
    }

    void write(Lab_picture& tile)
    {
        const std::size_t reach = field_.reach;
        for (std::uint32_t row = 0; row < rows_; ++row) {
            std::int32_t* values = values_.data() + row * line_ * channels_;
            std::int32_t* weights = weights_.data() + row * line_;
            fold(values, channels_);
            fold(weights, 1);
            std::int16_t* target = tile.at(0, first_ + row);
            for (std::uint32_t x = 0; x < field_.width; ++x) {
                const float share = 1 / static_cast<float>(weights[reach + x]);
                for (std::uint32_t c = 0; c < channels_; ++c) {
                    const float mean = static_cast<float>(values[(reach + x) * channels_ + c]) * share;
                    target[x * channels_ + c] = static_cast<std::int16_t>(static_cast<int>(mean + 4096.5f) - 4096);
                }
            }
        }
    }

private:
    void add_run(std::int64_t y, const std::uint8_t* votes, std::uint32_t begin, std::uint32_t end, Place place)
    {
        const std::uint32_t side = 2 * field_.reach + 1, count = end - begin + side - 1;
        std::int16_t covering = 0;
        for (std::uint32_t i = 0; i < count; ++i) { // pixel begin + i - reach
            if (i < end - begin) covering = static_cast<std::int16_t>(covering + votes[begin + i]);
            if (i >= side) covering = static_cast<std::int16_t>(covering - votes[begin + i - side]);
            for (std::uint32_t c = 0; c < channels_; ++c) run_[i * channels_ + c] = covering;
        }
        const auto reach = static_cast<std::int64_t>(field_.reach), last = std::int64_t{first_} + rows_ - 1;
        for (std::int64_t row = std::max<std::int64_t>(first_, y - reach); row <= std::min(last, y + reach); ++row) {
            const std::int16_t* source =
                exemplar_.at(place.x - field_.reach, static_cast<std::size_t>(place.y + row - y));
            const std::size_t target = static_cast<std::size_t>(row - first_) * line_ + begin;
            std::int32_t *values = values_.data() + target * channels_, *weights = weights_.data() + target;
            for (std::size_t i = 0; i < std::size_t{count} * channels_; ++i)
                values[i] += static_cast<std::int32_t>(run_[i]) * source[i];
            for (std::size_t i = 0; i < count; ++i) weights[i] += run_[i * channels_];
        }
    }

    /// Adds what lies beyond either end to where the tile goes on.
    void fold(std::int32_t* sums, std::size_t n) const noexcept
    {
        const std::size_t side = field_.reach * n, width = field_.width * n;
        for (std::size_t i = 0; i < side; ++i) sums[width + i] += sums[i];
        for (std::size_t i = 0; i < side; ++i) sums[side + i] += sums[side + width + i];
    }

    const Match_field& field_;
    const Lab_picture& exemplar_;
    const std::uint32_t first_, rows_;
    const std::size_t line_, channels_;
    Array<std::int32_t> values_, weights_;
    Array<std::int16_t> run_; ///< of the run under way: the weight for each value in its reach
};

} // namespace

void vote(Core& core, const Match_field& field, const Lab_picture& exemplar, Lab_picture& tile,
          const Progress& progress)
{
    const std::uint32_t tasks = (field.height + rows_a_task - 1) / rows_a_task;
    const double cost = 10.0 * rows_a_task * field.width * (2 * field.reach + 1);
    for_each_step(core, tasks, cost, progress, [&](std::uint32_t task) {
        const std::uint32_t first = task * rows_a_task, end = std::min(field.height, first + rows_a_task);
        Sums sums(core, field, exemplar, first, end);
        for (std::int64_t y = std::int64_t{first} - field.reach; y < std::int64_t{end} + field.reach; ++y)
            sums.add_row(y);
        sums.write(tile);
    });
}

} // namespace weft
