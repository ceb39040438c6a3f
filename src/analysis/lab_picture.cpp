/// From the photo to Lab, and to coarser levels.
#include "analysis/lab_picture.h"
#include "analysis/compare_pair.h"
#include "analysis/lab.h"
#include <algorithm>
#include <cstring>

namespace weft {
namespace {

constexpr std::uint32_t rows_a_task = 16;

struct Range {
    float low = 0, high = 1;
};

Range range_of(Core& core, const Planes& photo, std::uint32_t channels, const Progress& progress)
{
    Array<Range> ranges(&core.memory, photo.height);
    for_each_step(core, photo.height, photo.width, progress, [&](std::uint32_t y) {
        for (std::uint32_t c = 0; c < channels; ++c) {
            const float* row = photo.row(c, y);
            float low = ranges[y].low, high = ranges[y].high;
            for (std::uint32_t x = 0; x < photo.width; ++x) {
                low = row[x] < low ? row[x] : low;
                high = row[x] > high ? row[x] : high;
            }
            ranges[y] = {low, high};
        }
    });
    Range all;
    for (const Range& range : ranges) all = {std::min(all.low, range.low), std::max(all.high, range.high)};
    return all;
}

std::int16_t sixteenths(float value) noexcept
{
    constexpr float upwards = 4096.5f; // truncation of what is positive rounds to nearest
    return static_cast<std::int16_t>(static_cast<int>(value * static_cast<float>(lab_scale) + upwards) - 4096);
}

/// The part of `sources` values that falls into part i of `parts`: the first, and the weights of as many as follow.
struct Box {
    std::uint32_t first = 0, count = 0;
    float weights[66] = {};
};

} // namespace

void Lab_picture::wrap() noexcept
{
    const std::size_t side = std::size_t{margin} * channels, line = std::size_t{width} * channels;
    for (std::uint32_t y = 0; y < height; ++y) {
        std::int16_t* row = at(0, y);
        std::memcpy(row - side, row + line - side, side * sizeof *row);
        std::memcpy(row + line, row, side * sizeof *row);
    }
    const std::size_t bytes = stride() * sizeof(std::int16_t);
    for (std::uint32_t y = 0; y < margin; ++y) {
        std::memcpy(values.data() + y * stride(), values.data() + (height + y) * stride(), bytes);
        std::memcpy(values.data() + (height + margin + y) * stride(), values.data() + (margin + y) * stride(), bytes);
    }
}

Lab_picture lab_of(Core& core, const Planes& photo, const Progress& progress)
{
    const std::uint32_t channels = photo.count < 3 ? 1 : 3;
    const Range range = range_of(core, photo, channels, progress.part(0, 0.2));
    const float scale = 1 / (range.high - range.low);
    const Lab_curves curves(&core.memory);
    Lab_picture lab(&core.memory, photo.width, photo.height, channels, 0);
    for_each_step(core, photo.height, 32.0 * photo.width, progress.part(0.2, 1), [&](std::uint32_t y) {
        const auto value = [&](std::uint32_t c, std::uint32_t x) { return (photo.row(c, y)[x] - range.low) * scale; };
        std::int16_t* row = lab.at(0, y);
        for (std::uint32_t x = 0; x < photo.width; ++x) {
            if (channels == 1) {
                row[x] = sixteenths(curves.lightness(value(0, x)));
                continue;
            }
            const Lab colour = curves.of(value(0, x), value(1, x), value(2, x));
            row[3 * x] = sixteenths(colour.l);
            row[3 * x + 1] = sixteenths(colour.a);
            row[3 * x + 2] = sixteenths(colour.b);
        }
    });
    return lab;
}

Lab_picture reduced(Core& core, const Lab_picture& picture, std::uint32_t width, std::uint32_t height,
                    const Progress& progress)
{
    const std::uint32_t channels = picture.channels;
    const std::size_t line = std::size_t{picture.width} * channels;
    Lab_picture result(&core.memory, width, height, channels, 0);
    const std::uint32_t tasks = (height + rows_a_task - 1) / rows_a_task;
    const double cost = static_cast<double>(line) * picture.height / tasks;
    // Source j covers [j, j + 1) * parts, part i covers [i, i + 1) * sources.
    const auto overlap = [](std::uint64_t i, std::uint64_t sources, std::uint64_t j, std::uint64_t parts) {
        const std::uint64_t begin = std::max(i * sources, j * parts);
        const std::uint64_t end = std::min((i + 1) * sources, (j + 1) * parts);
        return static_cast<float>(end - begin) / static_cast<float>(sources);
    };
    const auto last_of = [](std::uint64_t i, std::uint64_t sources, std::uint64_t parts) {
        return ((i + 1) * sources + parts - 1) / parts;
    };
    for_each_step(core, tasks, cost, progress, [&](std::uint32_t task) {
        Array<float> sums(&core.memory, line, Array<float>::unset);
        const std::uint32_t end = std::min(height, (task + 1) * rows_a_task);
        for (std::uint32_t y = task * rows_a_task; y < end; ++y) {
            std::fill_n(sums.data(), line, 0.0f);
            for (std::uint64_t j = std::uint64_t{y} * picture.height / height; j < last_of(y, picture.height, height);
                 ++j) {
                const std::int16_t* source = picture.at(0, j);
                const float weight = overlap(y, picture.height, j, height);
                for (std::size_t i = 0; i < line; ++i) sums[i] += weight * static_cast<float>(source[i]);
            }
            std::int16_t* target = result.at(0, y);
            for (std::uint32_t x = 0; x < width; ++x) {
                float colour[3] = {};
                for (std::uint64_t j = std::uint64_t{x} * picture.width / width; j < last_of(x, picture.width, width);
                     ++j) {
                    const float weight = overlap(x, picture.width, j, width);
                    for (std::uint32_t c = 0; c < channels; ++c) colour[c] += weight * sums[j * channels + c];
                }
                for (std::uint32_t c = 0; c < channels; ++c)
                    target[x * channels + c] = sixteenths(colour[c] / static_cast<float>(lab_scale));
            }
        }
    });
    return result;
}

} // namespace weft
