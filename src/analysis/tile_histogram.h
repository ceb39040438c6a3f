/// The tile's values brought to the photo's distribution, channel by channel.
#pragma once
#include "analysis/lab_picture.h"

namespace weft {

/// How often each value occurs: from -lab_bound - 1 on.
class Value_counts {
public:
    static constexpr std::uint32_t values = 2 * (lab_bound + 1);

    Value_counts(Core& core, const Lab_picture& picture, const Progress& progress);
    const std::uint64_t* channel(std::uint32_t c) const noexcept { return counts_.data() + std::size_t{c} * values; }
    std::uint64_t total() const noexcept { return total_; }

private:
    Array<std::uint64_t> counts_;
    std::uint64_t total_;
};

/// Replaces each value by that of the same rank in `goal` (the paper's blend along the CDFs' x axis, its alpha 1
/// throughout: a fading alpha costs contrast). The tile's margin is left as it is.
void match_histogram(Core& core, const Value_counts& goal, Lab_picture& tile, const Progress& progress);

} // namespace weft
