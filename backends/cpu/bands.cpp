/// Windows of BANDS. A row of pixels asks for three rows of its band's coefficients, each of which asks for two rows of
/// the next coarser band, and so on: every row is made once per block, and all that are in use stay in the cache.
#include "bands.h"
#include "../common/field.h"

namespace weft {

namespace {

constexpr int64_t none = INT64_MIN;
constexpr uint32_t pixel_rows = 3; ///< of a plane: those that the spline joins

uint32_t rounded(uint32_t floats) { return (floats + 15) & ~uint32_t(15); }

} // namespace

bool Bands_block::begin(const Rows& rows, const Bands& bands, const Block& block)
{
    rows_ = &rows;
    bands_ = &bands;
    block_ = block;
    if (block.level >= bands.count) return true;
    int64_t first = block.x;
    uint32_t count = block.width + 2;
    size_t size = pixel_rows * size_t(rounded(block.width));
    for (uint32_t b = block.level; b < bands.count; ++b) {
        Span& span = spans_[b];
        span.begin = first;
        span.odd = uint32_t(first & 1);
        span.count = count;
        span.pairs = (count + span.odd + 1) / 2;
        span.stride = rounded(2 * span.pairs);
        span.offset = size;
        size += 2 * size_t(span.stride);
        first >>= 1;
        count = span.pairs + 1;
    }
    const size_t widest = 2 * size_t(spans_[block.level].stride);
    const size_t slots = size_t(bands.planes) * (bands.count * 2 + pixel_rows);
    if (!memory_.reserve(widest + bands.planes * size) || !held_.reserve(slots)) return false;
    plane_size_ = size;
    refined_ = memory_.data() + bands.planes * size;
    for (size_t i = 0; i < slots; ++i) held_.data()[i] = none;
    return true;
}

/// Row y of a band's coefficients, from its first column on.
const float* Bands_block::row(uint32_t plane, uint32_t band, int64_t y)
{
    const Span& span = spans_[band];
    const uint32_t slot = uint32_t(y & 1);
    float* to = memory(plane) + span.offset + slot * span.stride;
    int64_t& held = held_.data()[size_t(plane) * (bands_->count * 2 + pixel_rows) + pixel_rows + band * 2 + slot];
    if (held != y) make(plane, band, y, to);
    held = y;
    return to + span.odd;
}

void Bands_block::make(uint32_t plane, uint32_t band, int64_t y, float* to)
{
    const Span& span = spans_[band];
    const Lattice& lattice = bands_->lattices[size_t(band) * bands_->planes + plane];
    float* refined = lattice.data ? refined_ : to;
    if (band + 1 < bands_->count) {
        const float* above = row(plane, band + 1, y >> 1);
        const float* below = row(plane, band + 1, (y >> 1) + 1);
        rows_->refine(above, below, uint32_t(y & 1), span.pairs, refined);
    } else {
        for (uint32_t x = 0; x < 2 * span.pairs; ++x) refined[x] = 0.0f;
    }
    if (!lattice.data) return;
    const float* from = lattice.data + lattice.row * weft_band_index(y, lattice.shift[1], lattice.size[1]);
    const uint32_t first = weft_band_index(span.begin, lattice.shift[0], lattice.size[0]);
    rows_->add_lattice(refined + span.odd, from, first, lattice.size[0], lattice.weight, span.count, to + span.odd);
}

/// Row y of the block's coefficients, splined along the row.
const float* Bands_block::pixels(uint32_t plane, uint32_t y)
{
    const uint32_t slot = y % pixel_rows;
    float* to = memory(plane) + slot * size_t(rounded(block_.width));
    int64_t& held = held_.data()[size_t(plane) * (bands_->count * 2 + pixel_rows) + slot];
    if (held == int64_t(y)) return to;
    held = int64_t(y);
    const Span& span = spans_[block_.level];
    float* made = refined_ + span.stride;
    make(plane, block_.level, block_.y + y, made);
    rows_->spline_row(made + span.odd, block_.width, to);
    return to;
}

void Bands_block::strip(const Strip& strip)
{
    const bool present = block_.level < bands_->count;
    for (uint32_t p = 0; p < bands_->planes; ++p)
        for (uint32_t y = 0; y < strip.count; ++y) {
            float* out = strip.data + (size_t(p) * strip.count + y) * strip.stride;
            if (!present) {
                for (uint32_t x = 0; x < strip.width; ++x) out[x] = 0.0f;
                continue;
            }
            const float* upper = pixels(p, strip.first + y);
            const float* middle = pixels(p, strip.first + y + 1);
            rows_->spline_rows(upper, middle, pixels(p, strip.first + y + 2), strip.width, out);
        }
}

} // namespace weft
