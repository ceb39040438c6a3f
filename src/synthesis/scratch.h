/// Room for batches of spots, set aside when a texture is made, since sampling allocates nothing.
#pragma once
#include "base/array.h"
#include <atomic>
#include <weft/backend.h>

namespace weft {

/// Views of one batch's room. `probes` says how many of the spots belong to each point.
struct Scratch {
    weft_spot* spots;
    float* results; ///< spots * channels
    std::uint8_t* probes;
    std::uint32_t capacity; ///< spots; also points
};

class Scratch_pool {
public:
    Scratch_pool() = default;
    Scratch_pool(std::pmr::memory_resource* memory, std::uint32_t batch, std::uint32_t channels);

    /// The number of a free room, or -1: then the caller makes do with a small one on its stack.
    std::int32_t take() const noexcept;
    void give(std::int32_t room) const noexcept;
    Scratch operator[](std::int32_t room) const noexcept;

private:
    std::uint32_t capacity_ = 0, channels_ = 0, rooms_ = 0;
    mutable Array<weft_spot> spots_;
    mutable Array<float> results_;
    mutable Array<std::uint8_t> probes_;
    mutable Array<std::uint32_t> taken_; ///< a flag per room, used atomically
};

} // namespace weft
