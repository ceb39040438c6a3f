/// Stationary tiles: photo -> model, other maps by its correspondence, and the two costs.
#include "analysis/stationarity_cost.h"
#include "analysis/stationarization.h"
#include "analysis/texture_cost.h"
#include "api/guard.h"
#include "api/model.h"
#include "api/options.h"
#include "base/image.h"

using namespace weft;

namespace {

constexpr std::uint32_t least_tile = 64, most_tile = 2048, most_photo = 8192;

void check_sigma(float sigma, const char* function)
{
    require(sigma >= 0.02F && sigma <= 1, function, ": options->sigma is ", sigma, ", not 0.02..1");
}

void check_moments(std::uint32_t moments, const char* function)
{
    require(moments >= 1 && moments <= 4, function, ": options->moments is ", moments, ", not 1..4");
}

template <class Number> void fill_in(Number& field, Number otherwise) noexcept
{
    if (field == Number{}) field = otherwise;
}

weft_stationary_options complete(weft_stationary_options options, const char* function)
{
    fill_in(options.width, 256U);
    fill_in(options.height, 256U);
    fill_in(options.stationarity, weft_stationarity{WEFT_STATIONARITY_HISTOGRAM});
    fill_in(options.moments, 2U);
    fill_in(options.sigma, 0.1F);
    fill_in(options.patch, 11U);
    fill_in(options.start, 4U);
    for (const std::uint32_t side : {options.width, options.height})
        require(side >= least_tile && side <= most_tile, function, ": options->width and ->height are ", options.width,
                " x ", options.height, ", not ", least_tile, "..", most_tile, " a side");
    require(options.stationarity >= WEFT_STATIONARITY_HISTOGRAM && options.stationarity <= WEFT_STATIONARITY_NONE,
            function, ": options->stationarity is ", options.stationarity, ", not 0..4");
    check_moments(options.moments, function);
    check_sigma(options.sigma, function);
    require(options.patch >= 3 && options.patch <= most_patch && options.patch % 2 == 1, function,
            ": options->patch is ", options.patch, ", not odd in 3..", most_patch);
    require(options.start >= 2 && options.start <= 16, function, ": options->start is ", options.start, ", not 2..16");
    if (options.sigma_map) {
        check_image(options.sigma_map, function, "options->sigma_map");
        require(options.sigma_map->channels == 1, function, ": options->sigma_map->channels is ",
                options.sigma_map->channels, ", not 1");
    }
    return options;
}

void check_photo(const weft_image& photo, std::uint32_t patch, const char* function)
{
    require(photo.width >= patch && photo.height >= patch, function, ": photo is ", photo.width, " x ", photo.height,
            " pixels, smaller than a patch of ", patch, " x ", patch);
    require(photo.width <= most_photo && photo.height <= most_photo, function, ": photo is ", photo.width, " x ",
            photo.height, " pixels, more than ", most_photo, " a side");
}

weft_stationarity_options complete(weft_stationarity_options options, const char* function)
{
    fill_in(options.stationarity, weft_stationarity{WEFT_STATIONARITY_HISTOGRAM});
    fill_in(options.sigma, 0.1F);
    fill_in(options.moments, 2U);
    require(options.stationarity >= WEFT_STATIONARITY_HISTOGRAM && options.stationarity <= WEFT_STATIONARITY_STEERABLE,
            function, ": options->stationarity is ", options.stationarity, ", not 0..3");
    check_sigma(options.sigma, function);
    check_moments(options.moments, function);
    return options;
}

void check_map(const weft_image* map, const weft_image& image, const char* function)
{
    if (!map) return;
    check_image(map, function, "map");
    require(map->format == WEFT_FORMAT_F32, function, ": map->format is ", map->format, ", not WEFT_FORMAT_F32");
    require(map->channels == 1, function, ": map->channels is ", map->channels, ", not 1");
    require(map->width <= image.width && map->height <= image.height, function, ": map is ", map->width, " x ",
            map->height, ", the image is ", image.width, " x ", image.height);
}

weft_texture_cost_options complete(weft_texture_cost_options options, const char* function)
{
    check_zero(options.zero, function, "options");
    fill_in(options.patch, 11U);
    fill_in(options.samples, 256U);
    require(options.patch <= most_patch, function, ": options->patch is ", options.patch, ", not 1..", most_patch);
    require(options.samples <= 1U << 20, function, ": options->samples is ", options.samples, ", more than 2^20");
    return options;
}

} // namespace

