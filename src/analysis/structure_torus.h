/// A structure cut to a torus: the period at which its borders fit best, and minimal cuts where they meet.
#pragma once
#include "analysis/structure_features.h"
#include "base/progress.h"

namespace weft {

struct Torus {
    Planes planes;
    std::uint32_t left = 0, top = 0; ///< contents from there on do not show the cuts
};

Torus torus_of(Core& core, const Features& features, const Planes& structure, const Progress& progress);

} // namespace weft
