/// The texton of a photo: projections from white noise on, then the colour correction (paper, sections 4.2 and 4.3).
#include "analysis/texton.h"
#include "analysis/noise_covariance.h"
#include "analysis/projection.h"
#include "analysis/target.h"
#include "base/image.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr const char* function = "weft_analyze_texton";
constexpr std::uint32_t least_side = 8, most_photo_side = 8192, default_support = 64, most_iterations = 100000;
constexpr std::uint32_t plain_iterations = 50;        // the paper's
constexpr std::uint32_t accelerated_iterations = 100; // twice as many lower the error by less than 1 %
constexpr double rank_tolerance = 1e-10; // of the covariance's eigenvalues: float's rounding, squared, is below

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

/// Algorithm 1 as the paper has it.
void project_plainly(Projection& projection, const Choices& choices, Planes& coefficients, Planes& spare,
                     const Progress& progress)
{
    for (std::uint32_t i = 1; i < choices.iterations; ++i) {
        progress.at(static_cast<double>(i) / choices.iterations);
        projection.apply(Projection::algorithm_1, 0, coefficients, spare);
        std::swap(coefficients, spare);
    }
}

/// The same alternation with three changes, each of which lowers the model error that it ends with.
/// - The support's projection is the one in the norm of b^, in which the model error is measured: least squares for the
///   phases of the last spectral projection.
/// - Each step starts from a point beyond the last (Nesterov 1983).
/// - Phases are eased in: a frequency whose product with the target is weak counts less at first, so that it does not
///   hold the strong ones in a poor local minimum.
void project_fast(Core& core, Projection& projection, const Choices& choices, const Target& target,
                  const SplineSamples& samples, Planes& coefficients, Planes& step, const Progress& progress)
{
    const std::uint32_t size = choices.support, width = target.spectra.width, height = target.spectra.height;
    const SplineSolver solver(core, samples, width, height, size);
    Planes ahead(&core.memory, size, size, coefficients.count);
    std::copy(coefficients.values.begin(), coefficients.values.end(), ahead.values.begin());
    const double mean_square = target.power() / width / height;
    for (std::uint32_t i = 1; i < choices.iterations; ++i) {
        progress.at(static_cast<double>(i) / choices.iterations);
        const float momentum = static_cast<float>(i) / static_cast<float>(i + 3);
        for (std::size_t k = 0; k < ahead.values.size(); ++k) { // `ahead` holds the coefficients before the last
            const float now = coefficients.values[k];
            ahead.values[k] = now + momentum * (now - ahead.values[k]);
        }
        const double left = 1 - static_cast<double>(i) / choices.iterations;
        const float smoothing = static_cast<float>(10 * mean_square * left * left * left * left);
        projection.apply(Projection::least_squares, smoothing, ahead, step);
        solver.solve(step);
        for (std::size_t k = 0; k < step.values.size(); ++k) step.values[k] += ahead.values[k];
        std::swap(ahead, coefficients); // `ahead` <- the coefficients now, and these <- the step
        std::swap(coefficients, step);
    }
}

/// coefficients <- matrix * coefficients, channel vectors one by one.
void multiply(Core& core, const Matrix& matrix, Planes& coefficients)
{
    for_each_run(core.parallel, coefficients.height, [&](std::uint32_t first, std::uint32_t last) {
        double vector[most_channels];
        for (std::size_t k = std::size_t{first} * coefficients.width; k < std::size_t{last} * coefficients.width; ++k) {
            for (std::uint32_t c = 0; c < matrix.size; ++c) vector[c] = static_cast<double>(coefficients.plane(c)[k]);
            for (std::uint32_t c = 0; c < matrix.size; ++c) {
                double sum = 0;
                for (std::uint32_t d = 0; d < matrix.size; ++d) sum += matrix[c][d] * vector[d];
                coefficients.plane(c)[k] = static_cast<float>(sum);
            }
        }
    });
}

/// Relative model error (Xia et al. 2014) of the coefficients against the target.
double model_error(Projection& projection, const Target& target, const Planes& coefficients)
{
    const ModelSums sums = projection.measure(coefficients);
    return std::sqrt(std::max(0.0, (target.power() + sums.power - 2 * sums.agreement) / target.power()));
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
    {
        Planes spare(&core.memory, choices.support, choices.support, target.spectra.count);
        const Progress loop = progress.part(0, 0.95);
        if (choices.accelerated)
            project_fast(core, projection, choices, target, samples, coefficients, spare, loop);
        else
            project_plainly(projection, choices, coefficients, spare, loop);
    }
    progress.at(0.95);
    const Matrix correction = square_root(target.covariance) *
                              inverse_square_root(noise_covariance(core, samples, coefficients), rank_tolerance);
    multiply(core, correction, coefficients);
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
