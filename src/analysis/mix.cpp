/// Barycentres of two Gaussian textures, and a texton for each.
#include "analysis/mix.h"
#include "analysis/texton_fit.h"
#include "base/error.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr const char* function = "weft_model_mix";
constexpr std::uint32_t iterations = 50; // from so near, more gain nothing
constexpr float least_modulus = 1e-30f;  // what is below is 0: its phase means nothing

void check(const Model& a, const Model& b, std::uint32_t steps)
{
    require(a.method == WEFT_METHOD_TEXTON && b.method == WEFT_METHOD_TEXTON, function,
            ": the methods of the models are ", a.method, " and ", b.method, ", not both WEFT_METHOD_TEXTON");
    require(a.channels == b.channels, function, ": b has ", b.channels, " channels, a has ", a.channels);
    require(a.texton.taps == b.texton.taps, function, ": the interpolation of b is ", b.texton.taps, ", that of a is ",
            a.texton.taps);
    require(a.texton.images == 1 && b.texton.images == 1, function, ": ", a.texton.images > 1 ? 'a' : 'b',
            " is a mixed model itself");
    require(steps >= 2 && steps <= most_images, function, ": steps is ", steps, ", not 2..", most_images);
}

/// A power of two that brings the greatest coefficient of both to 1..2; 1 if all are 0.
double common_scale(const Planes& a, const Planes& b) noexcept
{
    float greatest = 0;
    for (const Planes* planes : {&a, &b})
        for (const float value : planes->values) greatest = std::max(greatest, std::abs(value));
    return greatest > 0 ? std::ldexp(1.0, -std::ilogb(greatest)) : 1;
}

/// The texton's planes in the corner of planes of another size.
Planes padded(Core& core, const Planes& planes, std::uint32_t side, double scale)
{
    Planes result(&core.memory, side, side, planes.count);
    for (std::uint32_t c = 0; c < planes.count; ++c)
        for (std::uint32_t y = 0; y < planes.height; ++y)
            for (std::uint32_t x = 0; x < planes.width; ++x)
                result.row(c, y)[x] = static_cast<float>(static_cast<double>(planes.row(c, y)[x]) * scale);
    return result;
}

/// Both textons' t^ = sqrt(b^) alpha^ on one grid, the first one's turned frequency by frequency so that the path
/// between them is the shortest: t_u^ <- t_u^ (t_u^* t_v^) / |t_u^* t_v|.
class Path {
public:
    Path(Core& core, const Model& a, const Model& b, std::uint32_t support, double scale, const SplineSamples& samples)
        : core_(core), side_(fast_length(2 * support + 2 * samples.count)),
          from_(&core.memory, side_, side_, a.channels), to_(&core.memory, side_, side_, a.channels),
          b_x_(spline_spectrum(&core.memory, samples, side_, from_.blocks() * fft_lanes)),
          b_y_(spline_spectrum(&core.memory, samples, side_, side_))
    {
        const PlaneTransform transform(core, side_, side_);
        const Planes u = padded(core, a.texton.coefficients, side_, scale),
                     v = padded(core, b.texton.coefficients, side_, scale);
        for (std::uint32_t c = 0; c < a.channels; ++c) {
            transform.forward(u.plane(c), from_, c);
            transform.forward(v.plane(c), to_, c);
        }
        for_each_run(core.parallel, from_.blocks(), [&](std::uint32_t first, std::uint32_t last) {
            for (std::uint32_t block = first; block < last; ++block) align(block);
        });
    }

    /// The barycentre at `rho`.
    Target at(double rho) const
    {
        Target target;
        target.spectra = Spectra(&core_.memory, side_, side_, from_.count);
        const float begin = static_cast<float>(1 - rho), end = static_cast<float>(rho);
        Array<Matrix> parts(&core_.memory, from_.blocks());
        const std::size_t size = from_.count * from_.block_size();
        for_each_run(core_.parallel, from_.blocks(), [&](std::uint32_t first, std::uint32_t last) {
            for (std::uint32_t b = first; b < last; ++b) {
                Complex* block = target.spectra.block(b, 0);
                for (std::size_t i = 0; i < size; ++i)
                    block[i] = begin * from_.block(b, 0)[i] + end * to_.block(b, 0)[i];
                parts[b] = block_covariance(target.spectra, b, block, 1 / (static_cast<double>(side_) * side_));
                for (std::size_t i = 0; i < size; ++i)
                    block[i] *= std::sqrt(b_x_[b * fft_lanes + i % fft_lanes] * b_y_[i / fft_lanes % side_]);
            }
        });
        target.covariance = sum_of(parts, from_.count);
        return target;
    }

private:
    void align(std::uint32_t block) noexcept
    {
        for (std::uint32_t y = 0; y < side_; ++y)
            for (std::uint32_t i = 0; i < fft_lanes; ++i) {
                const std::size_t at = std::size_t{y} * fft_lanes + i;
                const float root = std::sqrt(b_x_[block * fft_lanes + i] * b_y_[y]);
                Complex product = 0;
                for (std::uint32_t c = 0; c < from_.count; ++c) {
                    Complex &u = from_.block(block, c)[at], &v = to_.block(block, c)[at];
                    product +=
                        Complex(u.real() * v.real() + u.imag() * v.imag(), u.real() * v.imag() - u.imag() * v.real());
                    v *= root;
                }
                const float modulus = std::abs(product);
                const Complex turn = modulus > least_modulus ? product / modulus : Complex(1);
                for (std::uint32_t c = 0; c < from_.count; ++c) {
                    Complex& u = from_.block(block, c)[at];
                    u = root * Complex(u.real() * turn.real() - u.imag() * turn.imag(),
                                       u.real() * turn.imag() + u.imag() * turn.real());
                }
            }
    }

