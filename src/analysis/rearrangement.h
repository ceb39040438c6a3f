/// How a structure layer is put together anew: Wang tiles, exchanged contents, and the deformations that it bears.
#pragma once
#include "base/core.h"
#include "base/progress.h"
#include "model/bilayer.h"
#include <weft/weft.h>

namespace weft {

/// Fills `wang`, `exchange` and the deformations of `bilayer` after its structure, whose first `channels` planes are P;
/// the structure itself may be cut to a torus with a better period.
void arrange_structure(Core& core, std::uint32_t channels, const weft_bilayer_options& options, Bilayer& bilayer,
                       const Progress& progress);

} // namespace weft
