/// Programs: what all methods share, and pictures.
#include "synthesis/program.h"
#include "base/error.h"
#include "base/image.h"
#include "synthesis/check.h"
#include "synthesis/grid.h"
#include <cmath>

namespace weft {

namespace {

constexpr std::uint32_t most_period = 1U << 24;

void check_period(std::uint32_t period, std::uint32_t size, const char* field)
{
    require(period <= most_period, "weft_texture_create: options->", field, " is ", period, ", more than 2^24");
    require(size == 0 || period % size == 0, "weft_texture_create: options->", field, " is ", period,
            ", no multiple of the picture's or tile's ", size);
}

void check_mix(const Model& model, const weft_texture_options& options)
{
    constexpr char function[] = "weft_texture_create";
    const float scale = options.mix_scale;
    require(scale >= 1 && scale <= 65536 && scale == std::floor(scale), function, ": options->mix_scale is ", scale,
            ", no whole number of 1..65536");
    if (!options.mix) return;
    check_image(options.mix, function, "options->mix");
    require(options.mix->channels == 1, function, ": options->mix->channels is ", options.mix->channels, ", not 1");
    require(options.mix->width <= most_side && options.mix->height <= most_side, function, ": options->mix is ",
            options.mix->width, " x ", options.mix->height, ", more than ", most_side, " a side");
    require(model.texton.images > 1, function,
            ": options->mix is given, but the model is not mixed of two by weft_model_mix");
}

void check_layers(const Model& model, const weft_texture_options& options)
{
    constexpr char function[] = "weft_texture_create";
    require(options.rotation >= WEFT_ROTATION_DEFAULT && options.rotation <= WEFT_ROTATION_ALL, function,
            ": options->rotation is ", options.rotation, ", none of WEFT_ROTATION_*");
    require(options.scale_min == 0 || (options.scale_min >= 0.5F && options.scale_min <= 1), function,
            ": options->scale_min is ", options.scale_min, ", not 0.5..1");
    require(options.turbulence <= 64 && std::isfinite(options.turbulence), function, ": options->turbulence is ",
            options.turbulence, ", not 64 or less");
    require(options.noise >= WEFT_NOISE_DEFAULT && options.noise <= WEFT_NOISE_TILE, function, ": options->noise is ",
            options.noise, ", none of WEFT_NOISE_*");
    require(model.method == WEFT_METHOD_BILAYER ||
                (options.rotation == 0 && options.scale_min == 0 && options.turbulence == 0 && options.noise == 0),
            function, ": options->rotation, scale_min, turbulence or noise is given, but the model has one layer");
}

} // namespace

weft_texture_options complete_options(const Model& model, weft_texture_options options)
{
    require(options.impacts == 0 || (options.impacts >= 1 && options.impacts <= 1000),
            "weft_texture_create: options->impacts is ", options.impacts, ", not 1..1000");
    if (options.mix_scale == 0) options.mix_scale = 1;
    check_period(options.period_x, model.picture.width, "period_x");
    check_period(options.period_y, model.picture.height, "period_y");
    check_mix(model, options);
    check_layers(model, options);
    return options;
}

Program::Program(Core& core, const Model& model, const weft_texture_options& options, Positions positions)
    : channels_(model.channels)
{
    for (std::uint32_t c = 0; c < channels_; ++c) {
        identity_[c * channels_ + c] = 1;
        mean_[c] = model.mean[c];
    }
    if (model.method == WEFT_METHOD_WAVELET)
        add_bands(core, model.wavelet, options, positions);
    else if (model.method == WEFT_METHOD_BILAYER)
        add_bilayer(core, model.bilayer, options);
    else if (model.method == WEFT_METHOD_PICTURE || model.method == WEFT_METHOD_STATIONARY)
        add_picture(core, model.picture, options);
    else if (positions == in_space)
        add_surface(core, model.texton, options);
    else if (model.texton.images > 1)
        add_mix(core, model.texton, options);
    else
        add_texton(core, model.texton, options);
    publish(options, positions == in_plane                 ? WEFT_USE_WINDOW
                     : model.method == WEFT_METHOD_WAVELET ? WEFT_USE_SOLID
                                                           : WEFT_USE_SURFACE);
    check_program(program_); // points_ differs in its use alone
}

void Program::add_picture(Core& core, const Planes& picture, const weft_texture_options& options)
{
    make_picture_mips(mips_, picture, &core.memory, core.parallel);
    tile_ = repeated_tile(mips_.mips, picture.width, picture.height, 1, options.period_x, options.period_y);
    add_layer(WEFT_LAYER_TILE, nothing_).tile = &tile_;
}

/// Of as many planes as channels, added to the result as they are.
weft_layer& Program::add_layer(weft_layer_kind kind, const float* mean)
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
    order_[layer_count_++] = &layer;
    return layer;
}

void Program::publish(const weft_texture_options& options, weft_use use)
{
    program_.size = sizeof program_;
    program_.use = use;
    program_.channels = channels_;
    program_.layer_count = layer_count_;
    program_.seed = options.seed;
    program_.layers = order_;
    if (use != WEFT_USE_WINDOW) return;
    program_.period[0] = options.period_x;
    program_.period[1] = options.period_y;
    points_ = program_;
    points_.use = WEFT_USE_POINTS;
}

} // namespace weft
