/// Bytes -> model. Every field is checked before it is used, every size before anything is allocated.
#include "base/bytes.h"
#include "base/crc32c.h"
#include "model/file.h"
#include "model/file_bilayer.h"
#include "model/file_layout.h"

namespace weft {

namespace {

template <class... Parts> void demand(bool good, const Parts&... parts)
{
    if (!good) throw Error(WEFT_ERROR_FORMAT, parts...);
}

struct Header {
    std::uint16_t minor;
    std::uint32_t chunks;
};

Header read_header(Reader& file)
{
    const std::size_t size = file.remaining();
    const unsigned char* begin = file.take(file::header_size);
    Reader reader(begin, file::header_size);
    demand(std::memcmp(reader.take(sizeof file::magic), file::magic, sizeof file::magic) == 0,
           "the bytes do not begin as a model's");
    const std::uint16_t major = reader.u16();
    if (major > file::major)
        throw Error(WEFT_ERROR_UNSUPPORTED, "the model's format is ", major, ".x, this libweft reads ", file::major,
                    ".x");
    demand(major == file::major, "the model's format is ", major, ".x, which never was");
    Header header{};
    header.minor = reader.u16();
    header.chunks = reader.u32();
    const std::uint64_t file_size = reader.u64();
    const std::uint32_t zero = reader.u32();
    demand(reader.u32() == crc32c(begin, file::header_size - 4), "the header's checksum is wrong");
    demand(file_size == size, "the model has ", file_size, " bytes, ", size, " were given");
    demand(zero == 0, "the header's reserved field is ", zero);
    demand(header.chunks >= 2 && header.chunks <= file::most_chunks, "the model has ", header.chunks,
           " chunks, not 2..64");
    return header;
}

struct Chunk {
    std::uint32_t kind;
    bool ignorable;
    Reader payload;
};

Chunk read_chunk(Reader& file)
{
    const unsigned char* begin = file.take(file::chunk_header_size);
    Reader reader(begin, file::chunk_header_size);
    const std::uint32_t kind = reader.u32(), flags = reader.u32();
    const std::uint64_t length = reader.u64();
    const std::uint32_t crc = reader.u32(), zero = reader.u32();
    demand(length <= file.remaining(), "a chunk has ", length, " bytes, but only ", file.remaining(), " follow");
    const unsigned char* payload = file.take(length);
    const std::uint64_t pad = file::padded(length) - length;
    const unsigned char* padding = file.take(pad);
    for (std::uint64_t i = 0; i < pad; ++i) demand(padding[i] == 0, "a chunk's padding is not zero");
    demand(crc == crc32c(payload, static_cast<std::size_t>(length), crc32c(begin, 16)), "a chunk's checksum is wrong");
    demand(zero == 0, "a chunk's reserved field is ", zero);
    demand((flags & ~file::ignorable) == 0, "a chunk's flags are ", flags);
    return {kind, (flags & file::ignorable) != 0, Reader(payload, static_cast<std::size_t>(length))};
}

struct Method {
    std::uint32_t layers;
};

Method read_method(const Chunk& chunk, Model& model)
{
    demand(chunk.kind == file::meth && !chunk.ignorable, "the first chunk is not METH");
    Reader reader = chunk.payload;
    const std::uint32_t method = reader.u32();
    model.channels = reader.u32();
    const Method result{reader.u32()};
    const std::uint32_t flags = reader.u32();
    demand(model.channels >= 1 && model.channels <= most_channels, "the model has ", model.channels,
           " channels, not 1..16");
    demand(result.layers >= 1 && result.layers <= file::most_layers, "the model has ", result.layers,
           " layers, not 1..32");
    demand(flags == 0, "METH's flags are ", flags);
    demand(reader.remaining() == std::size_t{model.channels} * 4, "METH has ", chunk.payload.remaining(), " bytes");
    reader.floats(model.mean.data(), model.channels);
    if (method != WEFT_METHOD_TEXTON && method != WEFT_METHOD_WAVELET && method != WEFT_METHOD_BILAYER &&
        method != WEFT_METHOD_STATIONARY && method != WEFT_METHOD_PICTURE)
        throw Error(WEFT_ERROR_UNSUPPORTED, "method ", method, " is not known to this libweft");
    model.method = static_cast<weft_method>(method);
    const std::uint32_t layers = file::layers_of(model.method);
    demand(result.layers == layers, "the model has ", result.layers, " layers, its method has ", layers);
    return result;
}

/// The floats that end a chunk. Factors are bounded before they are multiplied, the product compared before allocation.
Planes read_planes(Reader& reader, std::pmr::memory_resource* memory, std::uint32_t width, std::uint32_t height,
                   std::uint32_t planes, std::uint32_t images, const Model& model)
{
    demand(width >= 1 && width <= most_side && height >= 1 && height <= most_side, "a layer has ", width, " x ", height,
           " values, not 1..", most_side, " a side");
    demand(planes == model.channels, "a layer has ", planes, " planes, the model has ", model.channels, " channels");
    const std::uint64_t bytes = std::uint64_t{width} * height * planes * images * 4;
    demand(bytes == reader.remaining(), "a layer has ", reader.remaining(), " bytes of values, its sizes say ", bytes);
    Planes result(memory, width, height, planes * images, Array<float>::unset);
    reader.floats(result.values.data(), result.values.size());
    return result;
}

void read_splat(Reader& reader, std::pmr::memory_resource* memory, Model& model)
{
    demand(model.method == WEFT_METHOD_TEXTON, "a chunk SPLT is not of the model's method");
    const std::uint32_t width = reader.u32(), height = reader.u32(), planes = reader.u32(), images = reader.u32();
    model.texton.taps = reader.u32();
    model.texton.model_error = reader.f32();
    demand(reader.u32() == 0 && reader.u32() == 0, "SPLT's reserved fields are not zero");
    demand(images >= 1 && images <= most_images, "SPLT has ", images, " images, not 1..255");
    model.texton.images = images;
    if (images > 1) {
        const std::size_t means = std::size_t{images} * model.channels;
        demand(reader.remaining() >= means * 4, "SPLT has ", reader.remaining(), " bytes for the means of ", images,
               " images");
        model.texton.means = Array<float>(memory, means, Array<float>::unset);
        reader.floats(model.texton.means.data(), means);
    }
    model.texton.coefficients = read_planes(reader, memory, width, height, planes, images, model);
}

void read_bands(Reader& reader, Model& model)
{
    demand(model.method == WEFT_METHOD_WAVELET, "a chunk BAND is not of the model's method");
    Wavelet& wavelet = model.wavelet;
    wavelet.bands = reader.u32();
    wavelet.knots = reader.u32();
    const std::uint32_t planes = reader.u32();
    demand(reader.u32() == 0, "BAND's reserved field is not zero");
    demand(planes == model.channels, "BAND has ", planes, " planes, the model has ", model.channels, " channels");
    demand(wavelet.bands >= 1 && wavelet.bands <= most_bands, "BAND has ", wavelet.bands, " bands, not 1..16");
    demand(wavelet.knots <= most_knots, "BAND has ", wavelet.knots, " knots, more than 32");
    const std::uint32_t rows = planes + wavelet.bands + 3 * wavelet.knots;
    demand(reader.remaining() == std::size_t{rows} * planes * 4, "BAND has ", reader.remaining(),
           " bytes of values, its sizes say ", std::size_t{rows} * planes * 4);
    const auto read = [&](float(*values)[16], std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i) reader.floats(values[i], planes);
    };
    read(wavelet.axes, planes);
    read(wavelet.weight, wavelet.bands);
    read(wavelet.knot_x, wavelet.knots);
    read(wavelet.knot_y, wavelet.knots);
    read(wavelet.knot_slope, wavelet.knots);
}

void read_tile(Reader& reader, std::pmr::memory_resource* memory, Model& model)
{
    demand(model.method == WEFT_METHOD_PICTURE || model.method == WEFT_METHOD_STATIONARY,
           "a chunk TILE is not of the model's method");
    demand(model.picture.values.empty(), "the model has a second TILE");
    const std::uint32_t width = reader.u32(), height = reader.u32(), planes = reader.u32();
    demand(reader.u32() == 0, "TILE's reserved field is not zero");
    model.picture = read_planes(reader, memory, width, height, planes, 1, model);
}

void read_correspondence(Reader& reader, std::pmr::memory_resource* memory, Model& model)
{
    demand(model.method == WEFT_METHOD_STATIONARY, "a chunk CORR is not of the model's method");
    Correspondence& from = model.correspondence;
    demand(!model.picture.values.empty() && from.x.empty(), "CORR does not follow a TILE, or is the second");
    const std::uint32_t width = reader.u32(), height = reader.u32();
    for (std::uint32_t* number : {&from.photo_width, &from.photo_height, &from.patch}) *number = reader.u32();
    for (int i = 0; i < 3; ++i) demand(reader.u32() == 0, "CORR's reserved fields are not zero");
    demand(width == model.picture.width && height == model.picture.height, "CORR is of ", width, " x ", height,
           " pixels, the tile of ", model.picture.width, " x ", model.picture.height);
    const std::size_t area = model.picture.area();
    demand(reader.remaining() == area * 4, "CORR has ", reader.remaining(), " bytes of values, its sizes say ",
           area * 4);
    for (Array<std::uint16_t>* places : {&from.x, &from.y}) {
        *places = Array<std::uint16_t>(memory, area, Array<std::uint16_t>::unset);
        for (std::uint16_t& place : *places) place = reader.u16();
    }
}

void read_layer(Chunk& chunk, std::pmr::memory_resource* memory, Model& model)
{
    if (chunk.kind == file::splt)
        read_splat(chunk.payload, memory, model);
    else if (chunk.kind == file::bila)
        read_bilayer(chunk.payload, memory, model);
    else if (chunk.kind == file::band)
        read_bands(chunk.payload, model);
    else if (chunk.kind == file::corr)
        read_correspondence(chunk.payload, memory, model);
    else
        read_tile(chunk.payload, memory, model);
}

[[noreturn]] void refuse_kind(std::uint32_t kind)
{
    char letters[5] = {};
    for (unsigned i = 0; i < 4; ++i) {
        const auto letter = static_cast<char>(kind >> 8 * i & 255);
        letters[i] = letter >= ' ' && letter <= '~' ? letter : '?';
    }
    throw Error(WEFT_ERROR_UNSUPPORTED, "the model has a chunk ", std::string_view(letters, 4),
                ", which this libweft does not know");
}

} // namespace

