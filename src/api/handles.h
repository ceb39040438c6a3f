/// What stands behind the handles of weft.h. Each owns what it needs, so that they can be freed in any order.
#pragma once
#include "backend/device.h"
#include "base/core.h"
#include "model/model.h"
#include "model/statistics.h"
#include "synthesis/texture.h"
#include <memory>

namespace weft {

/// Something in a core's memory: the core is released after it.
template <class T> struct In_core {
    std::shared_ptr<Core> core;
    std::shared_ptr<T> object;
};

struct Loaded_model {
    Model model;
    Statistics statistics;
};

template <class T, class... Arguments> In_core<T> make_in(const std::shared_ptr<Core>& core, Arguments&&... arguments)
{
    const std::pmr::polymorphic_allocator<T> allocator(&core->memory);
    return {core, std::allocate_shared<T>(allocator, std::forward<Arguments>(arguments)...)};
}

} // namespace weft

struct weft_context {
    std::shared_ptr<weft::Core> core;
    weft::In_core<weft::Device> device;
};

struct weft_model {
    std::shared_ptr<weft::Core> core;
    weft::In_core<const weft::Loaded_model> loaded;
};

struct weft_texture {
    std::shared_ptr<weft::Core> core;
    weft::In_core<weft::Device> device;
    weft::In_core<const weft::Loaded_model> loaded;
    weft::In_core<const weft::Texture> texture; // the first to go: it refers to the others
};

namespace weft {

/// Handles lie in their core's memory.
template <class Handle, class... Parts> Handle* make_handle(const std::shared_ptr<Core>& core, Parts&&... parts)
{
    void* memory = core->memory.allocate(sizeof(Handle), alignof(Handle));
    return new (memory) Handle{core, std::forward<Parts>(parts)...};
}

template <class Handle> void free_handle(Handle* handle) noexcept
{
    if (!handle) return;
    const std::shared_ptr<Core> core = handle->core;
    handle->~Handle();
    core->memory.deallocate(handle, sizeof(Handle), alignof(Handle));
}

} // namespace weft
