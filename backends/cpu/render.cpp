/// Windows: cut into blocks, for each of which the impacts of every layer are found once; a block is evaluated in
/// strips of rows that stay in the cache, layer by layer.
#include "texture.h"
#include <new>

namespace weft {

namespace {

constexpr uint32_t block_width = 512, block_height = 120; ///< a multiple of the height of any strip
constexpr float most_impacts = 65536;                     ///< expected in a block, unless it cannot be made smaller

uint32_t minimum(uint32_t a, uint32_t b) { return a < b ? a : b; }

/// A block's list of impacts, in the host's memory.
struct Impact_list : Impacts {
    explicit Impact_list(const weft_host* host, uint32_t taps)
        : Impacts{nullptr, nullptr, 0, 0, &Impact_list::enlarge}, impact_buffer(host), spline_buffer(host), taps_(taps)
    {
    }

    static bool enlarge(Impacts& impacts)
    {
        Impact_list& list = static_cast<Impact_list&>(impacts);
        const uint32_t capacity = list.capacity < 1024 ? 1024 : 2 * list.capacity;
        if (capacity > UINT32_MAX / 4) return false;
        if (!list.impact_buffer.grow(capacity, list.count)) return false;
        if (list.taps_ != 2 && !list.spline_buffer.grow(capacity, list.count)) return false;
        list.impacts = list.impact_buffer.data();
        list.splines = list.spline_buffer.data();
        list.capacity = capacity;
        return true;
    }

    Buffer<Impact> impact_buffer;
    Buffer<Spline> spline_buffer;

private:
    uint32_t taps_;
};

/// What a layer needs while a window is rendered.
struct Work {
    explicit Work(const weft_host* host, const Layer& layer)
        : found(host, layer.splat.taps), tile(host), composed(host), bands(host), f(host), mask(host)
    {
    }

    Impact_list found;
    Tile_block tile;
    Composed_block composed;
    Bands_block bands;
    Buffer<float> f;          ///< of a strip
    Buffer<float> mask;       ///< product of masks of a strip
    const float* m = nullptr; ///< M of the strip; null: 1
};

/// The largest block, halved until no layer is expected to have too many impacts in it.
Block largest_block(const weft_backend_texture& texture, const weft_window& window)
{
    Block block = {window.x, window.y, minimum(window.width, block_width), minimum(window.height, block_height),
                   window.level};
    const float side = float(uint32_t(1) << minimum(window.level, 24));
    for (uint32_t i = 0; i < texture.program->layer_count; ++i) {
        const Layer& layer = texture.layers[i];
        if (layer.source->kind != WEFT_LAYER_SPLAT || !splat_has(layer, window.level)) continue;
        const float density = layer.impacts_per_pixel * side * side;
        while (density * float(block.width) * float(block.height) > most_impacts && block.width > 32)
            if (block.height > 30)
                block.height = (block.height + 1) / 2;
            else
                block.width /= 2;
    }
    return block;
}

class Painter {
public:
    Painter(const weft_backend_texture& texture, const weft_window& window)
        : texture_(texture), window_(window), work_(texture.host), scratch_(texture.host),
          largest_(largest_block(texture, window))
    {
    }
    ~Painter()
    {
        for (uint32_t i = 0; i < made_; ++i) work_.data()[i].~Work();
    }
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    bool paint();

private:
    uint32_t layers() const { return texture_.program->layer_count; }
    bool begin();
    bool begin(const Block& block);
    void strip(uint32_t first, uint32_t count);
    float* row(uint32_t channel, uint32_t y);
    void clear(uint32_t first, uint32_t count);
    void evaluate(uint32_t index, uint32_t first, uint32_t count);
    const float* plane_of(const weft_ref& ref, uint32_t count) const;
    const float* mask(uint32_t index, uint32_t count);
    bool shows(const float* mask, uint32_t count) const;
    void mix(const Layer& layer, const float* f, const float* mask, uint32_t first, uint32_t count);

