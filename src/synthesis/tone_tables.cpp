/// Inverse axes, and the polynomials between knots.
#include "synthesis/tone_tables.h"
#include "model/tone.h"

namespace weft {

void Tone_tables::make(Core& core, const Colour_axes& colours, std::uint32_t channels)
{
    colour_ = Array<float>(&core.memory, std::size_t{channels} * channels);
    for (std::uint32_t o = 0; o < channels; ++o)
        for (std::uint32_t p = 0; p < channels; ++p) colour_[o * channels + p] = colours.axes[p][o];
    if (colours.knots == 0) return;
    const std::uint32_t count = colours.knots - 1;
    tones_ = Array<weft_tone>(&core.memory, channels);
    pieces_ = Array<weft_piece>(&core.memory, std::size_t{count} * channels);
    for (std::uint32_t p = 0; p < channels; ++p) {
        weft_piece* pieces = &pieces_[std::size_t{count} * p];
        for (std::uint32_t k = 0; k < count; ++k) {
            const Tone_piece piece = tone_piece(colours, p, k);
            pieces[k] = {piece.x, piece.c0, piece.c1, piece.c2, piece.c3};
        }
        tones_[p] = {colours.knot_x[0][p], colours.knot_x[count][p], count, 0, pieces};
    }
}

void Tone_tables::give(weft_layer& layer) const noexcept
{
    layer.tones = tones_.data();
    layer.colour = colour_.data();
}

} // namespace weft
