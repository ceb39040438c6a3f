/// Memory whose size depends on data: the caller's allocator or malloc, counted, with a limit.
#pragma once
#include <atomic>
#include <memory_resource>
#include <weft/weft.h>

namespace weft {

/// The allocator that stands for NULL: malloc and free.
extern const weft_allocator malloc_allocator;

/// Throws Error(WEFT_ERROR_MEMORY) when the allocator or the limit says no. Thread-safe.
class Memory final : public std::pmr::memory_resource {
public:
    Memory(const weft_allocator* allocator, std::uint64_t limit) noexcept; ///< NULL: malloc; 0: 4 GiB
    void
    charge(std::uint64_t bytes); ///< counts, for good, what was allocated elsewhere: that which this object lies in
    std::uint64_t used() const noexcept { return used_.load(std::memory_order_relaxed); }
    std::uint64_t limit() const noexcept { return limit_; }
    std::uint64_t room() const noexcept; ///< what the limit leaves

    /// The same for those who must not throw: NULL says no.
    void* take(std::size_t bytes, std::size_t alignment) noexcept;
    void give(void* memory, std::size_t bytes, std::size_t alignment) noexcept;

private:
    [[noreturn]] void refuse(std::uint64_t bytes) const;
    bool reserve(std::uint64_t bytes) noexcept;
    void* do_allocate(std::size_t bytes, std::size_t alignment) override;
    void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override
    {
        give(memory, bytes, alignment);
    }
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    weft_allocator allocator_;
    std::uint64_t limit_;
    std::atomic<std::uint64_t> used_{0};
};

} // namespace weft
