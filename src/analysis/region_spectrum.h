/// The spectrum of a noise that is known only in a region of any shape (Guingo et al. 2017, equations 4 and 5).
#pragma once
#include "analysis/target.h"

namespace weft {

/// Autocovariances over the pairs of pixels within the region, up to lags below `support` each way: by Fourier
/// transforms of the whole picture, whose room around it keeps these lags from wrapping into others.
class Region_spectrum {
public:
    Region_spectrum(Core& core, std::uint32_t width, std::uint32_t height, std::uint32_t support);

    /// 1 in the region, 0 elsewhere.
    void set_region(const float* region);
    /// What a texton of that support whose noise has unit variance is to reproduce. `plane` is 0 outside the region and
    /// has the mean 0 within; it must not be 0 everywhere.
    Target target_of(const float* plane, const SplineSamples& samples);

private:
    void correlate(const float* plane, Planes& lags);
    void smooth();

    Core& core_;
    std::uint32_t width_, height_, support_;
    Planes padded_;
    Spectra spectra_;
    PlaneTransform transform_, small_;
    Planes pairs_, lags_; ///< of the region, and of a plane: lag 0 at the corner, negative ones at the far end
    Array<float> window_; ///< along one axis; 0 from lag `support` on
};

} // namespace weft
