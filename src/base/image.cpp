/// Checks of the caller's views, and reading them.
#include "base/image.h"
#include "base/error.h"
#include "base/finite.h"
#include <algorithm>
#include <atomic>
#include <functional>

namespace weft {

namespace {

constexpr std::uint32_t most_pixels = 65536; ///< a side
constexpr std::uint32_t most_image_channels = 16;

void check_stride(const weft_image& image, const char* function, const char* argument)
{
    const auto size = static_cast<std::int64_t>(bytes_per_value(image.format));
    const std::int64_t row = static_cast<std::int64_t>(image.width) * image.channels * size;
    if (image.stride != 0) {
        require(image.stride >= row || image.stride <= -row, function, ": ", argument, "->stride is ", image.stride,
                ", a row has ", row, " bytes");
        constexpr std::int64_t most = std::int64_t{1} << 46;
        require(image.stride <= most && image.stride >= -most, function, ": ", argument, "->stride is ", image.stride,
                ", beyond 2^46");
    }
    require(image.stride % size == 0 &&
                reinterpret_cast<std::uintptr_t>(image.data) % static_cast<std::uintptr_t>(size) == 0,
            function, ": ", argument, "->data and ->stride must be multiples of ", size, ", the size of a value");
}

/// One row of interleaved values into one row of each plane; false if a float is not finite, or beyond 2^64.
template <class Value>
bool read_row(const void* from, std::uint32_t width, std::uint32_t channels, float* to, std::size_t area, float most)
{
    const auto* values = static_cast<const Value*>(from);
    bool finite = true;
    for (std::uint32_t c = 0; c < channels; ++c) {
        float* row = to + c * area;
        if constexpr (std::is_same_v<Value, float>) {
            for (std::uint32_t x = 0; x < width; ++x) row[x] = values[std::size_t{x} * channels + c];
            finite = finite && all_below(row, width, two_to_64_bits);
        } else {
            for (std::uint32_t x = 0; x < width; ++x)
                row[x] = static_cast<float>(values[std::size_t{x} * channels + c]) / most;
        }
    }
    return finite;
}

bool read_row_of(const weft_image& image, std::uint32_t y, float* to, std::size_t area)
{
    const void* row = static_cast<const char*>(image.data) + static_cast<std::int64_t>(y) * stride_of(image);
    if (image.format == WEFT_FORMAT_U8)
        return read_row<std::uint8_t>(row, image.width, image.channels, to, area, 255.0F);
    if (image.format == WEFT_FORMAT_U16)
        return read_row<std::uint16_t>(row, image.width, image.channels, to, area, 65535.0F);
    return read_row<float>(row, image.width, image.channels, to, area, 1.0F);
}

} // namespace

std::size_t bytes_per_value(weft_format format) noexcept
{
    return format == WEFT_FORMAT_U8 ? 1 : format == WEFT_FORMAT_U16 ? 2 : 4;
}

std::int64_t stride_of(const weft_image& image) noexcept
{
    if (image.stride != 0) return image.stride;
    return static_cast<std::int64_t>(image.width) * image.channels *
           static_cast<std::int64_t>(bytes_per_value(image.format));
}

void check_image(const weft_image* image, const char* function, const char* argument)
{
    require(image, function, ": ", argument, " is NULL");
    require(image->data, function, ": ", argument, "->data is NULL");
    require(image->format >= WEFT_FORMAT_U8 && image->format <= WEFT_FORMAT_F32, function, ": ", argument,
            "->format is ", image->format, ", which is no weft_format");
    require(image->width >= 1 && image->width <= most_pixels, function, ": ", argument, "->width is ", image->width,
            ", not 1..65536");
    require(image->height >= 1 && image->height <= most_pixels, function, ": ", argument, "->height is ", image->height,
            ", not 1..65536");
    require(image->channels >= 1 && image->channels <= most_image_channels, function, ": ", argument, "->channels is ",
            image->channels, ", not 1..16");
    check_stride(*image, function, argument);
}

Planes read_image(const weft_image& image, std::pmr::memory_resource* memory, Parallel& parallel, const char* function,
                  const char* argument, const Progress& progress)
{
    Planes planes(memory, image.width, image.height, image.channels, Array<float>::unset);
    constexpr std::uint32_t rows_a_task = 64;
    std::atomic<std::uint32_t> spoiled{image.height}; // the first row with a value that is not finite
    const auto read = [&](std::uint32_t task) {
        const std::uint32_t end = std::min(image.height, (task + 1) * rows_a_task);
        for (std::uint32_t y = task * rows_a_task; y < end; ++y) {
            if (read_row_of(image, y, planes.row(0, y), planes.area())) continue;
            std::uint32_t least = spoiled.load();
            while (y < least && !spoiled.compare_exchange_weak(least, y)) {
            }
        }
    };
    const std::uint32_t tasks = (image.height + rows_a_task - 1) / rows_a_task;
    const std::uint64_t values_a_task = std::uint64_t{rows_a_task} * image.width * image.channels;
    const std::uint32_t batch = std::max(parallel.width(), static_cast<std::uint32_t>((1u << 23) / values_a_task));
    for (std::uint32_t first = 0; first < tasks; first += batch) {
        const std::uint32_t count = std::min(batch, tasks - first);
        const auto read_from = [&](std::uint32_t task) { read(first + task); };
        parallel.for_each_index(count, std::ref(read_from));
        progress.at(static_cast<double>(first + count) / tasks);
    }
    require(spoiled == image.height, function, ": ", argument, " has a value in row ", spoiled.load(),
            " that is not finite, or beyond 2^64");
    return planes;
}

} // namespace weft
