/// weft_analyze_*: photo -> model.
#include "analysis/bilayer.h"
#include "analysis/texton.h"
#include "analysis/wavelet.h"
#include "api/guard.h"
#include "api/model.h"
#include "api/options.h"
#include "base/image.h"

using namespace weft;

weft_status weft_analyze_texton(weft_context* context, const weft_image* photo, const weft_texton_options* given,
                                weft_progress progress, void* user, weft_model** model) noexcept
{
    constexpr char function[] = "weft_analyze_texton";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        require(model, function, ": model is NULL");
        check_image(photo, function, "photo");
        const auto options = read_options(given, function, "options");
        check_zero(options.zero, function, "options");
        *model = make_model(*context, analyze_texton(*context->core, *photo, options, Progress(progress, user)));
    });
}

weft_status weft_analyze_wavelet(weft_context* context, const weft_image* photo, const weft_wavelet_options* given,
                                 weft_progress progress, void* user, weft_model** model) noexcept
{
    constexpr char function[] = "weft_analyze_wavelet";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        require(model, function, ": model is NULL");
        check_image(photo, function, "photo");
        const auto options = read_options(given, function, "options");
        *model = make_model(*context, analyze_wavelet(*context->core, *photo, options, Progress(progress, user)));
    });
}

weft_status weft_analyze_bilayer(weft_context* context, const weft_image* photo, const weft_bilayer_options* given,
                                 weft_progress progress, void* user, weft_model** model) noexcept
{
    constexpr char function[] = "weft_analyze_bilayer";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        require(model, function, ": model is NULL");
        check_image(photo, function, "photo");
        const auto options = read_options(given, function, "options");
        *model = make_model(*context, analyze_bilayer(*context->core, *photo, options, Progress(progress, user)));
    });
}

weft_status weft_analyze_picture(weft_context* context, const weft_image* picture, weft_model** model) noexcept
{
    constexpr char function[] = "weft_analyze_picture";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        require(model, function, ": model is NULL");
        check_image(picture, function, "picture");
        require(picture->width <= most_side && picture->height <= most_side, function,
                ": picture->width and ->height are ", picture->width, " x ", picture->height,
                ", not within 16384 x 16384");
        Core& core = *context->core;
        Model made;
        made.method = WEFT_METHOD_PICTURE;
        made.channels = picture->channels;
        made.picture = read_image(*picture, &core.memory, core.parallel, function, "picture");
        *model = make_model(*context, std::move(made));
    });
}
