/// Where the patches of a tile come from, and how maps are put together by it.
#pragma once
#include "base/array.h"
#include "base/parallel.h"

namespace weft {

constexpr std::uint32_t most_patch = 31;

/// For each pixel of a tile, row by row, the pixel of the photo that is the middle of its patch. Patches lie within the
/// photo; those of the tile go around it.
struct Correspondence {
    std::uint32_t photo_width = 0, photo_height = 0;
    std::uint32_t patch = 0; ///< their side: odd, 1..31
    Array<std::uint16_t> x, y;

    std::uint32_t reach() const noexcept { return patch / 2; }
};

/// Each pixel becomes the mean of what all patches that cover it say. `map` has the photo's size and any number of
/// planes. The same on every machine, in sums of double, for any number of threads.
Planes assemble(const Planes& map, const Correspondence& correspondence, std::uint32_t width, std::uint32_t height,
                std::pmr::memory_resource* memory, Parallel& parallel);

} // namespace weft
