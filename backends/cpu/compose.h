/// TILE that is more than a picture that repeats: Wang tiles, content exchange, displacement.
#pragma once
#include "memory.h"
#include "rows.h"
#include "tile.h"

namespace weft {

/// Whether a layer asks for one of them.
bool is_composed(const weft_tile& tile);

/// What a composed TILE owns.
struct Composed_data {
    void use(const weft_host* host)
    {
        texels.use(host);
        ranges.use(host);
    }
    Buffer<float> texels;
    Buffer<Contour_range> ranges;
};

/// Fills `composed`. With `copied`, the source's levels are laid out in `data` as the kernels want them, and `texels`,
/// of as many as there are, say where; false: no memory.
bool open_composed(const weft_layer& layer, const weft_program& program, bool copied, Composed_data& data,
                   Texels* texels, Composed& composed);

/// f of planes first..first + count - 1 at a position; `displacement` is null or two planes' values.
void compose_point(const Rows& rows, const Tile& tile, const weft_spot& spot, const float* displacement, uint32_t first,
                   uint32_t count, float* f);

/// Renders strips of one block of such a layer.
class Composed_block {
public:
    explicit Composed_block(const weft_host* host) : axes_{Axis(host), Axis(host)} {}

    bool begin(const Rows& rows, const Tile& tile, const Block& block);
    /// `displacement`: null, or two planes of an earlier layer's strip of the same shape.
    void strip(const Strip& strip, const float* displacement);

private:
    /// Axis_places along one axis.
    struct Axis {
        explicit Axis(const weft_host* host) : cells(host), texels(host), fractions(host) {}
        bool reserve(size_t count) { return cells.reserve(count) && texels.reserve(count) && fractions.reserve(count); }
        void set(uint32_t i, const weft_place& place)
        {
            cells.data()[i] = place.cell;
            texels.data()[i] = place.texel;
            fractions.data()[i] = place.fraction;
        }
        Axis_places from(uint32_t i, uint32_t step, const float* moved) const
        {
            return {cells.data() + i, texels.data() + i, fractions.data() + i, step, moved};
        }

        Buffer<int64_t> cells;
        Buffer<int32_t> texels;
        Buffer<float> fractions;
    };

    const Rows* rows_ = nullptr;
    const Tile* tile_ = nullptr;
    Block block_{};
    Axis axes_[2]; ///< columns and rows of the block
};

} // namespace weft