weft_status weft_analyze_stationary(weft_context* context, const weft_image* photo,
                                    const weft_stationary_options* given, weft_progress progress, void* user,
                                    weft_model** model) noexcept
{
    constexpr char function[] = "weft_analyze_stationary";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        require(model, function, ": model is NULL");
        check_image(photo, function, "photo");
        const auto options = complete(read_options(given, function, "options"), function);
        check_photo(*photo, options.patch, function);
        Stationary_tile tile = stationarize(*context->core, *photo, options, Progress(progress, user));
        Model made;
        made.method = WEFT_METHOD_STATIONARY;
        made.channels = photo->channels;
        made.picture = std::move(tile.tile);
        made.correspondence = std::move(tile.origin);
        *model = make_model(*context, std::move(made));
    });
}

weft_status weft_model_apply(const weft_model* model, const weft_image* map, const weft_image* tile) noexcept
{
    constexpr char function[] = "weft_model_apply";
    return guard(function, [&] {
        require(model, function, ": model is NULL");
        check_image(map, function, "map");
        check_image(tile, function, "tile");
        const Model& known = model->loaded.object->model;
        if (known.method != WEFT_METHOD_STATIONARY)
            throw Error(WEFT_ERROR_UNSUPPORTED, function, ": the model is no stationary tile");
        const Correspondence& from = known.correspondence;
        require(map->width == from.photo_width && map->height == from.photo_height, function, ": map is ", map->width,
                " x ", map->height, ", the photo was ", from.photo_width, " x ", from.photo_height);
        require(tile->width == known.picture.width && tile->height == known.picture.height, function, ": tile is ",
                tile->width, " x ", tile->height, ", the model's is ", known.picture.width, " x ",
                known.picture.height);
        require(tile->channels == map->channels, function, ": tile->channels is ", tile->channels, ", the map has ",
                map->channels);
        Core& core = *model->core;
        const Planes planes = read_image(*map, &core.memory, core.parallel, function, "map");
        const Planes made = assemble(planes, from, tile->width, tile->height, &core.memory, core.parallel);
        write_window(*tile, 0, 0, made.width, made.height, made.plane(0), made.width, made.height);
    });
}

weft_status weft_stationarity_cost(weft_context* context, const weft_image* image,
                                   const weft_stationarity_options* given, weft_progress progress, void* user,
                                   const weft_image* map, float* cost) noexcept
{
    constexpr char function[] = "weft_stationarity_cost";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        check_image(image, function, "image");
        require(image->width >= 8 && image->height >= 8, function, ": image is ", image->width, " x ", image->height,
                " pixels, less than 8 a side");
        const auto options = complete(read_options(given, function, "options"), function);
        check_map(map, *image, function);
        require(cost, function, ": cost is NULL");
        *cost = stationarity_cost(*context->core, *image, options, Progress(progress, user), map);
    });
}

weft_status weft_texture_cost(weft_context* context, const weft_image* exemplar, const weft_image* output,
                              const weft_texture_cost_options* given, weft_progress progress, void* user,
                              float* cost) noexcept
{
    constexpr char function[] = "weft_texture_cost";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        check_image(exemplar, function, "exemplar");
        check_image(output, function, "output");
        require(exemplar->channels == output->channels, function, ": output->channels is ", output->channels,
                ", the exemplar has ", exemplar->channels);
        const auto options = complete(read_options(given, function, "options"), function);
        for (const weft_image* image : {exemplar, output})
            require(image->width >= options.patch && image->height >= options.patch, function, ": ",
                    image == exemplar ? "exemplar" : "output", " is ", image->width, " x ", image->height,
                    " pixels, smaller than a patch of ", options.patch, " x ", options.patch);
        require(cost, function, ": cost is NULL");
        *cost = texture_cost(*context->core, *exemplar, *output, options, Progress(progress, user));
    });
}
