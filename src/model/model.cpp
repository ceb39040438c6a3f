/// The invariants of a model.
#include "model/model.h"
#include "base/error.h"
#include "base/finite.h"

namespace weft {

namespace {

bool all_finite(const float* values, std::size_t count) noexcept { return all_below(values, count, two_to_64_bits); }

template <class... Parts> void demand(bool good, const Parts&... parts)
{
    if (!good) throw Error(WEFT_ERROR_FORMAT, parts...);
}

void check_planes(const Planes& planes, std::uint32_t channels, const char* what)
{
    demand(planes.width >= 1 && planes.width <= most_side, "the ", what, "'s width is ", planes.width, ", not 1..",
           most_side);
    demand(planes.height >= 1 && planes.height <= most_side, "the ", what, "'s height is ", planes.height, ", not 1..",
           most_side);
    demand(planes.count == channels, "the ", what, " has ", planes.count, " channels, the model has ", channels);
    demand(planes.values.size() == planes.area() * planes.count, "the ", what, " has ", planes.values.size(),
           " values");
    demand(all_finite(planes.values.data(), planes.values.size()), "the ", what,
           " has a value that is not finite, or beyond 2^64");
}

} // namespace

void check_model(const Model& model)
{
    demand(model.channels >= 1 && model.channels <= most_channels, "the model has ", model.channels,
           " channels, not 1..16");
    demand(all_finite(model.mean.data(), model.channels), "the model's mean is not finite, or beyond 2^64");
    for (std::uint32_t c = model.channels; c < most_channels; ++c)
        demand(model.mean[c] == 0, "the model has a mean beyond its channels");
    if (model.method == WEFT_METHOD_TEXTON) {
        const Texton& texton = model.texton;
        check_planes(texton.coefficients, model.channels, "texton");
        demand(texton.taps == 1 || texton.taps == 2 || texton.taps == 4 || texton.taps == 6, "the texton's taps are ",
               texton.taps, ", not 1, 2, 4 or 6");
        demand(all_finite(&texton.model_error, 1) && (texton.model_error >= 0 || texton.model_error == -1.0F),
               "the texton's model error is ", texton.model_error, ", neither -1 nor 0 or more");
        demand(model.picture.values.empty(), "the model has a picture beside its texton");
    } else if (model.method == WEFT_METHOD_PICTURE) {
        check_planes(model.picture, model.channels, "picture");
        for (const float mean : model.mean) demand(mean == 0, "a picture's model has a mean");
        demand(model.texton.coefficients.values.empty(), "the model has a texton beside its picture");
    } else {
        throw Error(WEFT_ERROR_UNSUPPORTED, "method ", model.method, " is not known to this libweft");
    }
}

} // namespace weft
