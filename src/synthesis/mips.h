/// Mip chains: the same picture for larger and larger pixels.
#pragma once
#include "base/parallel.h"
#include "model/model.h"
#include <weft/backend.h>

namespace weft {

constexpr std::uint32_t most_levels = 15;

/// Coefficients of textons, `stored` images of them, of which the first `images` are used.
struct Splat_source {
    const Planes& coefficients;
    std::uint32_t stored, images, taps;
};

/// A chain with its memory. `mips.level` points into the object: it stays where it was made.
struct Mip_chain {
    Mip_chain() = default;
    Mip_chain(const Mip_chain&) = delete;
    Mip_chain& operator=(const Mip_chain&) = delete;

    weft_mips mips{};
    weft_mip level[most_levels]{};
    Planes own[most_levels]; ///< level 0 of a picture is the model's
};

/// Of a picture, which is a torus: areas of about 2^l texels a side averaged, down to 1 x 1. Level 0 is borrowed.
void make_picture_mips(Mip_chain& chain, const Planes& picture, std::pmr::memory_resource* memory, Parallel& parallel);

/// Of the textons that a SPLAT uses, which are 0 outside, times `scale`; `rate` is that of their impacts. Ends where
/// the noise is no longer seen, or after `most` levels.
void make_texton_mips(Mip_chain& chain, const Splat_source& source, double scale, double rate, std::uint32_t most,
                      std::pmr::memory_resource* memory, Parallel& parallel);

} // namespace weft
