/// The plug-in "opencl": its table, and the border that no exception crosses.
#include "opencl/device.h"
#include "opencl/host.h"
#include "opencl/texture.h"

struct weft_backend_device {
    const weft_host* host;
    const weft::opencl::Device* device;
    weft::opencl::Memory memory;
};

struct weft_backend_texture {
    weft_backend_texture(weft_backend_device& on, const weft_program& program)
        : device(on), texture(*on.device, program, &on.memory)
    {
    }

    weft_backend_device& device;
    weft::opencl::Texture texture;
};

namespace {

using weft::opencl::Failure;

/// Runs `work`; what it throws becomes a status, and the sentence goes to the host.
template <class Work> weft_status guarded(const weft_host* host, Work work) noexcept
{
    try {
        work();
        return WEFT_OK;
    } catch (const Failure& failure) {
        host->error(host->self, failure.what());
        return failure.status();
    } catch (const std::bad_alloc&) {
        host->error(host->self, "opencl: no memory");
        return WEFT_ERROR_MEMORY;
    } catch (const std::exception& other) {
        host->error(host->self, other.what());
        return WEFT_ERROR_DEVICE;
    }
}

template <class Object, class... Arguments> Object* make(weft::opencl::Memory& memory, Arguments&&... arguments)
{
    void* place = memory.allocate(sizeof(Object), alignof(Object));
    try {
        return new (place) Object(std::forward<Arguments>(arguments)...);
    } catch (...) {
        memory.deallocate(place, sizeof(Object), alignof(Object));
        throw;
    }
}

template <class Object> void destroy(weft::opencl::Memory memory, Object* object) noexcept
{
    object->~Object();
    memory.deallocate(object, sizeof(Object), alignof(Object));
}

std::uint32_t device_count() noexcept { return weft::opencl::device_count(); }

void device_info(std::uint32_t index, weft_device_info* info) noexcept
{
    const weft::opencl::Device& device = weft::opencl::device(index);
    info->status = device.status;
    info->exact = device.exact;
    std::memcpy(info->description, device.description, sizeof info->description);
    *std::to_chars(info->name, info->name + sizeof info->name - 1, index).ptr = '\0';
}

weft_status device_open(const weft_host* host, std::uint32_t index, weft_device_limits* limits,
                        weft_backend_device** device) noexcept
{
    return guarded(host, [&] {
        const weft::opencl::Device& opened = weft::opencl::device(index);
        if (opened.status != WEFT_OK) throw Failure(opened.status, opened.description);
        weft::opencl::Memory memory(host);
        *device = make<weft_backend_device>(memory, weft_backend_device{host, &opened, memory});
        limits->concurrency = weft::opencl::concurrency;
        // Whole bands for every number of taps; some milliseconds on two cores.
        limits->window_width = 1024;
        limits->window_height = 120;
        limits->batch = 65536;
    });
}

void device_close(weft_backend_device* device) noexcept { destroy(device->memory, device); }

weft_status texture_open(weft_backend_device* device, const weft_program* program,
                         weft_backend_texture** texture) noexcept
{
    return guarded(device->host, [&] {
        if (!weft_understands_program(program))
            throw Failure(WEFT_ERROR_UNSUPPORTED, "opencl: the program is newer than this plug-in");
        *texture = make<weft_backend_texture>(device->memory, *device, *program);
    });
}

weft_status texture_render(weft_backend_texture* texture, const weft_window* window) noexcept
{
    return guarded(texture->device.host, [&] { texture->texture.render(*window); });
}

weft_status texture_sample(weft_backend_texture* texture, const weft_batch* batch) noexcept
{
    return guarded(texture->device.host, [&] { texture->texture.sample(*batch); });
}

void texture_close(weft_backend_texture* texture) noexcept { destroy(texture->device.memory, texture); }

} // namespace

WEFT_BACKEND_EXPORT const weft_backend weft_backend_v0 = {WEFT_BACKEND_HEAD("opencl"),
                                                          device_count,
                                                          device_info,
                                                          device_open,
                                                          device_close,
                                                          texture_open,
                                                          texture_render,
                                                          texture_sample,
                                                          texture_close};
