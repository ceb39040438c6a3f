/// weft_autocovariance: by Wiener and Khinchin, with room enough around the picture that no lag wraps into another.
#include "analysis/measures.h"
#include "analysis/statistics.h"
#include "base/image.h"
#include <algorithm>

namespace weft {
namespace {

/// `lags` <- the mean products at its lags; `padded` and `spectra` are room to work in.
void correlate(const PlaneTransform& transform, const float* plane, std::uint32_t width, std::uint32_t height,
               double scale, Planes& padded, Spectra& spectra, Planes& lags, std::uint32_t channel)
{
    std::fill(padded.values.begin(), padded.values.end(), 0.0f);
    for (std::size_t y = 0; y < height; ++y) std::copy_n(plane + y * width, width, padded.row(0, y));
    transform.forward(padded.plane(0), spectra, 0);
    for (Complex& value : spectra.values) value = std::norm(value);
    transform.backward(spectra, 0, padded.plane(0));
    const double unit = 1 / (scale * scale * static_cast<double>(padded.area()));
    for (std::uint32_t y = 0; y < lags.height; ++y)
        for (std::uint32_t x = 0; x < lags.width; ++x) {
            const std::int64_t lag_x = std::int64_t{x} - lags.width / 2, lag_y = std::int64_t{y} - lags.height / 2;
            const auto row = static_cast<std::size_t>((lag_y + padded.height) % padded.height);
            const float sum = padded.row(0, row)[(lag_x + padded.width) % padded.width];
            const double pairs =
                static_cast<double>(width - std::abs(lag_x)) * static_cast<double>(height - std::abs(lag_y));
            lags.row(channel, y)[x] = static_cast<float>(static_cast<double>(sum) * unit / pairs);
        }
}

} // namespace

void autocovariance(Core& core, const weft_image& image, const weft_image& covariance)
{
    Planes planes = read_image(image, &core.memory, core.parallel, "weft_autocovariance", "image");
    const Centring centring = centre(core, planes);
    Planes padded(&core.memory, fast_length(image.width + covariance.width / 2),
                  fast_length(image.height + covariance.height / 2), 1);
    Spectra spectra(&core.memory, padded.width, padded.height, 1);
    const PlaneTransform transform(core, padded.width, padded.height);
    Planes lags(&core.memory, covariance.width, covariance.height, covariance.channels);
    for (std::uint32_t c = 0; c < image.channels; ++c)
        correlate(transform, planes.plane(c), image.width, image.height, centring.scale, padded, spectra, lags, c);
    write_window(covariance, 0, 0, lags.width, lags.height, lags.values.data(), lags.width, lags.height);
}

} // namespace weft