    const weft_backend_texture& texture_;
    const weft_window& window_;
    Buffer<Work> work_;
    Buffer<unsigned char> scratch_;
    Block largest_, block_{};
    uint32_t made_ = 0, stride_ = 0, left_ = 0, top_ = 0;
    bool fresh_ = true; ///< nothing has been added to the strip yet
};

bool Painter::begin()
{
    const uint32_t rows = minimum(largest_.height, texture_.rows->strip_height);
    stride_ = (largest_.width + 15) & ~uint32_t(15);
    if (!work_.reserve(layers())) return false;
    for (; made_ < layers(); ++made_) {
        const Layer& layer = texture_.layers[made_];
        Work* work = new (work_.data() + made_) Work(texture_.host, layer);
        if (!work->f.reserve(size_t(stride_) * rows * layer.source->planes) ||
            (layer.masked && !work->mask.reserve(size_t(stride_) * rows))) {
            ++made_;
            return false;
        }
    }
    return true;
}

bool Painter::begin(const Block& block)
{
    block_ = block;
    for (uint32_t i = 0; i < layers(); ++i) {
        const Layer& layer = texture_.layers[i];
        Work& work = work_.data()[i];
        if (layer.composed) {
            if (!work.composed.begin(*texture_.rows, layer.tile, block)) return false;
        } else if (layer.source->kind == WEFT_LAYER_TILE) {
            if (!work.tile.begin(*texture_.rows, layer.tile, block)) return false;
        } else if (layer.source->kind == WEFT_LAYER_BANDS) {
            if (!work.bands.begin(*texture_.rows, layer.bands, block)) return false;
        } else if (splat_has(layer, block.level)) {
            work.found.count = 0;
            if (!texture_.rows->find_impacts(layer.splat, block, work.found)) return false;
            if (!scratch_.reserve(texture_.rows->scratch(work.found.count, block.width, layer.splat.taps)))
                return false;
        }
    }
    return true;
}

void Painter::evaluate(uint32_t index, uint32_t first, uint32_t count)
{
    const Layer& layer = texture_.layers[index];
    const weft_layer& source = *layer.source;
    Work& work = work_.data()[index];
    const float* mask = layer.referred ? nullptr : work.m;
    const Strip strip = {work.f.data(), block_.width, first, count, stride_, scratch_.data(), mask};
    if (layer.composed)
        work.composed.strip(strip, plane_of(source.tile->displacement, count));
    else if (source.kind == WEFT_LAYER_TILE)
        work.tile.strip(strip);
    else if (source.kind == WEFT_LAYER_BANDS)
        work.bands.strip(strip);
    else if (splat_has(layer, block_.level))
        texture_.rows->splat_strip(layer.splat, block_.level, work.found, strip);
    else
        for (size_t i = 0; i < size_t(stride_) * count * source.planes; ++i) strip.data[i] = 0.0f;
    if (!source.tones) return;
    for (uint32_t row = 0; row < source.channels * count; ++row)
        texture_.rows->tone(layer.tones.data()[row / count], block_.width, strip.data + size_t(row) * stride_);
}

/// The plane of a strip of `count` rows that a reference means; null: none.
const float* Painter::plane_of(const weft_ref& ref, uint32_t count) const
{
    return ref.layer < 0 ? nullptr : work_.data()[ref.layer].f.data() + size_t(ref.plane) * count * stride_;
}

/// M of a layer: the plane of its mask times the M of the layer that owns the plane.
const float* Painter::mask(uint32_t index, uint32_t count)
{
    const weft_ref ref = texture_.layers[index].source->mask;
    const Work& owner = work_.data()[ref.layer];
    const float* plane = plane_of(ref, count);
    work_.data()[index].m = plane;
    if (owner.m) {
        float* product = work_.data()[index].mask.data();
        texture_.rows->multiply(plane, owner.m, stride_ * count, product);
        work_.data()[index].m = product;
    }
    return work_.data()[index].m;
}

/// Is M anything but 0 in a strip of `count` rows?
bool Painter::shows(const float* mask, uint32_t count) const
{
    bool any = false;
    for (uint32_t y = 0; y < count && !any; ++y)
        for (uint32_t x = 0; x < block_.width; ++x) any |= mask[size_t(y) * stride_ + x] != 0;
    return any;
}

void Painter::mix(const Layer& layer, const float* f, const float* mask, uint32_t first, uint32_t count)
{
    const weft_layer& source = *layer.source;
    for (uint32_t y = 0; y < count; ++y) {
        const Mixture mixture = {fresh_,
                                 texture_.program->channels,
                                 source.channels,
                                 block_.width,
                                 f + size_t(y) * stride_,
                                 size_t(stride_) * count,
                                 size_t(window_.height) * window_.stride,
                                 source.colour,
                                 source.mean,
                                 mask ? mask + size_t(y) * stride_ : nullptr};
        texture_.rows->mix(mixture, row(0, first + y));
    }
}

void Painter::strip(uint32_t first, uint32_t count)
{
    fresh_ = true;
    for (uint32_t i = 0; i < layers(); ++i) {
        const Layer& layer = texture_.layers[i];
        const float* m = layer.masked ? mask(i, count) : nullptr;
        if (m && !layer.referred && !shows(m, count)) continue; // it would add zeros
        evaluate(i, first, count);
        if (layer.source->channels == 0) continue; // only referred to
        mix(layer, work_.data()[i].f.data(), m, first, count);
        fresh_ = false;
    }
    if (fresh_) clear(first, count);
}

float* Painter::row(uint32_t channel, uint32_t y)
{
    return window_.data + (size_t(channel) * window_.height + top_ + y) * window_.stride + left_;
}

void Painter::clear(uint32_t first, uint32_t count)
{
    for (uint32_t o = 0; o < texture_.program->channels; ++o)
        for (uint32_t y = 0; y < count; ++y)
            for (uint32_t x = 0; x < block_.width; ++x) row(o, first + y)[x] = 0.0f;
}

bool Painter::paint()
{
    if (!begin()) return false;
    for (top_ = 0; top_ < window_.height; top_ += largest_.height)
        for (left_ = 0; left_ < window_.width; left_ += largest_.width) {
            const uint32_t width = minimum(largest_.width, window_.width - left_);
            const uint32_t height = minimum(largest_.height, window_.height - top_);
            if (!begin({window_.x + left_, window_.y + top_, width, height, window_.level})) return false;
            const uint32_t rows = texture_.rows->strip_height;
            for (uint32_t y = 0; y < height; y += rows) strip(y, minimum(rows, height - y));
        }
    return true;
}

} // namespace

weft_status texture_render(weft_backend_texture* texture, const weft_window* window) noexcept
{
    Painter painter(*texture, *window);
    return painter.paint() ? WEFT_OK : WEFT_ERROR_MEMORY;
}

} // namespace weft
