/// What the checks of programs share.
#pragma once
#include "base/error.h"
#include "base/finite.h"
#include <weft/backend.h>

namespace weft {

template <class... Parts> void demand(bool good, const Parts&... parts)
{
    if (!good) throw Error(WEFT_ERROR_INTERNAL, "a program was made with ", parts...);
}

inline bool within(std::uint32_t value, std::uint32_t low, std::uint32_t high) noexcept
{
    return value >= low && value <= high;
}

inline bool all_finite(const float* values, std::size_t count) noexcept
{
    return all_below(values, count, infinity_bits);
}

/// A plane of a layer that comes before layer `index`, or of none.
void check_ref(const weft_ref& ref, const weft_program& program, std::uint32_t index, const char* what);

void check_mips(const weft_mips& mips, std::uint32_t planes, bool tile);
void check_tile(const weft_tile& tile, const weft_program& program, std::uint32_t index);

} // namespace weft
