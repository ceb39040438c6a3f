/// The parameters of wavelet noise, in and out of models.
#include "api/guard.h"
#include "api/model.h"
#include "api/options.h"

using namespace weft;

namespace {

/// The rows of one table that are used, the rest being 0.
void copy_rows(const float (*from)[16], float (*to)[16], std::uint32_t rows, std::uint32_t channels) noexcept
{
    for (std::uint32_t i = 0; i < rows; ++i) std::copy_n(from[i], channels, to[i]);
}

template <class From, class To> void copy_tables(const From& from, To& to, std::uint32_t channels) noexcept
{
    to.bands = from.bands;
    to.knots = from.knots;
    copy_rows(from.axes, to.axes, channels, channels);
    copy_rows(from.weight, to.weight, from.bands, channels);
    copy_rows(from.knot_x, to.knot_x, from.knots, channels);
    copy_rows(from.knot_y, to.knot_y, from.knots, channels);
    copy_rows(from.knot_slope, to.knot_slope, from.knots, channels);
}

} // namespace

weft_status weft_model_get_wavelet(const weft_model* model, weft_wavelet* wavelet) noexcept
{
    constexpr char function[] = "weft_model_get_wavelet";
    return guard(function, [&] {
        require(model, function, ": model is NULL");
        const std::uint32_t size = checked_size(wavelet, function, "wavelet");
        const Model& known = model->loaded.object->model;
        if (known.method != WEFT_METHOD_WAVELET)
            throw Error(WEFT_ERROR_UNSUPPORTED, function, ": the model is no wavelet noise");
        weft_wavelet result{};
        result.channels = known.channels;
        std::copy_n(known.mean.begin(), known.channels, result.mean);
        copy_tables(known.wavelet, result, known.channels);
        write_info(result, wavelet, size);
    });
}

weft_status weft_model_from_wavelet(weft_context* context, const weft_wavelet* given, weft_model** model) noexcept
{
    constexpr char function[] = "weft_model_from_wavelet";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        require(given, function, ": wavelet is NULL");
        require(model, function, ": model is NULL");
        const auto wavelet = read_options(given, function, "wavelet");
        require(wavelet.channels >= 1 && wavelet.channels <= most_channels, function, ": wavelet->channels is ",
                wavelet.channels, ", not 1..16");
        require(wavelet.bands >= 1 && wavelet.bands <= most_bands, function, ": wavelet->bands is ", wavelet.bands,
                ", not 1..16");
        require(wavelet.knots <= most_knots, function, ": wavelet->knots is ", wavelet.knots, ", neither 0 nor 2..32");
        Model made;
        made.method = WEFT_METHOD_WAVELET;
        made.channels = wavelet.channels;
        std::copy_n(wavelet.mean, wavelet.channels, made.mean.begin());
        copy_tables(wavelet, made.wavelet, wavelet.channels);
        check_model(made, WEFT_ERROR_ARGUMENT);
        *model = make_model(*context, std::move(made));
    });
}