Model read_model(std::pmr::memory_resource* memory, const unsigned char* bytes, std::size_t size)
{
    Reader reader(bytes, size);
    const Header header = read_header(reader);
    Model model;
    const Method method = read_method(read_chunk(reader), model);
    std::uint32_t layers = 0;
    bool ignored = false;
    for (std::uint32_t i = 1; i < header.chunks; ++i) {
        Chunk chunk = read_chunk(reader);
        if (chunk.kind == file::meth || chunk.kind == file::splt || chunk.kind == file::band ||
            chunk.kind == file::tile || chunk.kind == file::bila || chunk.kind == file::corr) {
            demand(!chunk.ignorable && chunk.kind != file::meth, "a chunk is marked as ignorable, or is a second METH");
            demand(layers++ < method.layers, "the model has more layers than METH says");
            read_layer(chunk, memory, model);
        } else if (chunk.ignorable) {
            ignored = true;
        } else {
            refuse_kind(chunk.kind);
        }
    }
    demand(reader.remaining() == 0, reader.remaining(), " bytes follow the last chunk");
    demand(layers == method.layers, "the model has ", layers, " layers, METH says ", method.layers);
    demand(header.minor == file::minor || ignored, "the model's format is 1.", header.minor,
           ", but nothing in it is newer than 1.0");
    check_model(model);
    return model;
}

} // namespace weft
