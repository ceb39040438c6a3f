/// Pictures repeated on a grid of cells.
#pragma once
#include <cstdint>
#include <weft/backend.h>

namespace weft {

constexpr weft_ref nobody{-1, 0};

/// Cells of width x height texels of the picture, `scale` pixels of the texture per texel. If their size does not
/// divide a period it is stretched to the nearest one that does.
weft_tile repeated_tile(const weft_mips& picture, std::uint32_t width, std::uint32_t height, std::uint32_t scale,
                        std::uint32_t period_x, std::uint32_t period_y) noexcept;

} // namespace weft
