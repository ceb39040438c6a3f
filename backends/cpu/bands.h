/// BANDS: octaves of noise, refined from band to band.
#pragma once
#include "memory.h"
#include "rows.h"

namespace weft {

/// The lattices of a layer, ready to be evaluated; with `padded`, as copies in `data` that do not wrap around at once.
bool open_bands(const weft_layer& layer, weft_use use, bool padded, Buffer<Lattice>& lattices, Buffer<float>& data,
                Bands& bands);

/// Renders strips of one block of a BANDS layer. Each band keeps the two rows of coefficients that were made last, from
/// which its finer neighbour makes four; so nothing but rows is ever stored.
class Bands_block {
public:
    explicit Bands_block(const weft_host* host) : memory_(host), states_(host), pixels_(host) {}

    bool begin(const Rows& rows, const Bands& bands, const Block& block);
    void strip(const Strip& strip);

private:
    /// The columns of a band's rows, which are made in pairs: if `odd` is 1, the first one that is needed is the second
    /// of a pair.
    struct Span {
        int64_t first_pair;
        uint32_t odd, pairs, stride;
        size_t offset; ///< of its two rows in a plane's memory
    };

    /// What a plane has of a band: which rows there are, and where the lattice is read.
    struct State {
        int64_t held[2];
        uint32_t column;
    };

    float* memory(uint32_t plane) const { return memory_.data() + plane * plane_size_; }
    size_t index(uint32_t plane, uint32_t band) const { return size_t(band) * bands_->planes + plane; }
    const float* row(uint32_t plane, uint32_t band, int64_t y);
    void make(uint32_t plane, uint32_t band, int64_t y, float* to);
    const float* pixels(uint32_t plane, uint32_t y);

    const Rows* rows_ = nullptr;
    const Bands* bands_ = nullptr;
    Block block_{};
    Span spans_[most_bands];
    Buffer<float> memory_; ///< plane by plane, three rows of pixels and two of each band; then a row being made
    Buffer<State> states_;
    Buffer<int64_t> pixels_; ///< which rows of pixels there are, three for each plane
    size_t plane_size_ = 0;
    float* made_ = nullptr;
};

} // namespace weft
