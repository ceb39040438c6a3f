/// What a context is made of, shared by every handle made from it: memory and threads.
#pragma once
#include "base/memory.h"
#include "base/parallel.h"

namespace weft {

struct Core {
    Core(const weft_allocator* allocator, std::uint64_t memory_limit, std::uint32_t threads,
         const weft_executor* executor)
        : memory(allocator, memory_limit), parallel(threads, executor)
    {
    }

    Memory memory;
    Parallel parallel;
};

} // namespace weft
