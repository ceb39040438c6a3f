/// Which image an impact shows, on the host: a plane of a TILE at the middle of the impact's texton.
#pragma once
#include "common/field.h"
#include <cstddef>
#include <weft/backend.h>

namespace weft::opencl {

class Choice {
public:
    /// `splat` is of `program`, whose TILE with the choice's plane was checked.
    Choice(const weft_program& program, const weft_splat& splat) noexcept;

    /// Of an impact at that pixel; 0 without a choice.
    weft_u32 image(weft_i64 x, weft_i64 y) const noexcept;

private:
    float tile_level(weft_place x, weft_place y, weft_i32 whole) const noexcept;

    const weft_program& program_;
    const weft_mips& textons_;
    const weft_tile* tile_ = nullptr; ///< null: none
    const weft_tone* tone_ = nullptr;
    weft_u32 plane_;
};

} // namespace weft::opencl
