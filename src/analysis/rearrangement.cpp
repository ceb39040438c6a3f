/// Measures what the structure bears, then makes its Wang tiles and contents.
#include "analysis/rearrangement.h"
#include "analysis/exchange_contents.h"
#include "analysis/structure_torus.h"
#include "analysis/wang_tiles.h"

namespace weft {

void arrange_structure(Core& core, std::uint32_t channels, const weft_bilayer_options& options, Bilayer& bilayer,
                       const Progress& progress)
{
    Features features = features_of(core, channels, bilayer.structure);
    if (features.empty()) return; // all pixels are alike: there is nothing to rearrange
    progress.at(0.02);
    const Correlation correlation(core, features, progress.part(0.02, 0.04));
    const Bearing bearing = bearing_of(core, features, correlation, progress.part(0.04, 0.05));
    bilayer.turns = bearing.turns;
    bilayer.least_scale = offered_scale[bearing.scales - 1];
    bilayer.turbulence = bearing.turbulence;
    const bool decide = options.structure != WEFT_STRUCTURE_WANG && options.structure != WEFT_STRUCTURE_EXCHANGE &&
                        options.structure != WEFT_STRUCTURE_BOTH;
    const bool wang = decide ? !bearing.lattice : options.structure != WEFT_STRUCTURE_EXCHANGE;
    Bounds bounds{0, 0, 0, 0};
    if (wang) {
        const std::uint32_t colours = options.colours ? options.colours : 4;
        bilayer.wang = wang_tiles_of(core, features, correlation, colours, options.seed, progress.part(0.05, 0.3));
    } else {
        Torus torus = torus_of(core, features, bilayer.structure, progress.part(0.05, 0.3));
        bilayer.structure = std::move(torus.planes);
        features = features_of(core, channels, bilayer.structure);
        bounds.left = static_cast<std::int32_t>(torus.left);
        bounds.top = static_cast<std::int32_t>(torus.top);
    }
    bounds.right = static_cast<std::int32_t>(features.width);
    bounds.bottom = static_cast<std::int32_t>(features.height);
    if (options.structure != WEFT_STRUCTURE_WANG)
        bilayer.exchange = exchange_of(core, features, bilayer.wang, bounds, bearing, progress.part(0.3, 1));
}

} // namespace weft
