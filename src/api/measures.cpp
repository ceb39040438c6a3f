/// weft_power_spectrum, weft_autocovariance, weft_histogram, weft_compare.
#include "analysis/measures.h"
#include "analysis/compare.h"
#include "api/guard.h"
#include "api/handles.h"
#include "api/options.h"
#include "base/image.h"
#include <cmath>

using namespace weft;

namespace {

/// A picture of numbers, one for each pair of frequencies or lags, no larger than the image that it is made from.
void check_result(const weft_image* image, const weft_image* result, const char* function, const char* argument)
{
    check_image(image, function, "image");
    check_image(result, function, argument);
    require(result->format == WEFT_FORMAT_F32, function, ": ", argument, "->format is ", result->format,
            ", not WEFT_FORMAT_F32");
    require(result->channels == image->channels, function, ": ", argument, "->channels is ", result->channels,
            ", the image has ", image->channels);
    require(result->width <= image->width && result->height <= image->height, function, ": ", argument,
            "->width and ->height are ", result->width, " x ", result->height, ", the image is ", image->width, " x ",
            image->height);
}

} // namespace

weft_status weft_power_spectrum(weft_context* context, const weft_image* image, const weft_image* spectrum) noexcept
{
    constexpr char function[] = "weft_power_spectrum";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        check_result(image, spectrum, function, "spectrum");
        power_spectrum(*context->core, *image, *spectrum);
    });
}

weft_status weft_autocovariance(weft_context* context, const weft_image* image, const weft_image* covariance) noexcept
{
    constexpr char function[] = "weft_autocovariance";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        check_result(image, covariance, function, "autocovariance");
        autocovariance(*context->core, *image, *covariance);
    });
}

weft_status weft_histogram(weft_context* context, const weft_image* image, float low, float high, uint32_t bins,
                           uint64_t* counts) noexcept
{
    constexpr char function[] = "weft_histogram";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        check_image(image, function, "image");
        require(std::isfinite(low) && std::isfinite(high) && low < high, function, ": low is ", low, " and high is ",
                high, ", not finite and ascending");
        require(bins >= 1 && bins <= 65536, function, ": bins is ", bins, ", not 1..65536");
        require(counts, function, ": counts is NULL");
        histogram(*context->core, *image, low, high, bins, counts);
    });
}

weft_status weft_compare(weft_context* context, const weft_image* exemplar, const weft_image* output,
                         const weft_compare_options* given, weft_progress progress, void* user,
                         weft_comparison* comparison) noexcept
{
    constexpr char function[] = "weft_compare";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        check_image(exemplar, function, "exemplar");
        check_image(output, function, "output");
        require(exemplar->channels == output->channels, function, ": output->channels is ", output->channels,
                ", the exemplar has ", exemplar->channels);
        for (const weft_image* image : {exemplar, output})
            require(image->width >= 16 && image->height >= 16, function, ": ",
                    image == exemplar ? "exemplar" : "output", "->width and ->height are ", image->width, " x ",
                    image->height, ", less than 16 x 16");
        const auto options = read_options(given, function, "options");
        check_zero(options.zero, function, "options");
        const std::uint32_t size = checked_size(comparison, function, "comparison");
        weft_comparison result{};
        result.size = sizeof result;
        compare(*context->core, *exemplar, *output, options, Progress(progress, user), result);
        write_info(result, comparison, size);
    });
}
