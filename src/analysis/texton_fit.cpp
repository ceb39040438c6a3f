/// Algorithm 1 of Galerne, Leclaire, Moisan 2017, plain and accelerated, and its colour correction.
#include "analysis/texton_fit.h"
#include "analysis/noise_covariance.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr double rank_tolerance = 1e-10; // of the covariance's eigenvalues: float's rounding, squared, is below

/// Algorithm 1 as the paper has it.
void project_plainly(Projection& projection, std::uint32_t iterations, Planes& coefficients, Planes& spare,
                     const Progress& progress)
{
    for (std::uint32_t i = 1; i < iterations; ++i) {
        progress.at(static_cast<double>(i) / iterations);
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
void project_fast(Core& core, Projection& projection, std::uint32_t iterations, double easing, const Target& target,
                  const SplineSamples& samples, Planes& coefficients, Planes& step, const Progress& progress)
{
    const std::uint32_t size = coefficients.width, width = target.spectra.width, height = target.spectra.height;
    const SplineSolver solver(core, samples, width, height, size);
    Planes ahead(&core.memory, size, size, coefficients.count);
    std::copy(coefficients.values.begin(), coefficients.values.end(), ahead.values.begin());
    const double mean_square = target.power() / width / height;
    for (std::uint32_t i = 1; i < iterations; ++i) {
        progress.at(static_cast<double>(i) / iterations);
        const float momentum = static_cast<float>(i) / static_cast<float>(i + 3);
        for (std::size_t k = 0; k < ahead.values.size(); ++k) { // `ahead` holds the coefficients before the last
            const float now = coefficients.values[k];
            ahead.values[k] = now + momentum * (now - ahead.values[k]);
        }
        const double left = 1 - static_cast<double>(i) / iterations;
        const float smoothing = static_cast<float>(easing * mean_square * left * left * left * left);
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

} // namespace

void fit_coefficients(Core& core, Projection& projection, const Fit& fit, const Target& target,
                      const SplineSamples& samples, Planes& coefficients, const Progress& progress)
{
    Planes spare(&core.memory, coefficients.width, coefficients.height, coefficients.count);
    if (fit.accelerated)
        project_fast(core, projection, fit.iterations, fit.ease ? 10 : 0, target, samples, coefficients, spare,
                     progress);
    else
        project_plainly(projection, fit.iterations, coefficients, spare, progress);
}

void correct_colours(Core& core, const SplineSamples& samples, const Matrix& covariance, Planes& coefficients)
{
    const Matrix correction =
        square_root(covariance) * inverse_square_root(noise_covariance(core, samples, coefficients), rank_tolerance);
    multiply(core, correction, coefficients);
}

double model_error(Projection& projection, const Target& target, const Planes& coefficients)
{
    const ModelSums sums = projection.measure(coefficients);
    return std::sqrt(std::max(0.0, (target.power() + sums.power - 2 * sums.agreement) / target.power()));
}

} // namespace weft
