/// What a plug-in may ask of libweft, over a context's memory.
#pragma once
#include "base/memory.h"
#include <weft/backend.h>

namespace weft {

/// Lives as long as the device that was opened with it.
class Host {
public:
    explicit Host(Memory& memory) noexcept;
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    const weft_host* table() const noexcept { return &table_; }

private:
    weft_host table_;
};

/// The sentence that a backend gave on this thread since clear_backend_sentence(); empty if none.
const char* backend_sentence() noexcept;
void clear_backend_sentence() noexcept;

} // namespace weft
