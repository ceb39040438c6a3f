/// weft_texture_*.
#include "api/guard.h"
#include "api/handles.h"
#include "api/options.h"
#include "base/image.h"

using namespace weft;

weft_status weft_texture_create(weft_context* context, const weft_model* model, const weft_texture_options* given,
                                weft_texture** texture) noexcept
{
    constexpr char function[] = "weft_texture_create";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        require(model, function, ": model is NULL");
        require(texture, function, ": texture is NULL");
        const Model& known = model->loaded.object->model;
        const auto asked = read_options(given, function, "options");
        check_zero(asked.zero, function, "options");
        const auto options = complete_options(known, asked);
        auto made = make_in<Texture>(context->core, *context->core, *context->device.object, known, options);
        *texture = make_handle<weft_texture>(context->core, context->device, model->loaded,
                                             In_core<const Texture>{made.core, made.object});
    });
}

weft_status weft_texture_render(const weft_texture* texture, int64_t x, int64_t y, uint32_t level,
                                weft_progress progress, void* user, const weft_image* image) noexcept
{
    constexpr char function[] = "weft_texture_render";
    return guard(function, [&] {
        require(texture, function, ": texture is NULL");
        check_image(image, function, "image");
        texture->texture.object->render(x, y, level, Progress(progress, user), *image);
    });
}

weft_status weft_texture_sample(const weft_texture* texture, size_t count, const weft_point* points,
                                float* out) noexcept
{
    constexpr char function[] = "weft_texture_sample";
    return guard(function, [&] {
        require(texture, function, ": texture is NULL");
        texture->texture.object->sample(count, points, out);
    });
}

weft_status weft_texture_sample_surface(const weft_texture* texture, size_t count, const weft_surface_point* points,
                                        float* out) noexcept
{
    constexpr char function[] = "weft_texture_sample_surface";
    return guard(function, [&] {
        require(texture, function, ": texture is NULL");
        texture->texture.object->sample_surface(count, points, out);
    });
}

weft_status weft_texture_sample_solid(const weft_texture* texture, size_t count, const weft_solid_point* points,
                                      float* out) noexcept
{
    constexpr char function[] = "weft_texture_sample_solid";
    return guard(function, [&] {
        require(texture, function, ": texture is NULL");
        texture->texture.object->sample_solid(count, points, out);
    });
}

void weft_texture_free(weft_texture* texture) noexcept { free_handle(texture); }
