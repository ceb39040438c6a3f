/// TILE with WEFT_ADDRESS_CELLS: a picture that repeats.
#pragma once
#include "../common/field.h"
#include "memory.h"
#include "rows.h"

namespace weft {

/// A TILE layer, ready to be evaluated.
struct Tile {
    const weft_tile* tile;
    uint32_t planes;
    uint32_t period[2];
    Composed composed; ///< filled if is_composed

    weft_between level(float wanted) const { return weft_tile_level(wanted, tile->level, tile->source->levels); }
    weft_place place(uint32_t axis, int64_t pixel, uint32_t fraction) const;
    weft_pair pair(uint32_t axis, const weft_place& place, int32_t level) const;
};

/// f of planes first..first + count - 1 at a position, of a TILE that is not composed.
void tile_point(const Tile& tile, const int64_t* pixel, const uint32_t* fraction, float level, uint32_t first,
                uint32_t count, float* f);

/// Renders strips of one block of a TILE layer.
class Tile_block {
public:
    explicit Tile_block(const weft_host* host) : chain_{Level(host), Level(host)}, blend_(host) {}

    bool begin(const Rows& rows, const Tile& tile, const Block& block);
    void strip(const Strip& strip);

private:
    /// One level: where its columns read, and its two rows that were expanded last.
    struct Level {
        explicit Level(const weft_host* host) : indices(host), t(host), runs(host), expanded(host) {}
        bool begin(const Tile& tile, const Block& block, int32_t which);
        void find_runs(uint32_t width);
        const float* row(const Rows& rows, const float* plane, int32_t y, int32_t other);

        int32_t whole = 0;
        Columns columns{};
        Buffer<int32_t> indices;
        Buffer<float> t;
        Buffer<Run> runs;
        Buffer<float> expanded; ///< two rows
        uint32_t stride = 0, size = 0;
        int32_t held[2] = {-1, -1};
    };

    void plane(Level& level, uint32_t plane, uint32_t y, float* out);

    const Rows* rows_ = nullptr;
    const Tile* tile_ = nullptr;
    Block block_{};
    float between_ = 0;
    Level chain_[2];
    Buffer<float> blend_;
};

} // namespace weft
