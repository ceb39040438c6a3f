/// Windows of BANDS. A row of pixels asks for three rows of its band's coefficients, each of which asks for two rows of
/// the next coarser band, and so on: every row is made once per block, and all that are in use stay in the cache.
#include "bands.h"
#include "../common/field.h"

namespace weft {

namespace {

constexpr int64_t none = INT64_MIN;
constexpr uint32_t pixel_rows = 3; ///< of a plane: those that the spline joins

uint32_t rounded(uint32_t floats) { return (floats + 15) & ~uint32_t(15); }

/// Sizes are often powers of two, and divisions slow.
uint32_t lattice_index(const Lattice& lattice, uint32_t axis, int64_t cell)
{
    if (lattice.powers) return (uint32_t(cell) + lattice.shift[axis]) & (lattice.size[axis] - 1);
    return weft_band_index(cell, lattice.shift[axis], lattice.size[axis]);
}

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
        span.first_pair = first >> 1;
        span.odd = uint32_t(first & 1);
        span.pairs = (count + span.odd + 1) / 2;
        span.stride = rounded(2 * span.pairs) + overrun;
        span.offset = size;
        size += 2 * size_t(span.stride);
        first = span.first_pair;
        count = span.pairs + 1;
    }
    const size_t total = bands.planes * size + spans_[block.level].stride;
    if (!memory_.reserve(total) || !states_.reserve(size_t(bands.count) * bands.planes) ||
        !pixels_.reserve(size_t(pixel_rows) * bands.planes))
        return false;
    plane_size_ = size;
    made_ = memory_.data() + bands.planes * size;
    for (size_t i = 0; i < total; ++i) memory_.data()[i] = 0.0f; // what overruns read
    for (size_t i = 0; i < size_t(pixel_rows) * bands.planes; ++i) pixels_.data()[i] = none;
    for (uint32_t b = block.level; b < bands.count; ++b)
        for (uint32_t p = 0; p < bands.planes; ++p) {
            const Lattice& lattice = bands.lattices[index(p, b)];
            states_.data()[index(p, b)] = {{none, none},
                                           lattice.data ? lattice_index(lattice, 0, 2 * spans_[b].first_pair) : 0};
        }
    return true;
}

/// Row y of a band's coefficients, from the first one that is needed.
const float* Bands_block::row(uint32_t plane, uint32_t band, int64_t y)
{
    const Span& span = spans_[band];
    const uint32_t slot = uint32_t(y & 1);
    float* to = memory(plane) + span.offset + slot * span.stride;
    int64_t& held = states_.data()[index(plane, band)].held[slot];
    if (held != y) make(plane, band, y, to);
    held = y;
    return to + span.odd;
}

void Bands_block::make(uint32_t plane, uint32_t band, int64_t y, float* to)
{
    const Lattice& lattice = bands_->lattices[index(plane, band)];
    const bool coarsest = band + 1 == bands_->count;
    const float* above = coarsest ? nullptr : row(plane, band + 1, y >> 1);
    const float* below = coarsest ? nullptr : row(plane, band + 1, (y >> 1) + 1);
    Refine refine = {above, below, uint32_t(y & 1), spans_[band].pairs, nullptr, 0, 0, 0.0f};
    if (lattice.data) {
        refine.lattice = lattice.data + lattice.row * lattice_index(lattice, 1, y);
        refine.first = states_.data()[index(plane, band)].column;
        refine.size = lattice.size[0];
        refine.weight = lattice.weight;
    }
    rows_->refine(refine, to);
}

/// Row y of the block's coefficients, splined along the row.
const float* Bands_block::pixels(uint32_t plane, uint32_t y)
{
    const uint32_t slot = y % pixel_rows;
    float* to = memory(plane) + slot * size_t(rounded(block_.width));
    int64_t& held = pixels_.data()[size_t(plane) * pixel_rows + slot];
    if (held == int64_t(y)) return to;
    held = int64_t(y);
    make(plane, block_.level, block_.y + y, made_);
    rows_->spline_row(made_ + spans_[block_.level].odd, block_.width, to);
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
