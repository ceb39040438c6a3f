/// The host's functions: memory from the context, sentences kept per thread.
#include "backend/host.h"

namespace weft {

namespace {

thread_local char sentence[192] = "";

void* allocate(void* self, std::size_t size, std::size_t alignment) noexcept
{
    return static_cast<Memory*>(self)->take(size, alignment);
}

void deallocate(void* self, void* memory, std::size_t size, std::size_t alignment) noexcept
{
    static_cast<Memory*>(self)->give(memory, size, alignment);
}

void error(void*, const char* text) noexcept
{
    std::size_t n = 0;
    for (; text && text[n] && n < sizeof sentence - 1; ++n) sentence[n] = text[n];
    sentence[n] = 0;
}

} // namespace

Host::Host(Memory& memory) noexcept
    : table_{sizeof(weft_host), WEFT_BACKEND_MINOR, &memory, allocate, deallocate, error}
{
}

const char* backend_sentence() noexcept { return sentence; }

void clear_backend_sentence() noexcept { sentence[0] = 0; }

} // namespace weft
