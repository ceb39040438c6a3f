/// Wavelet noise as one layer: a plane for each principal axis, tone curves, the colour frame.
#include "synthesis/program.h"

namespace weft {

void Program::add_bands(Core& core, const Wavelet& wavelet, const weft_texture_options& options, Positions positions)
{
    if (positions == in_plane)
        lattices_.emplace(core, wavelet, channels_, options.seed, options.period_x, options.period_y);
    else
        lattices_.emplace(core, wavelet, channels_, options.seed);
    tones_.make(core, wavelet, channels_);
    weft_layer& layer = add_layer(WEFT_LAYER_BANDS, mean_);
    tones_.give(layer);
    layer.bands = &lattices_->bands();
}

} // namespace weft
