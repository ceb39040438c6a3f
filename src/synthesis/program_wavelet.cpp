/// Wavelet noise as one layer: a plane for each principal axis, tone curves, the colour frame.
#include "model/tone.h"
#include "synthesis/program.h"

namespace weft {

void Program::add_bands(Core& core, const Wavelet& wavelet, const weft_texture_options& options, Positions positions)
{
    if (positions == in_plane)
        lattices_.emplace(core, wavelet, channels_, options.seed, options.period_x, options.period_y);
    else
        lattices_.emplace(core, wavelet, channels_, options.seed);
    for (std::uint32_t o = 0; o < channels_; ++o)
        for (std::uint32_t p = 0; p < channels_; ++p) colour_[o * channels_ + p] = wavelet.axes[p][o];
    if (wavelet.knots > 0) add_tones(core, wavelet);
    weft_layer& layer = add_layer(WEFT_LAYER_BANDS, mean_);
    layer.colour = colour_;
    layer.tones = tones_.data();
    layer.bands = &lattices_->bands();
}

void Program::add_tones(Core& core, const Wavelet& wavelet)
{
    const std::uint32_t count = wavelet.knots - 1;
    tones_ = Array<weft_tone>(&core.memory, channels_);
    pieces_ = Array<weft_piece>(&core.memory, std::size_t{count} * channels_);
    for (std::uint32_t p = 0; p < channels_; ++p) {
        weft_piece* pieces = &pieces_[std::size_t{count} * p];
        for (std::uint32_t k = 0; k < count; ++k) {
            const Tone_piece piece = tone_piece(wavelet, p, k);
            pieces[k] = {piece.x, piece.c0, piece.c1, piece.c2, piece.c3};
        }
        tones_[p] = {wavelet.knot_x[0][p], wavelet.knot_x[count][p], count, 0, pieces};
    }
}

} // namespace weft
