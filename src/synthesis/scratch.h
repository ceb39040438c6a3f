/// Room for batches of spots, set aside beforehand, since sampling allocates nothing.
#pragma once
#include "base/array.h"
#include "model/model.h"
#include <weft/backend.h>

namespace weft {

/// Views of one batch's room. `probes` says how many of the spots belong to each point.
struct Scratch {
    weft_spot* spots;
    float* results; ///< spots * channels
    float* frames;  ///< spots * 9, if the pool has them
    std::uint8_t* probes;
    std::uint32_t capacity; ///< spots; also points
};

class Scratch_pool {
public:
    enum Frames { without_frames, with_frames };
    Scratch_pool() = default;
    Scratch_pool(std::pmr::memory_resource* memory, std::uint32_t batch, std::uint32_t channels,
                 Frames frames = without_frames);

    /// The number of a free room, or -1: then the caller makes do with a small one on its stack.
    std::int32_t take() const noexcept;
    void give(std::int32_t room) const noexcept;
    Scratch operator[](std::int32_t room) const noexcept;

private:
    std::uint32_t capacity_ = 0, channels_ = 0, rooms_ = 0;
    mutable Array<weft_spot> spots_;
    mutable Array<float> results_, frames_;
    mutable Array<std::uint8_t> probes_;
    mutable Array<std::uint32_t> taken_; ///< a flag per room, used atomically
};

/// A room of the pool for `spots` or more, if one is free and they are many; else the stack.
class Room {
public:
    Room(const Scratch_pool& pool, std::size_t spots) noexcept
        : pool_(pool), number_(spots > small_batch ? pool.take() : -1)
    {
    }
    ~Room()
    {
        if (number_ >= 0) pool_.give(number_);
    }
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;
    Scratch scratch() noexcept
    {
        return number_ >= 0 ? pool_[number_] : Scratch{spots_, results_, frames_, probes_, small_batch};
    }

private:
    static constexpr std::uint32_t small_batch = 64; ///< spots that fit the stack of any thread

    const Scratch_pool& pool_;
    const std::int32_t number_;
    weft_spot spots_[small_batch];
    float results_[small_batch * most_channels], frames_[small_batch * 9];
    std::uint8_t probes_[small_batch];
};

} // namespace weft
