/// What the layers of a bi-layer model point to.
#pragma once
#include "synthesis/band_lattices.h"
#include "synthesis/noise_tables.h"
#include "synthesis/structure_tables.h"
#include <optional>

namespace weft {

struct Bilayer_tables {
    Structure_tables structure;
    std::optional<Band_lattices> distortion; ///< of the position in the structure: two planes
    Noise_tables noises[most_noises];
};

} // namespace weft
