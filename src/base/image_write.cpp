/// Planes of floats into the caller's interleaved pixels: a block of pixels is rounded plane by plane, then
/// interleaved.
#include "base/image.h"
#include <algorithm>
#include <cstring>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace weft {

namespace {

constexpr std::uint32_t block = 128; ///< pixels; all channels of a block stay in the first cache

/// One plane of a block as integers: rounded to nearest (ties to even) and clamped to 0..most.
void round_values(const float* from, std::uint32_t count, float most, std::uint32_t* to) noexcept
{
    std::uint32_t i = 0;
#ifdef __SSE2__ // compilers do not turn a clamp into minps and maxps unless they may forget about NaN
    for (; i + 4 <= count; i += 4) {
        const __m128 value = _mm_mul_ps(_mm_loadu_ps(from + i), _mm_set1_ps(most));
        const __m128 clamped = _mm_min_ps(_mm_max_ps(value, _mm_setzero_ps()), _mm_set1_ps(most));
        _mm_storeu_si128(reinterpret_cast<__m128i*>(to + i), _mm_cvtps_epi32(clamped));
    }
#endif
    for (; i < count; ++i) {
        float value = from[i] * most;
        value = value > 0.0F ? value : 0.0F;
        value = (value < most ? value : most) + 8388608.0F; // the sum keeps the integer in its low bits
        std::uint32_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        to[i] = bits - UINT32_C(0x4b000000);
    }
}

using Rows = std::uint32_t[4][block];

/// Pixels as words, each stored over the unused end of the one before: so the last pixel must not be among them.
void store_three(const Rows& rows, std::uint32_t count, std::uint8_t* to) noexcept
{
    std::uint32_t words[block];
    for (std::uint32_t i = 0; i < count; ++i) words[i] = rows[0][i] | rows[1][i] << 8 | rows[2][i] << 16;
    for (std::uint32_t i = 0; i < count; ++i) std::memcpy(to + std::size_t{i} * 3, &words[i], 4);
}

void store_three(const Rows& rows, std::uint32_t count, std::uint16_t* to) noexcept
{
    std::uint32_t pairs[block];
    for (std::uint32_t i = 0; i < count; ++i) pairs[i] = rows[0][i] | rows[1][i] << 16;
    for (std::uint32_t i = 0; i < count; ++i) {
        std::memcpy(to + std::size_t{i} * 3, &pairs[i], 4);
        std::memcpy(to + std::size_t{i} * 3 + 2, &rows[2][i], 4);
    }
}

void store_four(const Rows& rows, std::uint32_t count, std::uint8_t* to) noexcept
{
    std::uint32_t words[block];
    for (std::uint32_t i = 0; i < count; ++i)
        words[i] = (rows[0][i] | rows[1][i] << 8) | (rows[2][i] << 16 | rows[3][i] << 24);
    std::memcpy(to, words, std::size_t{count} * 4);
}

void store_four(const Rows& rows, std::uint32_t count, std::uint16_t* to) noexcept
{
    std::uint32_t words[2 * block];
    for (std::uint32_t i = 0; i < count; ++i) {
        words[2 * i] = rows[0][i] | rows[1][i] << 16;
        words[2 * i + 1] = rows[2][i] | rows[3][i] << 16;
    }
    std::memcpy(to, words, std::size_t{count} * 8);
}

constexpr bool little_endian = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__;

/// One to four channels whose pixels are put together from words; the rest of the row is left.
template <class Value>
std::uint32_t write_words(Value* to, const float* from, std::size_t plane, std::uint32_t width, std::uint32_t channels,
                          float most) noexcept
{
    if (!little_endian || channels < 3 || channels > 4) return 0;
    const std::uint32_t whole = channels == 3 ? width - 1 : width;
    Rows rows;
    for (std::uint32_t x = 0; x < whole; x += block) {
        const std::uint32_t count = std::min(block, whole - x);
        for (std::uint32_t c = 0; c < channels; ++c) round_values(from + c * plane + x, count, most, rows[c]);
        if (channels == 3)
            store_three(rows, count, to + std::size_t{x} * 3);
        else
            store_four(rows, count, to + std::size_t{x} * 4);
    }
    return whole;
}

template <class Value>
void write_integers(Value* to, const float* from, std::size_t plane, std::uint32_t width,
                    std::uint32_t channels) noexcept
{
    constexpr float most = sizeof(Value) == 1 ? 255.0F : 65535.0F;
    std::uint32_t values[block];
    for (std::uint32_t x = write_words(to, from, plane, width, channels, most); x < width; x += block) {
        const std::uint32_t count = std::min(block, width - x);
        for (std::uint32_t c = 0; c < channels; ++c) {
            round_values(from + c * plane + x, count, most, values);
            Value* pixel = to + std::size_t{x} * channels + c;
            if (channels == 1)
                for (std::uint32_t i = 0; i < count; ++i) pixel[i] = static_cast<Value>(values[i]);
            else
                for (std::uint32_t i = 0; i < count; ++i)
                    pixel[std::size_t{i} * channels] = static_cast<Value>(values[i]);
        }
    }
}

template <std::uint32_t Channels>
void interleave(float* to, const float* from, std::size_t plane, std::uint32_t width) noexcept
{
    for (std::uint32_t x = 0; x < width; ++x)
        for (std::uint32_t c = 0; c < Channels; ++c) to[std::size_t{x} * Channels + c] = from[c * plane + x];
}

#ifdef __SSE2__ // compilers turn the loop into many more shuffles than it takes
/// Four pixels of three channels at a time; the rest of the row is left.
std::uint32_t interleave_three(float* to, const float* from, std::size_t plane, std::uint32_t width) noexcept
{
    std::uint32_t x = 0;
    for (; x + 4 <= width; x += 4, to += 12) {
        const __m128 a = _mm_loadu_ps(from + x), b = _mm_loadu_ps(from + plane + x);
        const __m128 c = _mm_loadu_ps(from + 2 * plane + x);
        const __m128 c0a1 = _mm_shuffle_ps(c, a, _MM_SHUFFLE(1, 1, 0, 0));
        const __m128 b1c1 = _mm_shuffle_ps(b, c, _MM_SHUFFLE(1, 1, 1, 1));
        const __m128 c2a3 = _mm_shuffle_ps(c, a, _MM_SHUFFLE(3, 3, 2, 2));
        const __m128 b3c3 = _mm_shuffle_ps(b, c, _MM_SHUFFLE(3, 3, 3, 3));
        _mm_storeu_ps(to, _mm_shuffle_ps(_mm_unpacklo_ps(a, b), c0a1, _MM_SHUFFLE(2, 0, 1, 0)));
        _mm_storeu_ps(to + 4, _mm_shuffle_ps(b1c1, _mm_unpackhi_ps(a, b), _MM_SHUFFLE(1, 0, 2, 0)));
        _mm_storeu_ps(to + 8, _mm_shuffle_ps(c2a3, b3c3, _MM_SHUFFLE(2, 0, 2, 0)));
    }
    return x;
}
#else
std::uint32_t interleave_three(float*, const float*, std::size_t, std::uint32_t) noexcept { return 0; }
#endif

void write_floats(float* to, const float* from, std::size_t plane, std::uint32_t width, std::uint32_t channels) noexcept
{
    if (channels == 1) {
        std::memcpy(to, from, std::size_t{width} * sizeof(float));
    } else if (channels == 2) {
        interleave<2>(to, from, plane, width);
    } else if (channels == 3) {
        const std::uint32_t done = interleave_three(to, from, plane, width);
        interleave<3>(to + std::size_t{done} * 3, from + done, plane, width - done);
    } else if (channels == 4) {
        interleave<4>(to, from, plane, width);
    } else {
        for (std::uint32_t begin = 0; begin < width; begin += block)
            for (std::uint32_t c = 0; c < channels; ++c)
                for (std::uint32_t x = begin; x < std::min(width, begin + block); ++x)
                    to[std::size_t{x} * channels + c] = from[c * plane + x];
    }
}

} // namespace

void write_window(const weft_image& image, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t rows,
                  const float* source, std::size_t stride, std::size_t plane_rows) noexcept
{
    const std::size_t plane = plane_rows * stride;
    const std::size_t pixel = image.channels * bytes_per_value(image.format);
    for (std::uint32_t j = 0; j < rows; ++j) {
        char* to = static_cast<char*>(image.data) + static_cast<std::int64_t>(y + j) * stride_of(image) + x * pixel;
        const float* from = source + j * stride;
        if (image.format == WEFT_FORMAT_U8)
            write_integers(reinterpret_cast<std::uint8_t*>(to), from, plane, width, image.channels);
        else if (image.format == WEFT_FORMAT_U16)
            write_integers(reinterpret_cast<std::uint16_t*>(to), from, plane, width, image.channels);
        else
            write_floats(reinterpret_cast<float*>(to), from, plane, width, image.channels);
    }
}

} // namespace weft
