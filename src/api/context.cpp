/// weft_context_*.
#include "api/guard.h"
#include "api/handles.h"
#include "api/options.h"

using namespace weft;

namespace {

/// The caller's allocator as the standard library wants it: for the core alone, whose memory cannot lie in itself.
template <class T> struct Bare_allocator {
    using value_type = T;
    Bare_allocator(const weft_allocator& allocator, std::size_t& counter) noexcept : table(allocator), bytes(&counter)
    {
    }
    template <class U> Bare_allocator(const Bare_allocator<U>& other) noexcept : table(other.table), bytes(other.bytes)
    {
    }

    T* allocate(std::size_t count)
    {
        void* memory = table.allocate(table.user, count * sizeof(T), alignof(T));
        if (!memory) throw std::bad_alloc();
        *bytes = count * sizeof(T);
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) noexcept
    {
        table.deallocate(table.user, memory, count * sizeof(T), alignof(T));
    }
    template <class U> bool operator==(const Bare_allocator<U>&) const noexcept { return true; }
    template <class U> bool operator!=(const Bare_allocator<U>&) const noexcept { return false; }

    weft_allocator table;
    std::size_t* bytes; ///< of the last allocation
};

constexpr std::uint32_t most_threads = 1024;

void check(const weft_context_options& options, const char* function)
{
    require(options.threads <= most_threads, function, ": options->threads is ", options.threads, ", more than 1024");
    require(!options.allocator || (options.allocator->allocate && options.allocator->deallocate), function,
            ": options->allocator has a function that is NULL");
    require(!options.executor || options.executor->run, function, ": options->executor->run is NULL");
}

} // namespace

weft_status weft_context_create(const weft_context_options* given, weft_context** context) noexcept
{
    constexpr char function[] = "weft_context_create";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        const auto options = read_options(given, function, "options");
        check(options, function);
        std::size_t own = 0;
        const Bare_allocator<Core> allocator(options.allocator ? *options.allocator : malloc_allocator, own);
        const auto core = std::allocate_shared<Core>(allocator, options.allocator, options.memory_limit,
                                                     options.threads, options.executor);
        core->memory.charge(own);
        const Device_choice choice = Registry::instance().choose(options.device, function);
        auto device = make_in<Device>(core, core->memory, choice, function);
        *context = make_handle<weft_context>(core, std::move(device));
    });
}

weft_status weft_context_device(const weft_context* context, weft_device_info* info) noexcept
{
    constexpr char function[] = "weft_context_device";
    return guard(function, [&] {
        require(context, function, ": context is NULL");
        const std::uint32_t size = checked_size(info, function, "info");
        write_info(context->device.object->info(), info, size);
    });
}

void weft_context_free(weft_context* context) noexcept { free_handle(context); }
