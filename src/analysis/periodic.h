/// The periodic component of a picture (Moisan 2011): without the jumps between opposite borders.
#pragma once
#include "analysis/spectra.h"

namespace weft {

/// Turns `spectra`, the DFTs of `planes`, into the DFTs of their periodic components.
void keep_periodic_component(Core& core, const Planes& planes, Spectra& spectra);

} // namespace weft
