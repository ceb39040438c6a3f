/// As many rooms as threads of this process can be sampling at once, within reason.
#include "synthesis/scratch.h"
#include "base/parallel.h"
#include <algorithm>

namespace weft {

Scratch_pool::Scratch_pool(std::pmr::memory_resource* memory, std::uint32_t batch, std::uint32_t channels,
                           Frames frames)
    : capacity_(std::clamp(batch ? batch : 1024U, 64U, 4096U)), channels_(channels),
      rooms_(std::min(available_threads(), 32U)),
      spots_(memory, std::size_t{capacity_} * rooms_, Array<weft_spot>::unset),
      results_(memory, std::size_t{capacity_} * rooms_ * channels, Array<float>::unset),
      frames_(memory, frames == with_frames ? std::size_t{capacity_} * rooms_ * 9 : 0, Array<float>::unset),
      probes_(memory, std::size_t{capacity_} * rooms_, Array<std::uint8_t>::unset), taken_(memory, rooms_)
{
}

std::int32_t Scratch_pool::take() const noexcept
{
    for (std::uint32_t i = 0; i < rooms_; ++i)
        if (__atomic_exchange_n(&taken_[i], 1U, __ATOMIC_ACQUIRE) == 0) return static_cast<std::int32_t>(i);
    return -1;
}

void Scratch_pool::give(std::int32_t room) const noexcept
{
    __atomic_store_n(&taken_[static_cast<std::size_t>(room)], 0U, __ATOMIC_RELEASE);
}

Scratch Scratch_pool::operator[](std::int32_t room) const noexcept
{
    const std::size_t first = static_cast<std::size_t>(room) * capacity_;
    float* frames = frames_.empty() ? nullptr : &frames_[first * 9];
    return {&spots_[first], &results_[first * channels_], frames, &probes_[first], capacity_};
}

} // namespace weft
