/// Tone curves and colour matrix of principal axes, as a layer wants them.
#pragma once
#include "base/array.h"
#include "base/core.h"
#include "model/colour_axes.h"
#include <weft/backend.h>

namespace weft {

struct Tone_tables {
    void make(Core& core, const Colour_axes& colours, std::uint32_t channels);

    /// Sets tones and colour of a layer of as many planes as channels.
    void give(weft_layer& layer) const noexcept;

private:
    Array<weft_tone> tones_;
    Array<weft_piece> pieces_;
    Array<float> colour_;
};

} // namespace weft
