/// Model -> bytes, in the one order there is.
#include "base/bytes.h"
#include "base/crc32c.h"
#include "model/file.h"
#include "model/file_layout.h"

namespace weft {

namespace {

const Planes& planes_of(const Model& model) noexcept
{
    return model.method == WEFT_METHOD_TEXTON ? model.texton.coefficients : model.picture;
}

std::uint64_t method_length(const Model& model) noexcept { return file::meth_head + std::uint64_t{model.channels} * 4; }

std::uint64_t layer_length(const Model& model) noexcept
{
    const std::uint64_t head = model.method == WEFT_METHOD_TEXTON ? file::splt_head : file::tile_head;
    return head + std::uint64_t{planes_of(model).values.size()} * 4;
}

void write_header(Writer& file, std::uint64_t size)
{
    unsigned char* begin = file.skip(file::header_size);
    Writer writer(begin, file::header_size);
    writer.raw(file::magic, sizeof file::magic);
    writer.u16(file::major);
    writer.u16(file::minor);
    writer.u32(2);
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

} // namespace

std::uint64_t size_of_file(const Model& model) noexcept
{
    return file::header_size + 2 * file::chunk_header_size + file::padded(method_length(model)) +
           file::padded(layer_length(model));
}

void write_model(const Model& model, unsigned char* bytes, std::size_t size)
{
    Writer file(bytes, size);
    write_header(file, size);
    write_chunk(file, file::meth, method_length(model), [&](Writer& to) {
        to.u32(static_cast<std::uint32_t>(model.method));
        to.u32(model.channels);
        to.u32(1);
        to.u32(0);
        to.floats(model.mean.data(), model.channels);
    });
    const Planes& planes = planes_of(model);
    const bool texton = model.method == WEFT_METHOD_TEXTON;
    write_chunk(file, texton ? file::splt : file::tile, layer_length(model), [&](Writer& to) {
        to.u32(planes.width);
        to.u32(planes.height);
        to.u32(planes.count);
        if (texton) {
            to.u32(1);
            to.u32(model.texton.taps);
            to.f32(model.texton.model_error);
            to.u32(0);
        }
        to.u32(0);
        to.floats(planes.values.data(), planes.values.size());
    });
}

} // namespace weft
