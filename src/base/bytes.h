/// Little-endian bytes, read and written in order: bounds-checked, no offsets.
#pragma once
#include "base/error.h"
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace weft {

/// Consumes bytes; throws Error(WEFT_ERROR_FORMAT) when they run out.
class Reader {
public:
    Reader(const unsigned char* bytes, std::size_t size) noexcept : bytes_(bytes), remaining_(size) {}
    std::size_t remaining() const noexcept { return remaining_; }

    std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
    std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
    std::uint64_t u64() { return number(8); }
    float f32()
    {
        const std::uint32_t bits = u32();
        float value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    }
    const unsigned char* take(std::uint64_t count)
    {
        if (count > remaining_)
            throw Error(WEFT_ERROR_FORMAT, count, " bytes should follow, but only ", remaining_, " do");
        const unsigned char* here = bytes_;
        bytes_ += count;
        remaining_ -= static_cast<std::size_t>(count);
        return here;
    }
    void floats(float* to, std::size_t count)
    {
        const unsigned char* from = take(std::uint64_t{count} * 4);
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
        if (count) std::memcpy(to, from, count * 4);
#else
        Reader each(from, count * 4);
        for (std::size_t i = 0; i < count; ++i) to[i] = each.f32();
#endif
    }

private:
    std::uint64_t number(unsigned count)
    {
        const unsigned char* from = take(count);
        std::uint64_t value = 0;
        for (unsigned i = count; i-- > 0;) value = value << 8 | from[i];
        return value;
    }

    const unsigned char* bytes_;
    std::size_t remaining_;
};

/// Appends to a buffer whose size was computed beforehand; throws Error(WEFT_ERROR_INTERNAL) rather than run over.
class Writer {
public:
    Writer(unsigned char* bytes, std::size_t size) noexcept : bytes_(bytes), remaining_(size) {}
    std::size_t remaining() const noexcept { return remaining_; }

    void u16(std::uint16_t value) { number(value, 2); }
    void u32(std::uint32_t value) { number(value, 4); }
    void u64(std::uint64_t value) { number(value, 8); }
    void f32(float value)
    {
        std::uint32_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        u32(bits);
    }
    void raw(const void* from, std::size_t count)
    {
        unsigned char* to = skip(count);
        if (count) std::memcpy(to, from, count);
    }
    void floats(const float* from, std::size_t count)
    {
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
        raw(from, count * 4);
#else
        for (std::size_t i = 0; i < count; ++i) f32(from[i]);
#endif
    }
    /// Leaves room that is filled in later.
    unsigned char* skip(std::size_t count)
    {
        if (count > remaining_) throw Error(WEFT_ERROR_INTERNAL, "a model file's size was computed wrongly");
        unsigned char* here = bytes_;
        bytes_ += count;
        remaining_ -= count;
        return here;
    }

private:
    void number(std::uint64_t value, unsigned count)
    {
        unsigned char* to = skip(count);
        for (unsigned i = 0; i < count; ++i) to[i] = static_cast<unsigned char>(value >> 8 * i);
    }

    unsigned char* bytes_;
    std::size_t remaining_;
};

} // namespace weft
