/// Model -> bytes, in the one order there is.
#include "base/bytes.h"
#include "base/crc32c.h"
#include "model/file.h"
#include "model/file_bilayer.h"
#include "model/file_layout.h"

namespace weft {

namespace {

std::uint64_t method_length(const Model& model) noexcept { return file::meth_head + std::uint64_t{model.channels} * 4; }

std::uint64_t layer_length(const Model& model) noexcept
{
    const std::uint64_t channels = model.channels;
    const Wavelet& wavelet = model.wavelet;
    switch (model.method) {
    case WEFT_METHOD_TEXTON:
        return file::splt_head +
               (std::uint64_t{model.texton.means.size()} + model.texton.coefficients.values.size()) * 4;
    case WEFT_METHOD_WAVELET:
        return file::band_head + (channels + wavelet.bands + 3 * std::uint64_t{wavelet.knots}) * channels * 4;
    case WEFT_METHOD_BILAYER:
        return bilayer_length(model);
    default:
        return file::tile_head + std::uint64_t{model.picture.values.size()} * 4;
    }
}

std::uint64_t correspondence_length(const Model& model) noexcept
{
    return file::corr_head + std::uint64_t{model.correspondence.x.size()} * 4;
}

void write_header(Writer& file, const Model& model, std::uint64_t size)
{
    unsigned char* begin = file.skip(file::header_size);
    Writer writer(begin, file::header_size);
    writer.raw(file::magic, sizeof file::magic);
    writer.u16(file::major);
    writer.u16(file::minor);
    writer.u32(1 + file::layers_of(model.method));
    writer.u64(size);
    writer.u32(0);
    writer.u32(crc32c(begin, file::header_size - 4));
}

template <class Fill> void write_chunk(Writer& file, std::uint32_t kind, std::uint64_t length, const Fill& fill)
{
    const auto size = static_cast<std::size_t>(length);
    unsigned char* begin = file.skip(file::chunk_header_size);
    unsigned char* bytes = file.skip(size);
    Writer payload(bytes, size);
    fill(payload);
    if (payload.remaining() != 0) throw Error(WEFT_ERROR_INTERNAL, "a chunk's size was computed wrongly");
    Writer writer(begin, file::chunk_header_size);
    writer.u32(kind);
    writer.u32(0);
    writer.u64(length);
    writer.u32(crc32c(bytes, size, crc32c(begin, 16)));
    writer.u32(0);
    for (std::uint64_t pad = file::padded(length) - length; pad > 0; --pad) *file.skip(1) = 0;
}

void write_splat(Writer& to, const Model& model)
{
    const Texton& texton = model.texton;
    const Planes& planes = texton.coefficients;
    for (const std::uint32_t number : {planes.width, planes.height, model.channels, texton.images, texton.taps})
        to.u32(number);
    to.f32(texton.model_error);
    to.u32(0);
    to.u32(0);
    to.floats(texton.means.data(), texton.means.size());
    to.floats(planes.values.data(), planes.values.size());
}

void write_bands(Writer& to, const Model& model)
{
    const Wavelet& wavelet = model.wavelet;
    for (const std::uint32_t number : {wavelet.bands, wavelet.knots, model.channels, 0U}) to.u32(number);
    const auto write = [&](const float(*values)[16], std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i) to.floats(values[i], model.channels);
    };
    write(wavelet.axes, model.channels);
    write(wavelet.weight, wavelet.bands);
    write(wavelet.knot_x, wavelet.knots);
    write(wavelet.knot_y, wavelet.knots);
    write(wavelet.knot_slope, wavelet.knots);
}

void write_tile(Writer& to, const Model& model)
{
    const Planes& planes = model.picture;
    for (const std::uint32_t number : {planes.width, planes.height, planes.count, 0U}) to.u32(number);
    to.floats(planes.values.data(), planes.values.size());
}

void write_correspondence(Writer& to, const Model& model)
{
    const Correspondence& from = model.correspondence;
    for (const std::uint32_t number :
         {model.picture.width, model.picture.height, from.photo_width, from.photo_height, from.patch, 0U, 0U, 0U})
        to.u32(number);
    for (const Array<std::uint16_t>* places : {&from.x, &from.y})
        for (const std::uint16_t place : *places) to.u16(place);
}

} // namespace

std::uint64_t size_of_file(const Model& model) noexcept
{
    std::uint64_t size = file::header_size + 2 * file::chunk_header_size + file::padded(method_length(model)) +
                         file::padded(layer_length(model));
    if (model.method == WEFT_METHOD_STATIONARY)
        size += file::chunk_header_size + file::padded(correspondence_length(model));
    return size;
}

void write_model(const Model& model, unsigned char* bytes, std::size_t size)
{
    Writer file(bytes, size);
    write_header(file, model, size);
    write_chunk(file, file::meth, method_length(model), [&](Writer& to) {
        to.u32(static_cast<std::uint32_t>(model.method));
        to.u32(model.channels);
        to.u32(file::layers_of(model.method));
        to.u32(0);
        to.floats(model.mean.data(), model.channels);
    });
    const std::uint64_t length = layer_length(model);
    switch (model.method) {
    case WEFT_METHOD_TEXTON:
        return write_chunk(file, file::splt, length, [&](Writer& to) { write_splat(to, model); });
    case WEFT_METHOD_WAVELET:
        return write_chunk(file, file::band, length, [&](Writer& to) { write_bands(to, model); });
    case WEFT_METHOD_BILAYER:
        return write_chunk(file, file::bila, length, [&](Writer& to) { write_bilayer(to, model); });
    default:
        write_chunk(file, file::tile, length, [&](Writer& to) { write_tile(to, model); });
    }
    if (model.method == WEFT_METHOD_STATIONARY)
        write_chunk(file, file::corr, correspondence_length(model),
                    [&](Writer& to) { write_correspondence(to, model); });
}

} // namespace weft
