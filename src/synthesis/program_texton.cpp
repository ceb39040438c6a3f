/// Texton noise as layers: in the plane, on surfaces, mixed by a map.
#include "base/error.h"
#include "base/image.h"
#include "synthesis/grid.h"
#include "synthesis/poisson.h"
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

/// How a texton's coefficients become kernels.
struct Program::Kernels {
    std::uint32_t images; ///< of the texton's, from the first one on
    double rate;          ///< impacts per pixel, or per pixel cubed
    double scale;         ///< of the coefficients
    double mean;          ///< that the impacts of one per unit give, in sums of a kernel: taken off; 0 with signs
    std::uint32_t axes;   ///< 2, or 3 in space
    std::uint32_t levels; ///< at most
    weft_ref choice;
};

/// Where even cells of one pixel would hold too many impacts, several independent layers share them: a sum of Poisson
/// processes is one.
void Program::add_textons(Core& core, const Texton& texton, const weft_texture_options& options, const Kernels& kernels)
{
    const Planes& alpha = texton.coefficients;
    const double shares = std::max(1.0, std::ceil(kernels.rate / most_mean)), share = kernels.rate / shares;
    make_texton_mips(mips_, texton, kernels.images, kernels.scale, kernels.rate, kernels.levels, &core.memory,
                     core.parallel);

    splat_.size = sizeof splat_;
    splat_.taps = texton.taps;
    const double width = alpha.width + texton.taps, height = alpha.height + texton.taps;
    splat_.cell_log2 = kernels.axes == 2 ? choose_cell_log2(share, width, height, options.period_x, options.period_y)
                                         : choose_cell_log2_in_space(share, std::max(width, height));
    const double edge = static_cast<double>(1U << splat_.cell_log2), area = edge * edge;
    counts_ = poisson_thresholds(&core.memory, share * (kernels.axes == 2 ? area : area * edge));
    splat_.counts = counts_.data();
    splat_.count_limit = static_cast<std::uint32_t>(counts_.size());
    splat_.signs = texton.images > 1 ? 1 : 0;
    splat_.choice = kernels.choice;
    splat_.textons = &mips_.mips;
    splat_.offset = offset_;
    for (std::uint32_t c = 0; c < channels_; ++c) {
        double sum = 0;
        for (std::size_t i = 0; i < alpha.area(); ++i) sum += static_cast<double>(mips_.own[0].plane(c)[i]);
        offset_[c] = splat_.signs ? 0.0F : static_cast<float>(-(share * kernels.mean * sum)) + 0.0F; // never -0
    }
    const bool mean_is_there = layer_count_ > 0;
    for (int i = 0; i < static_cast<int>(shares); ++i)
        add_layer(WEFT_LAYER_SPLAT, i == 0 && !mean_is_there ? mean_ : nothing_).splat = &splat_;
}

/// Galerne et al. 2017, equation 6, with lambda impacts per pixel: kernel texton / sqrt(lambda), its mean taken off.
void Program::add_texton(Core& core, const Texton& texton, const weft_texture_options& options)
{
    const double rate = impacts_of(options, 30) / static_cast<double>(texton.coefficients.area());
    add_textons(core, texton, options, {1, rate, 1.0 / std::sqrt(rate), 1, 2, most_levels, nobody});
}

/// Section 6: impacts in space count as far as half a support, r, away from the surface, by a tent whose integral is r
/// / 2 and whose square's is r / 3. Of a mixed model the first step.
void Program::add_surface(Core& core, const Texton& texton, const weft_texture_options& options)
{
    const Planes& alpha = texton.coefficients;
    const double thickness = std::max(alpha.width, alpha.height);
    const double rate = impacts_of(options, 60) / (static_cast<double>(alpha.area()) * thickness);
    add_textons(core, texton, options, {1, rate, 1.0 / std::sqrt(rate * thickness / 3), thickness / 2, 3, 1, nobody});
}

/// Section 7: impacts have random signs, so that the mean is nobody's; the map chooses their textons and adds the mean.
void Program::add_mix(Core& core, const Texton& texton, const weft_texture_options& options)
{
    const float* last = texton.means.data() + std::size_t{texton.images - 1} * channels_;
    for (std::uint32_t c = 0; c < channels_; ++c) colour_[c] = last[c] - mean_[c];
    add_map(core, options);
    const double rate = impacts_of(options, 30) / static_cast<double>(texton.coefficients.area());
    const std::uint32_t images = options.mix ? texton.images : 1;
    add_textons(core, texton, options,
                {images, rate, 1.0 / std::sqrt(rate), 0, 2, most_levels, options.mix ? weft_ref{0, 0} : nobody});
}

/// Without a map one of a single 0, so that a map of zeros gives the same pixels.
void Program::add_map(Core& core, const weft_texture_options& options)
{
    constexpr char function[] = "weft_texture_create", name[] = "options->mix";
    map_ = options.mix ? read_image(*options.mix, &core.memory, core.parallel, function, name)
                       : Planes(&core.memory, 1, 1, 1);
    for (const float value : map_.values)
        require(value >= 0 && value <= 1, function, ": ", name, " has the value ", value, ", not 0..1");
    make_picture_mips(map_mips_, map_, &core.memory, core.parallel);
    tile_ = repeated_tile(map_mips_.mips, static_cast<std::uint32_t>(options.mix_scale), options.period_x,
                          options.period_y);
    weft_layer& layer = add_layer(WEFT_LAYER_TILE, mean_);
    layer.planes = layer.channels = 1;
    layer.colour = colour_;
    layer.tile = &tile_;
}

} // namespace weft
