/* Checksums of model files (src/model/FORMAT.md), made right after a mutation. */
#include "fuzz.h"

enum { header_size = 32, chunk_header_size = 24 };

static uint32_t crc32c(uint32_t before, const uint8_t* bytes, size_t size)
{
    uint32_t crc = ~before;
    for (size_t i = 0; i < size; ++i) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) ? UINT32_C(0x82f63b78) : 0);
    }
    return ~crc;
}

static void put(uint8_t* to, uint64_t value, size_t bytes)
{
    for (size_t i = 0; i < bytes; ++i) to[i] = (uint8_t)(value >> (8 * i));
}

static uint64_t get(const uint8_t* from, size_t bytes)
{
    uint64_t value = 0;
    for (size_t i = 0; i < bytes; ++i) value |= (uint64_t)from[i] << (8 * i);
    return value;
}

void fuzz_repair(uint8_t* bytes, size_t size)
{
    if (size < header_size) return;
    put(bytes + 16, size, 8);
    put(bytes + 28, crc32c(0, bytes, 28), 4);
    size_t at = header_size;
    while (size - at >= chunk_header_size) {
        uint8_t* chunk = bytes + at;
        const uint64_t length = get(chunk + 8, 8);
        at += chunk_header_size;
        if (length > size - at) return;
        put(chunk + 16, crc32c(crc32c(0, chunk, 16), bytes + at, (size_t)length), 4);
        const uint64_t padded = (length + 7) / 8 * 8;
        if (padded > size - at) return;
        at += (size_t)padded;
    }
}
