/// BANDS: octaves of noise, refined from band to band.
#pragma once
#include "memory.h"
#include "rows.h"

namespace weft {

/// The lattices of a layer, ready to be evaluated; with `padded`, points want copies in `data` that do not wrap around.
bool open_bands(const weft_layer& layer, weft_use use, bool padded, Buffer<Lattice>& lattices, Buffer<float>& data,
                Bands& bands);

/// Renders strips of one block of a BANDS layer. Each band keeps the two rows of coefficients that were made last, from
/// which its finer neighbour makes four; so nothing but rows is ever stored.
class Bands_block {
public:
    explicit Bands_block(const weft_host* host) : memory_(host), held_(host) {}

    bool begin(const Rows& rows, const Bands& bands, const Block& block);
    void strip(const Strip& strip);

private:
    /// Coefficients begin .. begin + count - 1 of a band's rows. They are made in pairs, the first of which may be one
    /// column further to the left: `odd` is 1 then.
    struct Span {
        int64_t begin;
        uint32_t odd, count, pairs;
        uint32_t stride;
        size_t offset; ///< of its two rows in a plane's memory
    };

    float* memory(uint32_t plane) const { return memory_.data() + plane * plane_size_; }
    const float* row(uint32_t plane, uint32_t band, int64_t y);
    void make(uint32_t plane, uint32_t band, int64_t y, float* to);
    const float* pixels(uint32_t plane, uint32_t y);

    const Rows* rows_ = nullptr;
    const Bands* bands_ = nullptr;
    Block block_{};
    Span spans_[most_bands];
    Buffer<float> memory_; ///< a row being refined; then plane by plane, three rows of pixels and two of each band
    Buffer<int64_t> held_; ///< which rows those are
    size_t plane_size_ = 0;
    float* refined_ = nullptr;
};

} // namespace weft
