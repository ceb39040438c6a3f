/// weft_model_*: bytes, information, parts.
#include "api/model.h"
#include "api/guard.h"
#include "api/options.h"
#include "base/image.h"
#include "model/file.h"
#include "model/parts.h"
#include "model/texton_text.h"
#include <algorithm>

using namespace weft;

namespace {

/// What info tells the size of: a picture, a tile, a texton, or a structure layer.
const Planes& planes_of(const Model& model) noexcept
{
    return model.method == WEFT_METHOD_TEXTON    ? model.texton.coefficients
           : model.method == WEFT_METHOD_BILAYER ? model.bilayer.structure
                                                 : model.picture;
}

weft_model_info info_of(const Loaded_model& loaded)
{
    const Model& model = loaded.model;
    const Planes& planes = planes_of(model);
    weft_model_info info{};
    info.method = model.method;
    info.channels = model.channels;
    info.parts = count_parts(model);
    info.bytes = size_of_file(model);
    info.width = planes.width;
    info.height = planes.height;
    info.photo_width = model.correspondence.photo_width;
    info.photo_height = model.correspondence.photo_height;
    const bool texton = model.method == WEFT_METHOD_TEXTON;
    info.model_error = texton ? model.texton.model_error : -1.0F;
    info.interpolation = texton ? static_cast<weft_interpolation>(model.texton.taps) : WEFT_INTERPOLATION_DEFAULT;
    std::copy(loaded.statistics.mean.begin(), loaded.statistics.mean.end(), info.mean);
    std::copy(loaded.statistics.deviation.begin(), loaded.statistics.deviation.end(), info.deviation);
    return info;
}

Part checked_part(const weft_model* handle, uint32_t index, const char* function)
{
    require(handle, function, ": model is NULL");
    const Model& model = handle->loaded.object->model;
    const std::uint32_t parts = count_parts(model);
    require(index < parts, function, ": index is ", index, ", the model has ", parts, parts == 1 ? " part" : " parts");
    return part_of(model, index, &handle->core->memory);
}

} // namespace

weft_status weft_model_load(weft_context* context, const void* bytes, size_t size, weft_model** model) noexcept
{
    constexpr char function[] = "weft_model_load";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        require(bytes, function, ": bytes is NULL");
        require(model, function, ": model is NULL");
        *model =
            make_model(*context, read_model(&context->core->memory, static_cast<const unsigned char*>(bytes), size));
    });
}

weft_status weft_model_save(const weft_model* model, void* bytes, size_t size) noexcept
{
    constexpr char function[] = "weft_model_save";
    return guard(function, [&] {
        require(model, function, ": model is NULL");
        require(bytes, function, ": bytes is NULL");
        const std::uint64_t needed = size_of_file(model->loaded.object->model);
        require(size == needed, function, ": size is ", size, ", the model has ", needed, " bytes");
        write_model(model->loaded.object->model, static_cast<unsigned char*>(bytes), size);
    });
}

weft_status weft_model_load_texton(weft_context* context, const char* text, size_t size, weft_model** model) noexcept
{
    constexpr char function[] = "weft_model_load_texton";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        require(text, function, ": text is NULL");
        require(model, function, ": model is NULL");
        Model read = read_texton_text(*context->core, text, size);
        check_model(read);
        *model = make_model(*context, std::move(read));
    });
}

weft_status weft_model_save_texton(const weft_model* model, char* text, size_t size, size_t* length) noexcept
{
    constexpr char function[] = "weft_model_save_texton";
    return guard(function, [&] {
        require(model, function, ": model is NULL");
        require(length, function, ": length is NULL");
        require(text || size == 0, function, ": text is NULL, but size is ", size);
        const std::size_t needed = write_texton_text(model->loaded.object->model, text, size);
        require(!text || needed <= size, function, ": size is ", size, ", the text has ", needed, " bytes");
        *length = needed;
    });
}

weft_status weft_model_get(const weft_model* model, weft_model_info* info) noexcept
{
    constexpr char function[] = "weft_model_get";
    return guard(function, [&] {
        require(model, function, ": model is NULL");
        const std::uint32_t size = checked_size(info, function, "info");
        write_info(info_of(*model->loaded.object), info, size);
    });
}

weft_status weft_model_part(const weft_model* model, uint32_t index, weft_part_info* info) noexcept
{
    constexpr char function[] = "weft_model_part";
    return guard(function, [&] {
        const Part part = checked_part(model, index, function);
        const std::uint32_t size = checked_size(info, function, "info");
        weft_part_info result{};
        std::copy_n(part.name, sizeof part.name, result.name);
        result.width = part.width;
        result.height = part.height;
        result.channels = part.channels;
        const auto [low, high] = std::minmax_element(part.values, part.values + part.count());
        result.low = *low;
        result.high = *high;
        write_info(result, info, size);
    });
}

weft_status weft_model_part_read(const weft_model* model, uint32_t index, const weft_image* image) noexcept
{
    constexpr char function[] = "weft_model_part_read";
    return guard(function, [&] {
        const Part part = checked_part(model, index, function);
        check_image(image, function, "image");
        require(image->format == WEFT_FORMAT_F32, function, ": image->format is ", image->format,
                ", not WEFT_FORMAT_F32");
        require(image->channels == part.channels, function, ": image->channels is ", image->channels, ", the part has ",
                part.channels);
        require(image->width == part.width && image->height == part.height, function, ": image is ", image->width,
                " x ", image->height, ", the part is ", part.width, " x ", part.height);
        write_window(*image, 0, 0, part.width, part.height, part.values, part.width, part.height);
    });
}

void weft_model_free(weft_model* model) noexcept { free_handle(model); }
