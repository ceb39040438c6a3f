/// Planes of floats into the caller's interleaved pixels.
#include "base/image.h"
#include <cstring>

namespace weft {

namespace {

/// Rounded to nearest (ties to even) and clamped; NaN gives 0. Adding 2^23 leaves the integer in the low bits: no
/// conversion, so the loops around it vectorise without any instruction set beyond the baseline.
inline std::uint32_t rounded(float value, float most) noexcept
{
    float v = value * most;
    v = v > 0.0F ? v : 0.0F;
    v = v < most ? v : most;
    v += 8388608.0F;
    std::uint32_t bits;
    std::memcpy(&bits, &v, sizeof bits);
    return bits - UINT32_C(0x4b000000);
}

template <class Value> Value converted(float value, float most) noexcept
{
    if constexpr (std::is_same_v<Value, float>)
        return value;
    else
        return static_cast<Value>(rounded(value, most));
}

/// Any number of channels. `Channels` 0: not known before.
template <class Value, std::uint32_t Channels>
void write_row(char* to, const float* from, std::size_t plane, std::uint32_t width, std::uint32_t channels, float most) noexcept
{
    const std::uint32_t n = Channels ? Channels : channels;
    auto* values = reinterpret_cast<Value*>(to);
    if constexpr (Channels != 0) {
        for (std::uint32_t x = 0; x < width; ++x)
            for (std::uint32_t c = 0; c < Channels; ++c) values[std::size_t{x} * Channels + c] = converted<Value>(from[c * plane + x], most);
    } else {
        for (std::uint32_t c = 0; c < n; ++c)
            for (std::uint32_t x = 0; x < width; ++x) values[std::size_t{x} * n + c] = converted<Value>(from[c * plane + x], most);
    }
}

/// Three channels of bytes or of 16 bits: pixels are put together in words, which are stored one over the last one's
/// unused end. The row's last pixel is written value by value, so nothing beyond it is touched.
template <class Value, class Word>
void write_row_of_three(char* to, const float* from, std::size_t plane, std::uint32_t width, float most) noexcept
{
    constexpr std::uint32_t block = 128;
    constexpr unsigned bits = 8 * sizeof(Value);
    const std::uint32_t whole = width - 1;
    Word words[block];
    for (std::uint32_t begin = 0; begin < whole; begin += block) {
        const std::uint32_t count = whole - begin < block ? whole - begin : block;
        const float *r = from + begin, *g = r + plane, *b = g + plane;
        for (std::uint32_t i = 0; i < count; ++i)
            words[i] = rounded(r[i], most) | static_cast<Word>(rounded(g[i], most)) << bits | static_cast<Word>(rounded(b[i], most)) << 2 * bits;
        char* pixel = to + std::size_t{begin} * 3 * sizeof(Value);
        for (std::uint32_t i = 0; i < count; ++i) std::memcpy(pixel + std::size_t{i} * 3 * sizeof(Value), &words[i], sizeof(Word));
    }
    write_row<Value, 3>(to + std::size_t{whole} * 3 * sizeof(Value), from + whole, plane, 1, 3, most);
}

constexpr bool little_endian = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__;

template <class Value> void write_values(char* to, const float* from, std::size_t plane, std::uint32_t width, std::uint32_t channels) noexcept
{
    constexpr float most = sizeof(Value) == 1 ? 255.0F : 65535.0F;
    if constexpr (!std::is_same_v<Value, float> && little_endian) {
        using Word = std::conditional_t<sizeof(Value) == 1, std::uint32_t, std::uint64_t>;
        if (channels == 3) return write_row_of_three<Value, Word>(to, from, plane, width, most);
    }
    switch (channels) {
    case 1: return write_row<Value, 1>(to, from, plane, width, 1, most);
    case 3: return write_row<Value, 3>(to, from, plane, width, 3, most);
    case 4: return write_row<Value, 4>(to, from, plane, width, 4, most);
    default: return write_row<Value, 0>(to, from, plane, width, channels, most);
    }
}

} // namespace

void write_window(const weft_image& image, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t rows, const float* source,
                  std::size_t stride, std::size_t plane_rows) noexcept
{
    const std::size_t plane = plane_rows * stride;
    const std::size_t pixel = image.channels * bytes_per_value(image.format);
    for (std::uint32_t j = 0; j < rows; ++j) {
        char* to = static_cast<char*>(image.data) + static_cast<std::int64_t>(y + j) * stride_of(image) + x * pixel;
        const float* from = source + j * stride;
        if (image.format == WEFT_FORMAT_U8)
            write_values<std::uint8_t>(to, from, plane, width, image.channels);
        else if (image.format == WEFT_FORMAT_U16)
            write_values<std::uint16_t>(to, from, plane, width, image.channels);
        else
            write_values<float>(to, from, plane, width, image.channels);
    }
}

} // namespace weft
