/// The impacts that reach a window, band by band, for splat_bands.
#pragma once
#include "opencl/layout.h"
#include <memory_resource>
#include <vector>
#include <weft/backend.h>

namespace weft::opencl {

class Impacts {
public:
    explicit Impacts(std::pmr::memory_resource* memory)
        : reaching_(memory), places_(memory), weights_(memory), bands_(memory)
    {
    }

    /// `counts` are the layer's thresholds, `level` is that of the window.
    void collect(const LayerLayout& layer, const LevelLayout& level, const weft_u32* counts, const weft_window& window);

    const std::pmr::vector<ImpactLayout>& places() const noexcept { return places_; }
    const std::pmr::vector<float>& weights() const noexcept { return weights_; }
    const std::pmr::vector<weft_u32>& bands() const noexcept
    {
        return bands_;
    } ///< where each begins; one more: the end

private:
    static constexpr weft_u32 most_weights = WEFT_BLOCK_WEIGHTS(6);
    struct Reaching {
        weft_i32 column, row; ///< texels under the window's first pixel
        float weights[most_weights];
    };
    struct Cells;

    void draw(const Cells& cells);
    void deal(const LayerLayout& layer, const LevelLayout& level, std::uint32_t height);

    std::pmr::vector<Reaching> reaching_;
    std::pmr::vector<ImpactLayout> places_;
    std::pmr::vector<float> weights_;
    std::pmr::vector<weft_u32> bands_;
};

} // namespace weft::opencl
