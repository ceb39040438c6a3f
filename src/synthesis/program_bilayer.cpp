/// Bi-layer textures as layers (Guingo et al. 2017, equation 1): distortion, structure with masks, a noise for each
/// mask.
#include "base/elementary.h"
#include "base/hash.h"
#include "synthesis/grid.h"
#include "synthesis/program.h"
#include <algorithm>
#include <cmath>

namespace weft {

namespace {

/// Two planes of one octave of wavelet noise, of about the wavelength; an amplitude is twice the deviation.
Wavelet distortion_of(float amplitude, float wavelength) noexcept
{
    Wavelet wavelet;
    const double octave = log2_of(static_cast<double>(wavelength)) - 1.5; // band b is of 2^(b + 1)..2^(b + 2) pixels
    const auto band = static_cast<std::uint32_t>(std::clamp(octave + 0.5, 0.0, most_bands - 1.0));
    wavelet.bands = band + 1;
    wavelet.weight[band][0] = wavelet.weight[band][1] = amplitude / 2;
    return wavelet;
}

} // namespace

/// The noises lie where they are, undistorted: that is what the two layers are for. The mean of a model without
/// structure is each noise's, as the sum of their masks is 1; of others it is 0.
void Program::add_bilayer(Core& core, const Bilayer& bilayer, const weft_texture_options& options)
{
    Bilayer_tables& tables = bilayer_.emplace();
    const auto noises = static_cast<std::uint32_t>(bilayer.noises.size());
    weft_ref mask = nobody;
    if (bilayer.plain == 0 || noises > 1) mask = add_structure(core, bilayer, options);
    for (std::uint32_t k = 0; k < noises; ++k) {
        tables.noises[k].make(core, bilayer.noises[k], mean_, options);
        weft_layer& layer = add_layer(options.noise == WEFT_NOISE_TILE ? WEFT_LAYER_TILE : WEFT_LAYER_SPLAT, nothing_);
        layer.stream = most_layers;
        tables.noises[k].give(layer);
        layer.mask = mask;
        if (mask.layer >= 0) ++mask.plane;
    }
}

/// Returns where the first mask is.
weft_ref Program::add_structure(Core& core, const Bilayer& bilayer, const weft_texture_options& options)
{
    const float turbulence = options.turbulence == 0 ? bilayer.turbulence : options.turbulence;
    Bilayer_tables& tables = *bilayer_;
    tables.structure.make(core, bilayer, options);
    if (turbulence > 0) {
        tables.distortion.emplace(core, distortion_of(turbulence, bilayer.wavelength), 2, mix_in(options.seed, 5),
                                  options.period_x, options.period_y);
        tables.structure.tile.displacement = {static_cast<std::int32_t>(layer_count_), 0};
        weft_layer& layer = add_layer(WEFT_LAYER_BANDS, nothing_);
        layer.planes = 2;
        layer.channels = 0;
        layer.bands = &tables.distortion->bands();
    }
    const auto index = static_cast<std::int32_t>(layer_count_);
    weft_layer& layer = add_layer(WEFT_LAYER_TILE, nothing_);
    layer.planes = bilayer.structure.count;
    layer.channels = bilayer.plain != 0 ? 0 : channels_;
    layer.tile = &tables.structure.tile;
    return {index, layer.channels};
}

} // namespace weft
