/// Structs that begin with `size`, from callers that were compiled with an older or a newer weft.h.
#pragma once
#include "base/error.h"
#include <algorithm>
#include <cstring>

namespace weft {

/// More is no struct of any libweft, but rubbish.
template <class Struct> constexpr std::uint32_t most_struct_size = sizeof(Struct) <= 4096 ? 4096 : 16384;

template <class Struct> std::uint32_t checked_size(const Struct* given, const char* function, const char* argument)
{
    require(given, function, ": ", argument, " is NULL");
    std::uint32_t size;
    std::memcpy(&size, given, sizeof size);
    require(size >= sizeof size && size <= most_struct_size<Struct>, function, ": ", argument, "->size is ", size,
            "; start from the _INIT value");
    return size;
}

/// NULL is all defaults. Absent fields are zero; a tail that this library does not know must be.
template <class Struct> Struct read_options(const Struct* given, const char* function, const char* argument)
{
    Struct options{};
    options.size = sizeof options;
    if (!given) return options;
    const std::uint32_t size = checked_size(given, function, argument);
    const auto* bytes = reinterpret_cast<const unsigned char*>(given);
    for (std::uint32_t i = sizeof options; i < size; ++i)
        if (bytes[i] != 0)
            throw Error(WEFT_ERROR_UNSUPPORTED, function, ": ", argument, " has a field at byte ", i,
                        " that this libweft does not know");
    std::memcpy(static_cast<void*>(&options), given, std::min<std::size_t>(size, sizeof options));
    options.size = sizeof options;
    return options;
}

/// A field kept for later, which must be zero as long as it has no meaning.
inline void check_zero(std::uint32_t value, const char* function, const char* argument)
{
    if (value != 0)
        throw Error(WEFT_ERROR_UNSUPPORTED, function, ": ", argument, "->zero is ", value,
                    ", which this libweft does not know");
}

/// Fills the caller's struct as far as both know it; the rest of it becomes zero, its size stays.
template <class Struct> void write_info(const Struct& info, Struct* to, std::uint32_t size) noexcept
{
    auto* bytes = reinterpret_cast<unsigned char*>(to);
    const std::size_t known = std::min<std::size_t>(size, sizeof info);
    std::memcpy(bytes, &info, known);
    std::memset(bytes + known, 0, size - known);
    std::memcpy(bytes, &size, sizeof size);
}

} // namespace weft
