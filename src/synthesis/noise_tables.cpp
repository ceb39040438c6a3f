/// All noises of a model share impacts, so that where two of them blend, their textons do.
#include "synthesis/noise_tables.h"
#include "base/hash.h"
#include "synthesis/grid.h"
#include "synthesis/noise_tile.h"
#include <cmath>

namespace weft {

void Noise_tables::make(Core& core, const Noise& noise, const float* mean, const weft_texture_options& options)
{
    const Planes& alpha = noise.coefficients;
    for (std::uint32_t c = 0; c < alpha.count; ++c) mean_[c] = noise.mean[c] + mean[c];
    tones_.make(core, noise, alpha.count);
    if (options.noise == WEFT_NOISE_TILE) {
        picture_ = make_noise_tile(core, alpha, noise_tile_side(options.period_x), noise_tile_side(options.period_y),
                                   mix_in(options.seed, 4));
        make_picture_mips(mips_, picture_, &core.memory, core.parallel);
        tile_ = repeated_tile(mips_.mips, picture_.width, picture_.height, 1, options.period_x, options.period_y);
        return;
    }
    const double impacts = options.impacts == 0 ? 30 : static_cast<double>(options.impacts);
    const double rate = impacts / static_cast<double>(alpha.area());
    splat_.make(core, {alpha, 1, 1, 2}, {rate, 1.0 / std::sqrt(rate), 1, 2, most_levels, false}, options.period_x,
                options.period_y);
}

void Noise_tables::give(weft_layer& layer) const noexcept
{
    layer.mean = mean_;
    tones_.give(layer);
    if (tile_.source)
        layer.tile = &tile_;
    else
        layer.splat = &splat_.splat;
}

} // namespace weft
