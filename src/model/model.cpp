/// The invariants of a model.
#include "model/model.h"
#include "model/rules.h"

namespace weft {

namespace {

void check_texton(const Model& model, const Rules& rules)
{
    const Texton& texton = model.texton;
    rules.demand(texton.images >= 1 && texton.images <= most_images, "the texton has ", texton.images,
                 " steps, not 1..", most_images);
    rules.planes(texton.coefficients, model.channels * texton.images, "texton");
    rules.demand(texton.taps == 1 || texton.taps == 2 || texton.taps == 4 || texton.taps == 6, "the texton's taps are ",
                 texton.taps, ", not 1, 2, 4 or 6");
    rules.demand(Rules::all_finite(&texton.model_error, 1) && (texton.model_error >= 0 || texton.model_error == -1.0F),
                 "the texton's model error is ", texton.model_error, ", neither -1 nor 0 or more");
    rules.demand(texton.means.size() == (texton.images > 1 ? std::size_t{texton.images} * model.channels : 0),
                 "the texton has ", texton.means.size(), " means");
    rules.demand(Rules::all_finite(texton.means.data(), texton.means.size()),
                 "a step's mean is not finite, or beyond 2^64");
    for (std::uint32_t c = 0; texton.images > 1 && c < model.channels; ++c)
        rules.demand(texton.means[c] == model.mean[c], "the first step's mean is ", texton.means[c],
                     ", the model's is ", model.mean[c]);
}

void check_wavelet(const Model& model, const Rules& rules)
{
    const Wavelet& wavelet = model.wavelet;
    rules.demand(wavelet.bands >= 1 && wavelet.bands <= most_bands, "the model has ", wavelet.bands, " bands, not 1..",
                 most_bands);
    rules.rows(wavelet.weight, wavelet.bands, model.channels, "weight");
    for (std::uint32_t b = 0; b < wavelet.bands; ++b)
        for (std::uint32_t p = 0; p < model.channels; ++p)
            rules.demand(wavelet.weight[b][p] >= 0, "weight[", b, "][", p, "] is ", wavelet.weight[b][p], ", below 0");
    rules.colours(wavelet, model.channels);
}

} // namespace

void check_model(const Model& model, weft_status broken)
{
    const Rules rules(broken);
    rules.demand(model.channels >= 1 && model.channels <= most_channels, "the model has ", model.channels,
                 " channels, not 1..16");
    rules.demand(Rules::all_finite(model.mean.data(), model.channels),
                 "the model's mean is not finite, or beyond 2^64");
    for (std::uint32_t c = model.channels; c < most_channels; ++c)
        rules.demand(model.mean[c] == 0, "the model has a mean beyond its channels");
    rules.demand(model.method == WEFT_METHOD_TEXTON || model.texton.coefficients.values.empty(),
                 "the model has a texton, but another method");
    rules.demand(model.method == WEFT_METHOD_PICTURE || model.picture.values.empty(),
                 "the model has a picture, but another method");
    rules.demand(model.method == WEFT_METHOD_BILAYER || model.bilayer.noises.empty(),
                 "the model has noises under masks, but another method");
    switch (model.method) {
    case WEFT_METHOD_TEXTON:
        return check_texton(model, rules);
    case WEFT_METHOD_WAVELET:
        return check_wavelet(model, rules);
    case WEFT_METHOD_BILAYER:
        return check_bilayer(model, rules);
    case WEFT_METHOD_PICTURE:
        for (const float mean : model.mean) rules.demand(mean == 0, "a picture's model has a mean");
        return rules.planes(model.picture, model.channels, "picture");
    default:
        throw Error(WEFT_ERROR_UNSUPPORTED, "method ", model.method, " is not known to this libweft");
    }
}

} // namespace weft
