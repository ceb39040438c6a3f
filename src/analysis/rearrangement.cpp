/// Measures what the structure bears, then makes its Wang tiles and contents.
#include "analysis/rearrangement.h"
#include "analysis/structure_features.h"
#include "analysis/wang_tiles.h"

namespace weft {

void arrange_structure(Core& core, std::uint32_t channels, const weft_bilayer_options& options, Bilayer& bilayer,
                       const Progress& progress)
{
    const Features features = features_of(core, channels, bilayer.structure);
    if (features.empty()) return; // all pixels are alike: there is nothing to rearrange
    const std::uint32_t colours = options.colours ? options.colours : 4;
    bilayer.wang = wang_tiles_of(core, features, colours, options.seed, progress);
}

} // namespace weft
