/// One noise of a bi-layer model, as a layer wants it: texton noise, or a tile of it.
#pragma once
#include "model/bilayer.h"
#include "synthesis/splat_tables.h"
#include "synthesis/tone_tables.h"

namespace weft {

/// Stays where it was made.
struct Noise_tables {
    Noise_tables() = default;
    Noise_tables(const Noise_tables&) = delete;
    Noise_tables& operator=(const Noise_tables&) = delete;

    /// Options are complete_options'. `mean` is added to the noise's own.
    void make(Core& core, const Noise& noise, const float* mean, const weft_texture_options& options);

    /// Sets what the noise is made of: mean, axes, and the SPLAT or the TILE.
    void give(weft_layer& layer) const noexcept;

private:
    Splat_tables splat_;
    Planes picture_;
    Mip_chain mips_;
    weft_tile tile_{};
    Tone_tables tones_;
    float mean_[most_channels]{};
};

} // namespace weft
