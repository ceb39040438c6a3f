/// A penalty for parts of the exemplar that are used too often (Kaspar et al. 2015; the paper's equation 6).
#pragma once
#include "analysis/match_field.h"

namespace weft {

/// Frozen between counts. Uses are counted in cells of 4 x 4 pixels.
class Uniformity {
public:
    Uniformity(Core& core, const Lab_picture& exemplar, const Match_field& field);

    /// Counts the field's uses; a place used twice as often as would be even costs `unit`, thrice twice that.
    void count(const Match_field& field, double unit);
    std::uint32_t penalty(std::uint32_t x, std::uint32_t y) const noexcept
    {
        return penalties_[std::size_t{y / cell} * across_ + x / cell];
    }

private:
    static constexpr std::uint32_t cell = 4;

    std::uint32_t across_, down_;
    float even_;
    Array<std::uint32_t> counts_, penalties_;
};

} // namespace weft
