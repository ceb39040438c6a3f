/// A texton as a SPLAT layer wants it: kernels, counts of impacts, offsets.
#pragma once
#include "base/core.h"
#include "synthesis/mips.h"

namespace weft {

/// How coefficients become kernels.
struct Splat_kernels {
    double rate;          ///< impacts per pixel, or per pixel cubed
    double scale;         ///< of the coefficients
    double mean;          ///< that the impacts of one per unit give, in sums of a kernel: taken off; 0 with signs
    std::uint32_t axes;   ///< 2, or 3 in space
    std::uint32_t levels; ///< at most
    bool signs;
};

/// Stays where it was made.
struct Splat_tables {
    Splat_tables() = default;
    Splat_tables(const Splat_tables&) = delete;
    Splat_tables& operator=(const Splat_tables&) = delete;

    /// Returns how many independent layers share the impacts, where even cells of one pixel would hold too many: a sum
    /// of Poisson processes is one. `choice` is nobody.
    std::uint32_t make(Core& core, const Splat_source& source, const Splat_kernels& kernels, std::uint32_t period_x,
                       std::uint32_t period_y);

    weft_splat splat{};

private:
    Mip_chain mips_;
    Array<std::uint32_t> counts_;
    float offset_[most_channels]{};
};

} // namespace weft
