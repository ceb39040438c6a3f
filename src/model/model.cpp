/// The invariants of a model.
#include "model/model.h"
#include "base/error.h"
#include "base/finite.h"
#include "model/tone.h"
#include <cmath>

namespace weft {

namespace {

bool all_finite(const float* values, std::size_t count) noexcept { return all_below(values, count, two_to_64_bits); }

/// What a broken rule is answered with.
class Rules {
public:
    explicit Rules(weft_status broken) noexcept : broken_(broken) {}
    template <class... Parts> void demand(bool good, const Parts&... parts) const
    {
        if (!good) throw Error(broken_, parts...);
    }

    void planes(const Planes& planes, std::uint32_t channels, const char* what) const
    {
        demand(planes.width >= 1 && planes.width <= most_side, "the ", what, "'s width is ", planes.width, ", not 1..",
               most_side);
        demand(planes.height >= 1 && planes.height <= most_side, "the ", what, "'s height is ", planes.height,
               ", not 1..", most_side);
        demand(planes.count == channels, "the ", what, " has ", planes.count, " channels, the model has ", channels);
        demand(planes.values.size() == planes.area() * planes.count, "the ", what, " has ", planes.values.size(),
               " values");
        demand(all_finite(planes.values.data(), planes.values.size()), "the ", what,
               " has a value that is not finite, or beyond 2^64");
    }

    void texton(const Model& model) const
    {
        const Texton& texton = model.texton;
        demand(texton.images >= 1 && texton.images <= most_images, "the texton has ", texton.images, " steps, not 1..",
               most_images);
        planes(texton.coefficients, model.channels * texton.images, "texton");
        demand(texton.taps == 1 || texton.taps == 2 || texton.taps == 4 || texton.taps == 6, "the texton's taps are ",
               texton.taps, ", not 1, 2, 4 or 6");
        demand(all_finite(&texton.model_error, 1) && (texton.model_error >= 0 || texton.model_error == -1.0F),
               "the texton's model error is ", texton.model_error, ", neither -1 nor 0 or more");
        demand(texton.means.size() == (texton.images > 1 ? std::size_t{texton.images} * model.channels : 0),
               "the texton has ", texton.means.size(), " means");
        demand(all_finite(texton.means.data(), texton.means.size()), "a step's mean is not finite, or beyond 2^64");
        for (std::uint32_t c = 0; texton.images > 1 && c < model.channels; ++c)
            demand(texton.means[c] == model.mean[c], "the first step's mean is ", texton.means[c], ", the model's is ",
                   model.mean[c]);
    }

    void axes(const Colour_axes& colours, std::uint32_t channels) const
    {
        for (std::uint32_t p = 0; p < channels; ++p)
            for (std::uint32_t q = 0; q <= p; ++q) {
                double product = 0;
                for (std::uint32_t o = 0; o < channels; ++o)
                    product += static_cast<double>(colours.axes[p][o]) * static_cast<double>(colours.axes[q][o]);
                demand(std::abs(product - (p == q ? 1 : 0)) <= 1e-3, "axes ", p, " and ", q, " have the product ",
                       product, p == q ? ", not 1" : ", not 0");
            }
    }

    void tone(const Colour_axes& colours, std::uint32_t axis) const
    {
        for (std::uint32_t k = 0; k < colours.knots; ++k) {
            demand(colours.knot_slope[k][axis] >= 0, "knot_slope[", k, "][", axis, "] is ", colours.knot_slope[k][axis],
                   ", below 0");
            if (k == 0) continue;
            demand(colours.knot_x[k - 1][axis] < colours.knot_x[k][axis], "knot_x[", k, "][", axis, "] is ",
                   colours.knot_x[k][axis], ", not above the knot before");
            demand(colours.knot_y[k - 1][axis] <= colours.knot_y[k][axis], "knot_y[", k, "][", axis, "] is ",
                   colours.knot_y[k][axis], ", below the knot before");
            const Tone_piece piece = tone_piece(colours, axis, k - 1);
            demand(all_finite(&piece.c0, 4), "the tone curve of axis ", axis, " is too steep at knot ", k - 1);
        }
    }

    /// Only the used parts of the arrays are looked at.
    void wavelet(const Model& model) const
    {
        const Wavelet& wavelet = model.wavelet;
        demand(wavelet.bands >= 1 && wavelet.bands <= most_bands, "the model has ", wavelet.bands, " bands, not 1..",
               most_bands);
        demand(wavelet.knots == 0 || (wavelet.knots >= 2 && wavelet.knots <= most_knots), "the model has ",
               wavelet.knots, " knots, neither 0 nor 2..", most_knots);
        rows(wavelet.axes, model.channels, model.channels, "axes");
        rows(wavelet.weight, wavelet.bands, model.channels, "weight");
        rows(wavelet.knot_x, wavelet.knots, model.channels, "knot_x");
        rows(wavelet.knot_y, wavelet.knots, model.channels, "knot_y");
        rows(wavelet.knot_slope, wavelet.knots, model.channels, "knot_slope");
        for (std::uint32_t b = 0; b < wavelet.bands; ++b)
            for (std::uint32_t p = 0; p < model.channels; ++p)
                demand(wavelet.weight[b][p] >= 0, "weight[", b, "][", p, "] is ", wavelet.weight[b][p], ", below 0");
        axes(wavelet, model.channels);
        for (std::uint32_t p = 0; p < model.channels; ++p) tone(wavelet, p);
    }

private:
    void rows(const float (*values)[16], std::uint32_t count, std::uint32_t channels, const char* name) const
    {
        for (std::uint32_t i = 0; i < count; ++i)
            demand(all_finite(values[i], channels), name, "[", i, "] has a number that is not finite, or beyond 2^64");
    }

    weft_status broken_;
};

} // namespace

void check_model(const Model& model, weft_status broken)
{
    const Rules rules(broken);
    rules.demand(model.channels >= 1 && model.channels <= most_channels, "the model has ", model.channels,
                 " channels, not 1..16");
    rules.demand(all_finite(model.mean.data(), model.channels), "the model's mean is not finite, or beyond 2^64");
    for (std::uint32_t c = model.channels; c < most_channels; ++c)
        rules.demand(model.mean[c] == 0, "the model has a mean beyond its channels");
    rules.demand(model.method == WEFT_METHOD_TEXTON || model.texton.coefficients.values.empty(),
                 "the model has a texton, but another method");
    rules.demand(model.method == WEFT_METHOD_PICTURE || model.picture.values.empty(),
                 "the model has a picture, but another method");
    switch (model.method) {
    case WEFT_METHOD_TEXTON:
        return rules.texton(model);
    case WEFT_METHOD_WAVELET:
        return rules.wavelet(model);
    case WEFT_METHOD_PICTURE:
        for (const float mean : model.mean) rules.demand(mean == 0, "a picture's model has a mean");
        return rules.planes(model.picture, model.channels, "picture");
    default:
        throw Error(WEFT_ERROR_UNSUPPORTED, "method ", model.method, " is not known to this libweft");
    }
}

} // namespace weft
