/// How a structure layer is put together anew, as a TILE layer wants it: Wang tiles, exchanged contents, feathers.
#pragma once
#include "base/core.h"
#include "synthesis/mips.h"

namespace weft {

/// Stays where it was made: `tile` points into it.
struct Structure_tables {
    Structure_tables() = default;
    Structure_tables(const Structure_tables&) = delete;
    Structure_tables& operator=(const Structure_tables&) = delete;

    /// Options are complete_options'. `tile.displacement` is nobody. Borrows from the model.
    void make(Core& core, const Bilayer& bilayer, const weft_texture_options& options);

    weft_tile tile{};

private:
    void make_wang(Core& core, const Wang& from);
    void make_exchange(Core& core, const Bilayer& bilayer, const weft_texture_options& options);

    Mip_chain mips_;
    weft_wang wang_{};
    weft_exchange exchange_{};
    Array<weft_diamond> diamonds_;
    Array<weft_patch> patches_;
    Array<weft_content> contents_;
    Array<std::uint8_t> contours_;
    Array<float> sharp_, feather_;
};

} // namespace weft
