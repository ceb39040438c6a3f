/// The impacts that reach a window, band by band, for splat_bands.
#pragma once
#include "opencl/layout.h"
#include <weft/backend.h>
#include <memory_resource>
#include <vector>

namespace weft::opencl {

class Impacts {
public:
    explicit Impacts(std::pmr::memory_resource* memory) : reaching_(memory), list_(memory), bands_(memory) {}

    /// `counts` are the layer's thresholds, `level` is that of the window.
    void collect(const LayerLayout& layer, const LevelLayout& level, const weft_u32* counts, const weft_window& window);

    const std::pmr::vector<ImpactLayout>& list() const noexcept { return list_; }
    const std::pmr::vector<weft_u32>& bands() const noexcept { return bands_; } ///< where each begins; one more: the end

private:
    struct Cells;
    void draw(const Cells& cells);
    void deal(const LevelLayout& level, std::uint32_t height);

    std::pmr::vector<ImpactLayout> reaching_; // whose row is the texel row under the window's first row
    std::pmr::vector<ImpactLayout> list_;
    std::pmr::vector<weft_u32> bands_;
};

} // namespace weft::opencl
