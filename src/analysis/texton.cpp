/// The texton of a photo: projections from white noise on, then the colour correction (paper, sections 4.2 and 4.3).
#include "analysis/texton.h"
#include "analysis/texton_fit.h"
#include "base/image.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr const char* function = "weft_analyze_texton";
constexpr std::uint32_t least_side = 8, most_photo_side = 8192, default_support = 64, most_iterations = 100000;
constexpr std::uint32_t plain_iterations = 50;        // the paper's
constexpr std::uint32_t accelerated_iterations = 100; // twice as many lower the error by less than 1 %

struct Choices {
    std::uint32_t support, iterations, taps;
    bool accelerated;
    std::uint64_t seed;
};

Choices choose(const weft_image& photo, const weft_texton_options& options)
{
    for (const std::uint32_t side : {photo.width, photo.height})
        require(side >= least_side && side <= most_photo_side, function, ": photo is ", photo.width, " x ",
                photo.height, " pixels, not ", least_side, "..", most_photo_side, " a side");
    const std::uint32_t side = std::min(photo.width, photo.height);
    require(options.support <= side, function, ": options->support is ", options.support,
            ", the photo's shorter side has ", side, " pixels");
    require(options.iterations <= most_iterations, function, ": options->iterations is ", options.iterations,
            ", more than ", most_iterations);
    require(options.projection >= WEFT_PROJECTION_DEFAULT && options.projection <= WEFT_PROJECTION_MOMENTUM, function,
            ": options->projection is ", options.projection, ", which is no weft_projection");
    const weft_interpolation taps = options.interpolation ? options.interpolation : WEFT_INTERPOLATION_LINEAR;
    require(taps == WEFT_INTERPOLATION_NEAREST || taps == WEFT_INTERPOLATION_LINEAR ||
                taps == WEFT_INTERPOLATION_CUBIC || taps == WEFT_INTERPOLATION_QUINTIC,
            function, ": options->interpolation is ", taps, ", which is no weft_interpolation");
    Choices choices{};
    choices.support = options.support ? options.support : std::min(default_support, side);
    choices.accelerated = options.projection != WEFT_PROJECTION_PLAIN;
    choices.iterations = options.iterations    ? options.iterations
                         : choices.accelerated ? accelerated_iterations
                                               : plain_iterations;
    choices.taps = static_cast<std::uint32_t>(taps);
    choices.seed = options.seed;
    return choices;
}

Texton learn(Core& core, const Target& target, const SplineSamples& samples, const Choices& choices,
             const Progress& progress)
{
    Texton texton;
    texton.taps = choices.taps;
    texton.coefficients = Planes(&core.memory, choices.support, choices.support, target.spectra.count);
    texton.model_error = 0;
    if (target.power() == 0) return texton; // a constant photo
    Planes& coefficients = texton.coefficients;
    Projection projection(core, target.spectra, samples, choices.support);
    projection.start(choices.seed, coefficients);
    fit_coefficients(core, projection, {choices.iterations, choices.accelerated, true}, target, samples, coefficients,
                     progress.part(0, 0.95));
    progress.at(0.95);
    correct_colours(core, samples, target.covariance, coefficients);
    progress.at(0.97);
    texton.model_error = static_cast<float>(model_error(projection, target, coefficients));
    for (float& value : coefficients.values)
        value = static_cast<float>(static_cast<double>(value) / target.centring.scale);
    return texton;
}

} // namespace

Model analyze_texton(Core& core, const weft_image& photo, const weft_texton_options& options, const Progress& progress)
{
    const Choices choices = choose(photo, options);
    progress.at(0);
    const SplineSamples samples = spline_samples(choices.taps);
    const Target target = make_target(core, read_image(photo, &core.memory, core.parallel, function, "photo"), samples,
                                      progress.part(0.01, 0.1));
    Model model;
    model.method = WEFT_METHOD_TEXTON;
    model.channels = photo.channels;
    for (std::uint32_t c = 0; c < photo.channels; ++c) model.mean[c] = static_cast<float>(target.centring.mean[c]);
    model.texton = learn(core, target, samples, choices, progress.part(0.1, 0.99));
    check_model(model);
    progress.at(1);
    return model;
}

} // namespace weft
