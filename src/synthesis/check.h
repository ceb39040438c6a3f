/// What backend.h promises of every program.
#pragma once
#include <weft/backend.h>

namespace weft {

/// Throws Error(WEFT_ERROR_INTERNAL) unless the program keeps the bounds of backend.h and every float is finite. Knows
/// SPLAT, BANDS, and TILE with the address CELLS, without masks and displacement: what this libweft makes.
void check_program(const weft_program& program);

} // namespace weft
