/// CRC-32C (Castagnoli): polynomial 1edc6f41, reflected, start and final xor all ones. Of "123456789": e3069283.
#pragma once
#include <cstddef>
#include <cstdint>

namespace weft {

/// Of `bytes` behind those whose checksum is `before`.
std::uint32_t crc32c(const unsigned char* bytes, std::size_t size, std::uint32_t before = 0) noexcept;

} // namespace weft
