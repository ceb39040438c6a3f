/// The numbers of FORMAT.md that reader and writer share.
#pragma once
#include <cstdint>
#include <weft/weft.h>

namespace weft::file {

constexpr unsigned char magic[8] = {0x89, 'W', 'E', 'F', 'T', '\r', '\n', 0x1a};
constexpr std::uint16_t major = 1, minor = 0;
constexpr std::uint32_t header_size = 32, chunk_header_size = 24;
constexpr std::uint32_t most_chunks = 64, most_layers = 32;
constexpr std::uint32_t ignorable = 1; ///< bit of a chunk's flags

constexpr std::uint32_t kind(char a, char b, char c, char d)
{
    return static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b) << 8 | static_cast<std::uint32_t>(c) << 16 |
           static_cast<std::uint32_t>(d) << 24;
}
constexpr std::uint32_t meth = kind('M', 'E', 'T', 'H'), splt = kind('S', 'P', 'L', 'T'),
                        band = kind('B', 'A', 'N', 'D'), tile = kind('T', 'I', 'L', 'E'),
                        bila = kind('B', 'I', 'L', 'A'), corr = kind('C', 'O', 'R', 'R');

constexpr std::uint32_t meth_head = 16, splt_head = 32, band_head = 16, tile_head = 16,
                        corr_head = 32; ///< bytes of the payload before its values

/// Chunks that follow METH.
constexpr std::uint32_t layers_of(weft_method method) { return method == WEFT_METHOD_STATIONARY ? 2 : 1; }

constexpr std::uint64_t padded(std::uint64_t length) { return (length + 7) / 8 * 8; }

} // namespace weft::file
