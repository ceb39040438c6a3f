/// Ranks by counting.
#include "analysis/tile_histogram.h"
#include "analysis/compare_pair.h"
#include <algorithm>

namespace weft {
namespace {

constexpr std::uint32_t rows_a_task = 32;
constexpr int origin = lab_bound + 1;

/// For each value of `counts`, the value at which `goal` has as much below it as half of that value's own has.
void match(const std::uint64_t* counts, std::uint64_t total, const std::uint64_t* goal, std::uint64_t goal_total,
           std::int16_t* map) noexcept
{
    const double scale = static_cast<double>(goal_total) / static_cast<double>(total);
    double below = 0, goal_below = 0;
    std::uint32_t g = 0;
    for (std::uint32_t v = 0; v < Value_counts::values; ++v) {
        map[v] = static_cast<std::int16_t>(static_cast<int>(v) - origin);
        if (counts[v] == 0) continue;
        const auto own = static_cast<double>(counts[v]);
        const double rank = (below + own / 2) * scale;
        below += own;
        while (g + 1 < Value_counts::values && goal_below + static_cast<double>(goal[g]) < rank)
            goal_below += static_cast<double>(goal[g++]);
        map[v] = static_cast<std::int16_t>(static_cast<int>(g) - origin);
    }
}

} // namespace

Value_counts::Value_counts(Core& core, const Lab_picture& picture, const Progress& progress)
    : counts_(&core.memory, std::size_t{picture.channels} * values),
      total_(std::uint64_t{picture.width} * picture.height)
{
    const std::uint32_t channels = picture.channels, size = channels * values;
    const std::uint32_t parts = std::min(picture.height, 16u);
    Array<std::uint32_t> partial(&core.memory, std::size_t{parts} * size);
    const double cost = 2.0 * static_cast<double>(total_) / parts;
    // A row at a time of each part, so that few pixels lie between two reports.
    const std::uint32_t steps = (picture.height + parts - 1) / parts;
    constexpr std::uint32_t rows_together = 64;
    for (std::uint32_t step = 0; step < steps; step += rows_together) {
        const std::uint32_t step_end = std::min(steps, step + rows_together);
        for_each_step(core, parts, cost * (step_end - step) / steps,
                      progress.part(static_cast<double>(step) / steps, static_cast<double>(step_end) / steps),
                      [&](std::uint32_t part) {
                          std::uint32_t* own = partial.data() + std::size_t{part} * size;
                          for (std::uint32_t i = step; i < step_end; ++i) {
                              const std::uint32_t y = i * parts + part;
                              if (y >= picture.height) return;
                              const std::int16_t* row = picture.at(0, y);
                              for (std::uint32_t x = 0; x < picture.width; ++x)
                                  for (std::uint32_t c = 0; c < channels; ++c)
                                      ++own[c * values + static_cast<std::uint32_t>(row[x * channels + c] + origin)];
                          }
                      });
    }
    for (std::uint32_t part = 0; part < parts; ++part)
        for (std::uint32_t i = 0; i < size; ++i) counts_[i] += partial[std::size_t{part} * size + i];
}

void match_histogram(Core& core, const Value_counts& goal, Lab_picture& tile, const Progress& progress)
{
    const std::uint32_t channels = tile.channels;
    const Value_counts counts(core, tile, progress.part(0, 0.5));
    Array<std::int16_t> maps(&core.memory, std::size_t{channels} * Value_counts::values, Array<std::int16_t>::unset);
    for (std::uint32_t c = 0; c < channels; ++c)
        match(counts.channel(c), counts.total(), goal.channel(c), goal.total(),
              maps.data() + std::size_t{c} * Value_counts::values);
    const std::uint32_t tasks = (tile.height + rows_a_task - 1) / rows_a_task;
    for_each_step(core, tasks, 2.0 * rows_a_task * tile.width, progress.part(0.5, 1), [&](std::uint32_t task) {
        for (std::uint32_t y = task * rows_a_task; y < std::min(tile.height, (task + 1) * rows_a_task); ++y) {
            std::int16_t* row = tile.at(0, y);
            for (std::uint32_t x = 0; x < tile.width; ++x)
                for (std::uint32_t c = 0; c < channels; ++c) {
                    std::int16_t& value = row[x * channels + c];
                    value = maps[c * Value_counts::values + static_cast<std::uint32_t>(value + origin)];
                }
        }
    });
}

} // namespace weft