    Core& core_;
    std::uint32_t side_;
    Spectra from_, to_;
    Array<float> b_x_, b_y_;
};

/// The steps from one end inwards, each of which starts from the one before: the nearer to the end, the less is left to
/// correct. The end itself stays as it is.
class Steps {
public:
    Steps(Core& core, const Path& path, const SplineSamples& samples, double scale, Texton& texton)
        : core_(core), path_(path), samples_(samples), scale_(scale), texton_(texton)
    {
    }

    /// Steps `first`, first + direction, ..., `count` of them.
    void walk(const Planes& end, std::uint32_t first, std::int32_t direction, std::uint32_t count,
              const Progress& progress)
    {
        const std::uint32_t support = texton_.coefficients.width;
        Planes coefficients = padded(core_, end, support, scale_);
        for (std::uint32_t i = 0; i < count; ++i) {
            const auto step =
                static_cast<std::uint32_t>(static_cast<std::int32_t>(first) + direction * static_cast<std::int32_t>(i));
            if (i > 0)
                improve(coefficients, step,
                        progress.part((i - 1.0) / (count - 1), static_cast<double>(i) / (count - 1)));
            float* to = texton_.coefficients.plane(std::size_t{step} * end.count);
            for (std::size_t k = 0; k < coefficients.values.size(); ++k)
                to[k] = static_cast<float>(static_cast<double>(coefficients.values[k]) / scale_);
        }
    }

private:
    void improve(Planes& coefficients, std::uint32_t step, const Progress& progress)
    {
        const Target target = path_.at(static_cast<double>(step) / (texton_.images - 1));
        if (!(target.power() > 0)) return;
        Projection projection(core_, target.spectra, samples_, coefficients.width);
        if (!(projection.measure(coefficients).power > 0)) projection.start(0, coefficients); // the end is constant
        fit_coefficients(core_, projection, {iterations, true, false}, target, samples_, coefficients, progress);
        correct_colours(core_, samples_, target.covariance, coefficients);
    }

    Core& core_;
    const Path& path_;
    const SplineSamples& samples_;
    double scale_;
    Texton& texton_;
};

} // namespace

Model mix_textons(Core& core, const Model& a, const Model& b, std::uint32_t steps, const Progress& progress)
{
    check(a, b, steps);
    progress.at(0);
    const Planes &u = a.texton.coefficients, &v = b.texton.coefficients;
    const std::uint32_t support = std::max({u.width, u.height, v.width, v.height}), channels = a.channels;
    const double scale = common_scale(u, v);
    const SplineSamples samples = spline_samples(a.texton.taps);

    Model model;
    model.method = WEFT_METHOD_TEXTON;
    model.channels = channels;
    model.mean = a.mean;
    Texton& texton = model.texton;
    texton.images = steps;
    texton.taps = a.texton.taps;
    texton.means = Array<float>(&core.memory, std::size_t{steps} * channels);
    for (std::uint32_t i = 0; i < steps; ++i)
        for (std::uint32_t c = 0; c < channels; ++c) {
            const double begin = static_cast<double>(a.mean[c]), end = static_cast<double>(b.mean[c]);
            texton.means[std::size_t{i} * channels + c] =
                i + 1 == steps ? b.mean[c] : static_cast<float>(begin + i * (end - begin) / (steps - 1));
        }
    texton.coefficients = Planes(&core.memory, support, support, channels * steps);
    const Path path(core, a, b, support, scale, samples);
    Steps walker(core, path, samples, scale, texton);
    const std::uint32_t half = (steps + 1) / 2;
    const double middle = static_cast<double>(half) / steps;
    walker.walk(u, 0, 1, half, progress.part(0, middle));
    walker.walk(v, steps - 1, -1, steps - half, progress.part(middle, 1));
    check_model(model);
    progress.at(1);
    return model;
}

} // namespace weft
