/// CIE L*a*b* of sRGB values, with the white of D65: the same bits on every machine.
#pragma once
#include "base/array.h"

namespace weft {

struct Lab {
    float l, a, b;
};

/// Tables of the two curves that need powers: the display's, and that of the eye.
class Lab_curves {
public:
    explicit Lab_curves(std::pmr::memory_resource* memory);

    /// Of values in 0..1; others are clamped. Within 1e-3 of the exact formula.
    Lab of(float red, float green, float blue) const noexcept;
    float lightness(float grey) const noexcept; ///< the same as of(grey, grey, grey).l up to rounding

private:
    static constexpr std::uint32_t light_steps = 1024, response_steps = 4096;
    float light(float value) const noexcept;    ///< sRGB decoded (IEC 61966-2-1)
    float response(float light) const noexcept; ///< CIE 15's f

    Array<float> light_, response_;
};

} // namespace weft
