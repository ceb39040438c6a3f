/// The wavelet noise of a photo: mean, principal axes, tone curves, weights of bands (paper, sections 4 and 5).
#include "analysis/wavelet.h"
#include "analysis/band_power.h"
#include "analysis/principal_axes.h"
#include "analysis/statistics.h"
#include "analysis/tone_curve.h"
#include "base/image.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr const char* function = "weft_analyze_wavelet";
constexpr std::uint32_t least_side = 8, most_photo_side = 8192, default_knots = 10;
constexpr double rank_tolerance = 1e-10; // of an axis's variance: float's rounding, squared, is below

struct Choices {
    std::uint32_t bands, knots;
};

Choices choose(const weft_image& photo, const weft_wavelet_options& options)
{
    for (const std::uint32_t side : {photo.width, photo.height})
        require(side >= least_side && side <= most_photo_side, function, ": photo is ", photo.width, " x ",
                photo.height, " pixels, not ", least_side, "..", most_photo_side, " a side");
    require(options.bands <= most_bands, function, ": options->bands is ", options.bands, ", not 0..", most_bands);
    require(options.tone_knots == 0 || (options.tone_knots >= 2 && options.tone_knots <= most_knots), function,
            ": options->tone_knots is ", options.tone_knots, ", neither 0 nor 2..", most_knots);
    require(options.gaussian <= 1, function, ": options->gaussian is ", options.gaussian, ", neither 0 nor 1");
    return {options.bands ? options.bands : octaves_in(photo.width, photo.height), options.gaussian ? 0
                                                                                   : options.tone_knots
                                                                                       ? options.tone_knots
                                                                                       : default_knots};
}

/// The axis's deviation, and that of the noise before its tone curve: as much, but within bounds in which no
/// coefficient of the curve leaves those of a model.
struct Deviations {
    double texture, noise;
};

/// `plane`, the photo along the axis, is given up; its unit is the photo's divided by `scale`.
void learn_axis(Core& core, Planes& plane, const Band_shares& shares, Deviations deviations, double scale,
                std::uint32_t axis, Wavelet& wavelet)
{
    if (wavelet.knots > 0) {
        const Normal_scores scores(core, plane.plane(0), plane.area());
        fit_tone_curve(scores, scale, deviations.noise, deviations.texture, axis, wavelet);
        scores.apply(core, plane.plane(0), plane.area(), 1);
    }
    double power[most_bands], total = 0;
    solve_bands(shares, octaves_of(core, plane, shares.count), power);
    for (const double value : power) total += value;
    if (!(total > 0)) power[shares.count - 1] = total = 1; // all of it was jumps at the borders
    for (std::uint32_t b = 0; b < shares.count; ++b)
        wavelet.weight[b][axis] = static_cast<float>(deviations.noise * std::sqrt(power[b] / total));
}

} // namespace

Model analyze_wavelet(Core& core, const weft_image& photo, const weft_wavelet_options& options,
                      const Progress& progress)
{
    const Choices choices = choose(photo, options);
    progress.at(0);
    Planes planes = read_image(photo, &core.memory, core.parallel, function, "photo");
    progress.at(0.1);
    const Centring centring = centre(core, planes);
    progress.at(0.2);
    const Principal_axes principal = principal_axes_of(core, planes);
    progress.at(0.25);
    const Band_shares shares = band_shares(std::min(choices.bands, octaves_in(photo.width, photo.height)));

    Model model;
    model.method = WEFT_METHOD_WAVELET;
    model.channels = photo.channels;
    model.wavelet.bands = choices.bands;
    model.wavelet.knots = choices.knots;
    Planes plane(&core.memory, photo.width, photo.height, 1);
    for (std::uint32_t p = 0; p < photo.channels; ++p) {
        model.mean[p] = static_cast<float>(centring.mean[p]);
        for (std::uint32_t o = 0; o < photo.channels; ++o)
            model.wavelet.axes[p][o] = static_cast<float>(principal.axes[p][o]);
        set_flat_tone_curve(p, model.wavelet);
        const double deviation = std::sqrt(principal.variance[p]) / centring.scale;
        if (principal.variance[p] > rank_tolerance * principal.variance[0] && deviation > 1e-36) {
            project_on_axis(core, planes, principal.axes, p, plane.plane(0));
            const double noise = choices.knots > 0 ? std::clamp(deviation, 1e-3, 1e3) : deviation;
            learn_axis(core, plane, shares, {deviation, noise}, centring.scale, p, model.wavelet);
        }
        progress.at(0.25 + 0.74 * (p + 1) / photo.channels);
    }
    check_model(model);
    progress.at(1);
    return model;
}

} // namespace weft
