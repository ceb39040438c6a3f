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

void check_correspondence(const Model& model, const Rules& rules)
{
    const Correspondence& from = model.correspondence;
    rules.demand(from.patch >= 1 && from.patch <= most_patch && from.patch % 2 == 1, "the patches are ", from.patch,
                 " a side, not odd in 1..", most_patch);
    for (const std::uint32_t side : {from.photo_width, from.photo_height})
        rules.demand(side >= from.patch && side <= most_side, "the photo's side is ", side, ", not ", from.patch, "..",
                     most_side);
    const auto within = [&](const Array<std::uint16_t>& places, std::uint32_t side) {
        rules.demand(places.size() == model.picture.area(), "the correspondence has ", places.size(),
                     " places, the tile has ", model.picture.area(), " pixels");
        const std::uint32_t first = from.reach(), last = side - 1 - from.reach();
        for (const std::uint16_t place : places)
            rules.demand(place >= first && place <= last, "the correspondence names ", place, ", not ", first, "..",
                         last);
    };
    within(from.x, from.photo_width);
    within(from.y, from.photo_height);
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
    const bool stationary = model.method == WEFT_METHOD_STATIONARY;
    rules.demand(model.method == WEFT_METHOD_PICTURE || stationary || model.picture.values.empty(),
                 "the model has a picture, but another method");
    rules.demand(stationary || (model.correspondence.x.empty() && model.correspondence.y.empty()),
                 "the model has a correspondence, but another method");
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
    case WEFT_METHOD_STATIONARY:
        for (const float mean : model.mean) rules.demand(mean == 0, "a picture's model has a mean");
        rules.planes(model.picture, model.channels, stationary ? "tile" : "picture");
        return stationary ? check_correspondence(model, rules) : void();
    default:
        throw Error(WEFT_ERROR_UNSUPPORTED, "method ", model.method, " is not known to this libweft");
    }
}

} // namespace weft
