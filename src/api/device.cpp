/// weft_device_count, weft_device_get, weft_backend_load.
#include "api/guard.h"
#include "api/options.h"
#include "backend/registry.h"

using namespace weft;

weft_status weft_device_count(uint32_t* count) noexcept
{
    constexpr char function[] = "weft_device_count";
    return guard(function, [&] {
        require(count, function, ": count is NULL");
        *count = Registry::instance().device_count();
    });
}

weft_status weft_device_get(uint32_t index, weft_device_info* info) noexcept
{
    constexpr char function[] = "weft_device_get";
    return guard(function, [&] {
        const std::uint32_t size = checked_size(info, function, "info");
        write_info(Registry::instance().device(index), info, size);
    });
}

weft_status weft_backend_load(const char* path) noexcept
{
    constexpr char function[] = "weft_backend_load";
    return guard(function, [&] {
        require(path, function, ": path is NULL");
        Registry::instance().load(path);
    });
}
