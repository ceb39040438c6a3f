/// What is checked alike in models of several methods.
#pragma once
#include "base/error.h"
#include "base/finite.h"
#include "model/model.h"

namespace weft {

/// A broken rule is answered with one status.
class Rules {
public:
    explicit Rules(weft_status broken) noexcept : broken_(broken) {}
    template <class... Parts> void demand(bool good, const Parts&... parts) const
    {
        if (!good) throw Error(broken_, parts...);
    }

    /// Finite and within 2^64 of 0.
    static bool all_finite(const float* values, std::size_t count) noexcept
    {
        return all_below(values, count, two_to_64_bits);
    }

    void planes(const Planes& planes, std::uint32_t channels, const char* what) const;

    /// The first `count` rows of a table of axes.
    void rows(const float (*values)[16], std::uint32_t count, std::uint32_t channels, const char* name) const;

    /// Axes at right angles, tone curves that rise.
    void colours(const Colour_axes& colours, std::uint32_t channels) const;

private:
    void axes(const Colour_axes& colours, std::uint32_t channels) const;
    void tone(const Colour_axes& colours, std::uint32_t axis) const;

    weft_status broken_;
};

/// Of WEFT_METHOD_BILAYER, whose channels have been checked.
void check_bilayer(const Model& model, const Rules& rules);

} // namespace weft
