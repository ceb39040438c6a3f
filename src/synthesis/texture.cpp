/// Windows: cut into tiles, evaluated side by side, converted to the caller's pixels.
#include "synthesis/texture.h"
#include "base/error.h"
#include "base/image.h"
#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>

namespace weft {

namespace {

constexpr std::int64_t most_position = std::int64_t{1} << 60;

void check_window(std::int64_t x, std::int64_t y, std::uint32_t level, const weft_image& image)
{
    require(level <= 30, "weft_texture_render: level is ", level, ", not 0..30");
    const std::int64_t most = most_position >> level;
    require(x >= -most && x <= most - image.width, "weft_texture_render: x is ", x, ", beyond 2^60 pixels of level 0");
    require(y >= -most && y <= most - image.height, "weft_texture_render: y is ", y, ", beyond 2^60 pixels of level 0");
}

/// How a window is cut up. Any cut gives the same pixels.
struct Tiles {
    Tiles(const weft_image& image, const weft_device_limits& limits, std::uint32_t threads) noexcept
        : width(std::min(image.width, limits.window_width ? limits.window_width : 256)),
          height(std::min(image.height, limits.window_height ? limits.window_height : 64))
    {
        constexpr std::uint64_t most_floats = 1U << 24; // 64 MiB a tile
        while (height > 1 && std::uint64_t{width} * height * image.channels > most_floats) height = (height + 1) / 2;
        count(image);
        while (limits.concurrency != 1 && threads > 1 && total < 2 * std::uint64_t{threads} && height >= 32) {
            height = (height + 1) / 2;
            count(image);
        }
        stride = (width + 15) / 16 * 16;
        slots = static_cast<std::uint32_t>(
            std::min<std::uint64_t>({threads, limits.concurrency ? limits.concurrency : UINT32_MAX, total}));
    }
    void count(const weft_image& image) noexcept
    {
        columns = (image.width + width - 1) / width;
        total = std::uint64_t{columns} * ((image.height + height - 1) / height);
    }
    std::uint32_t width, height, columns = 0, stride = 0;
    std::uint32_t slots; ///< tiles under way at once, each with a buffer
    std::uint64_t total = 0;
};

/// How many tiles are drawn between two reports of progress: as many as take about 10 ms, so that a cancelled call ends
/// soon on a slow device and a fast one seldom waits for its slowest thread. No pixel depends on it.
class Batch {
public:
    Batch(std::uint64_t least, std::uint64_t size) noexcept : least_(least), size_(size) {}
    std::uint64_t size() const noexcept { return size_; }

    void done() noexcept
    {
        const Clock::time_point now = Clock::now();
        if (now - begin_ < std::chrono::milliseconds(5)) size_ *= 2;
        if (now - begin_ > std::chrono::milliseconds(15)) size_ = std::max(least_, size_ / 2);
        begin_ = now;
    }

private:
    using Clock = std::chrono::steady_clock;
    std::uint64_t least_, size_;
    Clock::time_point begin_ = Clock::now();
};

weft_texture_options without_map(weft_texture_options options) noexcept
{
    options.mix = nullptr;
    return options;
}

} // namespace

Texture::Texture(Core& core, Device& device, const Model& model, const weft_texture_options& options)
    : core_(core), device_(device), model_(model), options_(without_map(options)), mixed_(options.mix),
      program_(core, model, options, Program::in_plane)
{
    open(window_, program_.window(), "weft_texture_create");
    open(points_, program_.points(), "weft_texture_create");
    scratch_ = Scratch_pool(&core.memory, points_.device().limits().batch, channels());
}

void Texture::open(Opened& opened, const weft_program& program, const char* function) const
{
    if (opened.open(device_, program, function)) return;
    if (!scalar_) scalar_.emplace(core_.memory, Registry::instance().scalar(), function);
    if (!opened.open(*scalar_, program, function))
        throw Error(WEFT_ERROR_INTERNAL, function, ": scalar refused the program");
}

void Texture::render(std::int64_t x, std::int64_t y, std::uint32_t level, const Progress& progress,
                     const weft_image& image) const
{
    constexpr char function[] = "weft_texture_render";
    require(image.channels == channels(), function, ": image->channels is ", image.channels, ", the model has ",
            channels());
    check_window(x, y, level, image);
    const Tiles tiles(image, window_.device().limits(), core_.parallel.width());
    const std::size_t plane = std::size_t{tiles.height} * tiles.stride, buffer = plane * channels();
    Array<float> buffers(&core_.memory, buffer * tiles.slots, Array<float>::unset);

    const auto draw = [&](std::uint64_t tile, float* data) {
        const auto left = static_cast<std::uint32_t>(tile % tiles.columns) * tiles.width;
        const auto top = static_cast<std::uint32_t>(tile / tiles.columns) * tiles.height;
        const std::uint32_t width = std::min(tiles.width, image.width - left),
                            height = std::min(tiles.height, image.height - top);
        const weft_window window{sizeof(weft_window), width, height, tiles.stride, x + left, y + top, level, 0, data};
        window_.render(window, function);
        write_window(image, left, top, width, height, data, tiles.stride, height);
    };
    std::atomic<std::uint64_t> next{0};
    std::uint64_t end = 0;
    const auto work = [&](std::uint32_t slot) {
        try {
            for (std::uint64_t tile; (tile = next.fetch_add(1, std::memory_order_relaxed)) < end;)
                draw(tile, buffers.data() + slot * buffer);
        } catch (...) {
            next = tiles.total; // the others stop too
            throw;
        }
    };
    Batch batch(tiles.slots, progress.reports() ? tiles.slots : tiles.total);
    for (std::uint64_t first = 0; first < tiles.total; first = end) {
        progress.at(static_cast<double>(first) / static_cast<double>(tiles.total));
        end = std::min(tiles.total, first + batch.size());
        next = first;
        core_.parallel.for_each_index(tiles.slots, std::ref(work));
        batch.done();
    }
    progress.at(1);
}

} // namespace weft
