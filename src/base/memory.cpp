/// The counted memory resource.
#include "base/memory.h"
#include "base/error.h"
#include <cstdlib>

namespace weft {

namespace {

void* malloc_allocate(void*, std::size_t size, std::size_t alignment) noexcept
{
    if (alignment <= alignof(std::max_align_t)) return std::malloc(size);
    void* memory = nullptr;
    return posix_memalign(&memory, alignment, size) == 0 ? memory : nullptr;
}

void malloc_deallocate(void*, void* memory, std::size_t, std::size_t) noexcept { std::free(memory); }

constexpr std::uint64_t default_limit = std::uint64_t{4} << 30;

} // namespace

const weft_allocator malloc_allocator{malloc_allocate, malloc_deallocate, nullptr};

Memory::Memory(const weft_allocator* allocator, std::uint64_t limit) noexcept
    : allocator_(allocator ? *allocator : malloc_allocator), limit_(limit ? limit : default_limit)
{
}

std::uint64_t Memory::room() const noexcept
{
    const std::uint64_t held = used();
    return held < limit_ ? limit_ - held : 0;
}

bool Memory::reserve(std::uint64_t bytes) noexcept
{
    std::uint64_t held = used_.load(std::memory_order_relaxed);
    do {
        if (bytes > limit_ || held > limit_ - bytes) return false;
    } while (!used_.compare_exchange_weak(held, held + bytes, std::memory_order_relaxed));
    return true;
}

void* Memory::take(std::size_t bytes, std::size_t alignment) noexcept
{
    const std::size_t size = bytes ? bytes : 1;
    if (!reserve(size)) return nullptr;
    void* memory = allocator_.allocate(allocator_.user, size, alignment);
    if (!memory) used_.fetch_sub(size, std::memory_order_relaxed);
    return memory;
}

void Memory::give(void* memory, std::size_t bytes, std::size_t alignment) noexcept
{
    if (!memory) return;
    const std::size_t size = bytes ? bytes : 1;
    allocator_.deallocate(allocator_.user, memory, size, alignment);
    used_.fetch_sub(size, std::memory_order_relaxed);
}

void Memory::refuse(std::uint64_t bytes) const
{
    if (bytes > room())
        throw Error(WEFT_ERROR_MEMORY, bytes, " bytes are needed beside the ", used(), " held; memory_limit is ",
                    limit_);
    throw Error(WEFT_ERROR_MEMORY, "the allocator refused ", bytes, " bytes");
}

void Memory::charge(std::uint64_t bytes)
{
    if (!reserve(bytes)) refuse(bytes);
}

void* Memory::do_allocate(std::size_t bytes, std::size_t alignment)
{
    void* memory = take(bytes, alignment);
    if (!memory) refuse(bytes);
    return memory;
}

} // namespace weft
