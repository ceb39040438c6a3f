/// Methods as programs.
#include "synthesis/program.h"
#include "base/error.h"
#include "synthesis/check.h"
#include "synthesis/poisson.h"
#include <cmath>

namespace weft {

namespace {

constexpr weft_ref nobody{-1, 0};
constexpr float default_impacts = 30;
constexpr std::uint32_t most_period = 1U << 24;

void check_period(std::uint32_t period, std::uint32_t size, const char* field)
{
    require(period <= most_period, "weft_texture_create: options->", field, " is ", period, ", more than 2^24");
    require(size == 0 || period % size == 0, "weft_texture_create: options->", field, " is ", period,
            ", no multiple of the picture's ", size);
}

/// The cell is the whole source, again and again; one texel per pixel.
weft_grid grid_of(std::uint32_t size, std::uint32_t period) noexcept
{
    const std::uint32_t cells = period ? period / size : 1, span = cells * size;
    return {span, cells, 1.0F / static_cast<float>(span), 1.0F};
}

} // namespace

weft_texture_options complete_options(const Model& model, weft_texture_options options)
{
    if (options.impacts == 0) options.impacts = default_impacts;
    require(options.impacts >= 1 && options.impacts <= 1000, "weft_texture_create: options->impacts is ",
            options.impacts, ", not 1..1000");
    check_period(options.period_x, model.picture.width, "period_x");
    check_period(options.period_y, model.picture.height, "period_y");
    return options;
}

Program::Program(Core& core, const Model& model, const weft_texture_options& options) : channels_(model.channels)
{
    for (std::uint32_t c = 0; c < channels_; ++c) {
        identity_[c * channels_ + c] = 1;
        mean_[c] = model.mean[c];
    }
    if (model.method == WEFT_METHOD_TEXTON)
        add_texton(core, model.texton, options);
    else
        add_picture(core, model.picture, options);
    publish(options);
    check_program(window_); // points_ differs in its use alone
}

/// The noise of Galerne et al. 2017, equation 6, with lambda impacts per pixel: kernel texton / sqrt(lambda), its mean
/// taken off. Where even cells of one pixel would hold too many impacts, several independent layers share them: a sum
/// of Poisson processes is one.
void Program::add_texton(Core& core, const Texton& texton, const weft_texture_options& options)
{
    const Planes& alpha = texton.coefficients;
    const double rate = static_cast<double>(options.impacts) / static_cast<double>(alpha.area());
    const double shares = std::ceil(rate / most_mean), share = shares > 1 ? rate / shares : rate;
    make_texton_mips(mips_, texton, 1.0 / std::sqrt(rate), rate, &core.memory, core.parallel);

    splat_.size = sizeof splat_;
    splat_.taps = texton.taps;
    splat_.cell_log2 = choose_cell_log2(share, alpha.width + texton.taps, alpha.height + texton.taps, options.period_x,
                                        options.period_y);
    const double cell = static_cast<double>(1U << splat_.cell_log2);
    counts_ = poisson_thresholds(&core.memory, share * cell * cell);
    splat_.counts = counts_.data();
    splat_.count_limit = static_cast<std::uint32_t>(counts_.size());
    splat_.choice = nobody;
    splat_.textons = &mips_.mips;
    splat_.offset = offset_;
    for (std::uint32_t c = 0; c < channels_; ++c) {
        double sum = 0;
        for (std::size_t i = 0; i < alpha.area(); ++i) sum += static_cast<double>(mips_.own[0].plane(c)[i]);
        offset_[c] = static_cast<float>(-(share * sum)) + 0.0F; // never -0
    }
    for (int i = 0; i < (shares > 1 ? static_cast<int>(shares) : 1); ++i)
        add_layer(WEFT_LAYER_SPLAT, i == 0 ? mean_ : nothing_);
}

void Program::add_picture(Core& core, const Planes& picture, const weft_texture_options& options)
{
    make_picture_mips(mips_, picture, &core.memory, core.parallel);
    tile_.size = sizeof tile_;
    tile_.address = WEFT_ADDRESS_CELLS;
    tile_.width = picture.width;
    tile_.height = picture.height;
    tile_.x = grid_of(picture.width, options.period_x);
    tile_.y = grid_of(picture.height, options.period_y);
    tile_.displacement = nobody;
    tile_.source = &mips_.mips;
    add_layer(WEFT_LAYER_TILE, nothing_);
}

void Program::add_layer(weft_layer_kind kind, const float* mean)
{
    weft_layer& layer = layers_[layer_count_];
    layer.size = sizeof layer;
    layer.kind = kind;
    layer.stream = layer_count_;
    layer.planes = channels_;
    layer.channels = channels_;
    layer.mask = nobody;
    layer.colour = identity_;
    layer.mean = mean;
    if (kind == WEFT_LAYER_SPLAT)
        layer.splat = &splat_;
    else
        layer.tile = &tile_;
    order_[layer_count_++] = &layer;
}

void Program::publish(const weft_texture_options& options)
{
    window_.size = sizeof window_;
    window_.use = WEFT_USE_WINDOW;
    window_.channels = channels_;
    window_.layer_count = layer_count_;
    window_.seed = options.seed;
    window_.period[0] = options.period_x;
    window_.period[1] = options.period_y;
    window_.layers = order_;
    points_ = window_;
    points_.use = WEFT_USE_POINTS;
}

} // namespace weft
