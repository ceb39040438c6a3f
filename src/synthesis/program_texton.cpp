/// Texton noise as layers: in the plane, on surfaces, mixed by a map.
#include "base/error.h"
#include "base/image.h"
#include "synthesis/grid.h"
#include "synthesis/program.h"
#include <algorithm>
#include <cmath>

namespace weft {

namespace {

double impacts_of(const weft_texture_options& options, float unset) noexcept
{
    return static_cast<double>(options.impacts == 0 ? unset : options.impacts);
}

} // namespace

/// Of the texton's images the first `images`. The mean is added here, unless a layer before did so.
void Program::add_textons(Core& core, const Texton& texton, std::uint32_t images, const weft_texture_options& options,
                          const Splat_kernels& kernels, const weft_ref& choice)
{
    const std::uint32_t layers = splat_.make(core, {texton.coefficients, texton.images, images, texton.taps}, kernels,
                                             options.period_x, options.period_y);
    splat_.splat.choice = choice;
    const bool mean_is_there = layer_count_ > 0;
    for (std::uint32_t i = 0; i < layers; ++i)
        add_layer(WEFT_LAYER_SPLAT, i == 0 && !mean_is_there ? mean_ : nothing_).splat = &splat_.splat;
}

/// Galerne et al. 2017, equation 6, with lambda impacts per pixel: kernel texton / sqrt(lambda), its mean taken off.
void Program::add_texton(Core& core, const Texton& texton, const weft_texture_options& options)
{
    const double rate = impacts_of(options, 30) / static_cast<double>(texton.coefficients.area());
    add_textons(core, texton, 1, options, {rate, 1.0 / std::sqrt(rate), 1, 2, most_levels, texton.images > 1}, nobody);
}

/// Section 6: impacts in space count as far as half a support, r, away from the surface, by a tent whose integral is r
/// / 2 and whose square's is r / 3. Of a mixed model the first step.
void Program::add_surface(Core& core, const Texton& texton, const weft_texture_options& options)
{
    const Planes& alpha = texton.coefficients;
    const double thickness = std::max(alpha.width, alpha.height);
    const double rate = impacts_of(options, 60) / (static_cast<double>(alpha.area()) * thickness);
    add_textons(core, texton, 1, options,
                {rate, 1.0 / std::sqrt(rate * thickness / 3), thickness / 2, 3, 1, texton.images > 1}, nobody);
}

/// Section 7: impacts have random signs, so that the mean is nobody's; the map chooses their textons and adds the mean.
void Program::add_mix(Core& core, const Texton& texton, const weft_texture_options& options)
{
    const float* last = texton.means.data() + std::size_t{texton.images - 1} * channels_;
    for (std::uint32_t c = 0; c < channels_; ++c) colour_[c] = last[c] - mean_[c];
    add_map(core, options);
    const double rate = impacts_of(options, 30) / static_cast<double>(texton.coefficients.area());
    const std::uint32_t images = options.mix ? texton.images : 1;
    add_textons(core, texton, images, options, {rate, 1.0 / std::sqrt(rate), 0, 2, most_levels, true},
                options.mix ? weft_ref{0, 0} : nobody);
}

/// Without a map one of a single 0, so that a map of zeros gives the same pixels.
void Program::add_map(Core& core, const weft_texture_options& options)
{
    constexpr char function[] = "weft_texture_create", name[] = "options->mix";
    map_ = options.mix ? read_image(*options.mix, &core.memory, core.parallel, function, name)
                       : Planes(&core.memory, 1, 1, 1);
    for (const float value : map_.values)
        require(value >= 0 && value <= 1, function, ": ", name, " has the value ", value, ", not 0..1");
    make_picture_mips(mips_, map_, &core.memory, core.parallel);
    tile_ = repeated_tile(mips_.mips, map_.width, map_.height, static_cast<std::uint32_t>(options.mix_scale),
                          options.period_x, options.period_y);
    weft_layer& layer = add_layer(WEFT_LAYER_TILE, mean_);
    layer.planes = layer.channels = 1;
    layer.colour = colour_;
    layer.tile = &tile_;
}

} // namespace weft
