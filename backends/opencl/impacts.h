/// The impacts that reach a window, band by band, for splat_bands.
#pragma once
#include "opencl/choice.h"
#include "opencl/layout.h"
#include <memory_resource>
#include <vector>
#include <weft/backend.h>

namespace weft::opencl {

class Impacts {
public:
    explicit Impacts(std::pmr::memory_resource* memory) : reaching_(memory), list_(memory), bands_(memory) {}

    /// `counts` are the layer's thresholds, `level` is that of the window.
    void collect(const LayerLayout& layer, const LevelLayout& level, const weft_u32* counts, const Choice& choice,
                 const weft_window& window);

    /// WEFT_IMPACT_WORDS for each impact of each band.
    const std::pmr::vector<weft_u32>& list() const noexcept { return list_; }
    const std::pmr::vector<weft_u32>& bands() const noexcept
    {
        return bands_;
    } ///< where each begins; one more: the end

private:
    static constexpr weft_u32 most_weights = WEFT_IMPACT_WORDS(6) - 2;
    struct Reaching {
        weft_i32 column, row; ///< texels under the window's first pixel
        weft_u32 image;
        float weights[most_weights];
    };
    struct Cells;

    void draw(const Cells& cells);
    void deal(const LayerLayout& layer, const LevelLayout& level, std::uint32_t height);

    std::pmr::vector<Reaching> reaching_;
    std::pmr::vector<weft_u32> list_;
    std::pmr::vector<weft_u32> bands_;
};

} // namespace weft::opencl
