/// Sections in the order of FORMAT.md; each one's size is compared with what is left before anything is allocated.
#include "model/file_bilayer.h"

namespace weft {

namespace {

constexpr std::uint64_t head_size = 64, noise_head = 16;
constexpr std::uint64_t most_items = 1U << 28; ///< of a table, so that no product of sizes overflows

std::uint64_t whole_words(std::uint64_t bytes) noexcept { return (bytes + 3) / 4 * 4; }

/// Room for `count` items of `bytes` each must follow.
void expect(const Reader& reader, std::uint64_t count, std::uint64_t bytes, const char* what)
{
    if (count > most_items || count * bytes > reader.remaining())
        throw Error(WEFT_ERROR_FORMAT, "BILA has ", reader.remaining(), " bytes left for ", count, " ", what);
}

std::int32_t i32(Reader& reader) { return static_cast<std::int32_t>(reader.u32()); }
void i32(Writer& to, std::int32_t value) { to.u32(static_cast<std::uint32_t>(value)); }

Planes read_planes(Reader& reader, std::pmr::memory_resource* memory, std::uint32_t width, std::uint32_t height,
                   std::uint32_t count, const char* what)
{
    if (width < 1 || width > most_side || height < 1 || height > most_side || count < 1 || count > 64)
        throw Error(WEFT_ERROR_FORMAT, "BILA has ", count, " planes of ", width, " x ", height, " ", what);
    expect(reader, std::uint64_t{width} * height * count, 4, what);
    Planes planes(memory, width, height, count, Array<float>::unset);
    reader.floats(planes.values.data(), planes.values.size());
    return planes;
}

template <class Item>
Array<Item> read_bytes(Reader& reader, std::pmr::memory_resource* memory, std::uint64_t count, const char* what)
{
    static_assert(sizeof(Item) == 1);
    expect(reader, whole_words(count), 1, what);
    Array<Item> items(memory, static_cast<std::size_t>(count), Array<Item>::unset);
    const unsigned char* from = reader.take(whole_words(count));
    if (count > 0) std::memcpy(items.data(), from, static_cast<std::size_t>(count));
    for (std::uint64_t i = count; i < whole_words(count); ++i)
        if (from[i] != 0) throw Error(WEFT_ERROR_FORMAT, "BILA's padding after its ", what, " is not zero");
    return items;
}

template <class Item> void write_bytes(Writer& to, const Array<Item>& items)
{
    to.raw(items.data(), items.size());
    for (std::uint64_t i = items.size(); i < whole_words(items.size()); ++i) *to.skip(1) = 0;
}

void read_wang(Reader& reader, std::pmr::memory_resource* memory, Wang& wang)
{
    if (wang.colours > most_wang_colours || wang.knots > 254)
        throw Error(WEFT_ERROR_FORMAT, "BILA has ", wang.colours, " colours and contours of ", wang.knots,
                    " intervals");
    const std::uint32_t diamonds = 2 * wang.colours;
    expect(reader, diamonds, 8, "diamonds");
    wang.diamonds = Array<Wang::Diamond>(memory, diamonds);
    for (Wang::Diamond& at : wang.diamonds) {
        at.x = i32(reader);
        at.y = i32(reader);
    }
    wang.contours = read_bytes<std::int8_t>(
        reader, memory, std::uint64_t{4} * wang.colours * wang.colours * (wang.knots + 1), "contours of Wang tiles");
}

void read_exchange(Reader& reader, std::pmr::memory_resource* memory, Exchange& exchange, std::uint32_t entries,
                   std::uint32_t patches, std::uint32_t contents)
{
    expect(reader, entries, 4, "entries of the map");
    exchange.map = Array<std::uint32_t>(memory, entries, Array<std::uint32_t>::unset);
    for (std::uint32_t& entry : exchange.map) entry = reader.u32();
    expect(reader, patches, 16, "patches");
    exchange.patches = Array<Exchange::Patch>(memory, patches);
    for (Exchange::Patch& patch : exchange.patches) {
        patch.x = i32(reader);
        patch.y = i32(reader);
        patch.first = reader.u32();
        patch.count = reader.u32();
    }
    expect(reader, contents, 16, "contents");
    exchange.contents = Array<Exchange::Content>(memory, contents);
    for (Exchange::Content& content : exchange.contents) {
        content.x = i32(reader);
        content.y = i32(reader);
        content.turn = reader.u32();
        content.scale = reader.f32();
    }
    exchange.contours = read_bytes<std::uint8_t>(reader, memory, std::uint64_t{contents} * contour_knots, "contours");
}

/// Rows of `channels` floats each.
template <class Any_noise, class Row> void for_each_row(Any_noise& noise, std::uint32_t channels, const Row& row)
{
    row(noise.mean);
    for (std::uint32_t p = 0; p < channels; ++p) row(noise.axes[p]);
    for (auto* knots : {noise.knot_x, noise.knot_y, noise.knot_slope})
        for (std::uint32_t k = 0; k < noise.knots; ++k) row(knots[k]);
}

void read_noise(Reader& reader, std::pmr::memory_resource* memory, std::uint32_t channels, Noise& noise)
{
    const std::uint32_t width = reader.u32(), height = reader.u32();
    noise.knots = reader.u32();
    if (reader.u32() != 0) throw Error(WEFT_ERROR_FORMAT, "BILA's reserved field of a noise is not zero");
    if (noise.knots > most_knots) throw Error(WEFT_ERROR_FORMAT, "BILA has a noise of ", noise.knots, " knots");
    for_each_row(noise, channels, [&](float* row) { reader.floats(row, channels); });
    noise.coefficients = read_planes(reader, memory, width, height, channels, "of a texton");
}

} // namespace

std::uint64_t bilayer_length(const Model& model) noexcept
{
    const Bilayer& bilayer = model.bilayer;
    const Exchange& exchange = bilayer.exchange;
    std::uint64_t size = head_size + std::uint64_t{bilayer.structure.values.size()} * 4 +
                         bilayer.wang.diamonds.size() * 8 + whole_words(bilayer.wang.contours.size()) +
                         std::uint64_t{exchange.map.size()} * 4 + exchange.patches.size() * 16 +
                         exchange.contents.size() * 16 + whole_words(exchange.contours.size()) +
                         std::uint64_t{bilayer.residual.values.size()} * 4;
    if (!bilayer.residual.values.empty()) size += 8;
    for (const Noise& noise : bilayer.noises)
        size += noise_head + (std::uint64_t{noise.coefficients.values.size()} +
                              (1 + model.channels + 3 * std::uint64_t{noise.knots}) * model.channels) *
                                 4;
    return size;
}

void read_bilayer(Reader& reader, std::pmr::memory_resource* memory, Model& model)
{
    if (model.method != WEFT_METHOD_BILAYER || !model.bilayer.noises.empty())
        throw Error(WEFT_ERROR_FORMAT, "a chunk BILA is not of the model's method, or is the second");
    Bilayer& bilayer = model.bilayer;
    const std::uint32_t width = reader.u32(), height = reader.u32(), noises = reader.u32();
    bilayer.plain = reader.u32();
    bilayer.turns = reader.u32();
    bilayer.least_scale = reader.f32();
    bilayer.turbulence = reader.f32();
    bilayer.wavelength = reader.f32();
    for (std::uint32_t* number :
         {&bilayer.wang.colours, &bilayer.wang.width, &bilayer.wang.height, &bilayer.wang.knots})
        *number = reader.u32();
    const std::uint32_t entries = reader.u32(), patches = reader.u32(), contents = reader.u32();
    const std::uint32_t residual = reader.u32();
    if (noises < 1 || noises > most_noises || bilayer.plain > 1 || residual > 1)
        throw Error(WEFT_ERROR_FORMAT, "BILA has ", noises, " noises, structure of kind ", bilayer.plain,
                    " and noise layer ", residual);
    const std::uint32_t first = bilayer.plain != 0 ? 0 : model.channels;
    bilayer.structure = read_planes(reader, memory, width, height, first + noises, "of structure");
    read_wang(reader, memory, bilayer.wang);
    read_exchange(reader, memory, bilayer.exchange, entries, patches, contents);
    bilayer.noises.resize(noises);
    for (Noise& noise : bilayer.noises) read_noise(reader, memory, model.channels, noise);
    if (residual != 0) {
        const std::uint32_t residual_width = reader.u32(), residual_height = reader.u32();
        bilayer.residual = read_planes(reader, memory, residual_width, residual_height, model.channels, "of noise");
    }
    if (reader.remaining() != 0) throw Error(WEFT_ERROR_FORMAT, reader.remaining(), " bytes follow in BILA");
}

void write_bilayer(Writer& to, const Model& model)
{
    const Bilayer& bilayer = model.bilayer;
    const Exchange& exchange = bilayer.exchange;
    for (const std::uint32_t number : {bilayer.structure.width, bilayer.structure.height,
                                       static_cast<std::uint32_t>(bilayer.noises.size()), bilayer.plain, bilayer.turns})
        to.u32(number);
    for (const float number : {bilayer.least_scale, bilayer.turbulence, bilayer.wavelength}) to.f32(number);
    const Wang& wang = bilayer.wang;
    for (const std::size_t number : {std::size_t{wang.colours}, std::size_t{wang.width}, std::size_t{wang.height},
                                     std::size_t{wang.knots}, exchange.map.size(), exchange.patches.size(),
                                     exchange.contents.size(), std::size_t{bilayer.residual.values.empty() ? 0U : 1U}})
        to.u32(static_cast<std::uint32_t>(number));
    to.floats(bilayer.structure.values.data(), bilayer.structure.values.size());
    for (const Wang::Diamond& at : wang.diamonds) {
        i32(to, at.x);
        i32(to, at.y);
    }
    write_bytes(to, wang.contours);
    for (const std::uint32_t entry : exchange.map) to.u32(entry);
    for (const Exchange::Patch& patch : exchange.patches) {
        i32(to, patch.x);
        i32(to, patch.y);
        to.u32(patch.first);
        to.u32(patch.count);
    }
    for (const Exchange::Content& content : exchange.contents) {
        i32(to, content.x);
        i32(to, content.y);
        to.u32(content.turn);
        to.f32(content.scale);
    }
    write_bytes(to, exchange.contours);
    for (const Noise& noise : bilayer.noises) {
        const Planes& alpha = noise.coefficients;
        for (const std::uint32_t number : {alpha.width, alpha.height, noise.knots, 0U}) to.u32(number);
        for_each_row(noise, model.channels, [&](const float* row) { to.floats(row, model.channels); });
        to.floats(alpha.values.data(), alpha.values.size());
    }
    if (bilayer.residual.values.empty()) return;
    to.u32(bilayer.residual.width);
    to.u32(bilayer.residual.height);
    to.floats(bilayer.residual.values.data(), bilayer.residual.values.size());
}

} // namespace weft
