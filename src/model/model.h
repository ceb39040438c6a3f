/// What was learnt from a photo: method, mean colour, layers. Immutable once made; the file format is in FORMAT.md.
#pragma once
#include "base/array.h"
#include "model/bilayer.h"
#include "model/correspondence.h"
#include "model/wavelet.h"
#include <array>
#include <memory_resource>
#include <weft/weft.h>

namespace weft {

constexpr std::uint32_t most_channels = 16;
constexpr std::uint32_t most_side = 16384; ///< of a texton or a picture
constexpr std::uint32_t most_images = 255; ///< steps of a mixed model

/// A texton's coefficients alpha (Galerne et al. 2017, equation 3), the kernel of the noise
/// g(x) = mean + (1 / sqrt(lambda)) (sum_j h(x - x_j) - lambda sum_k alpha(k)), h the B-spline surface through alpha.
/// Of a mixed model there are several, one for each step (section 7): impacts take one and a random sign, and lambda
/// sum_k alpha(k) is not there.
struct Texton {
    Planes coefficients;      ///< one plane per channel, 1..16384 a side; of several images one image after another
    std::uint32_t images = 1; ///< 2..255: mixed
    Array<float> means; ///< images * channels, of each step, the first one being the model's; empty if there is 1 image
    std::uint32_t taps = 2; ///< of the interpolation per axis: 1, 2, 4, 6
    float model_error = -1; ///< against the photo's periodogram; -1: unknown, and so for mixed models
};

/// Invariants are check_model's. Exactly one of `texton`, `wavelet` and `picture` is filled, as `method` says.
struct Model {
    weft_method method = 0;
    std::uint32_t channels = 0;
    std::array<float, most_channels>
        mean{};                    ///< of the noise (of the first step; before tone curves); PICTURE, STATIONARY: 0
    Texton texton;                 ///< WEFT_METHOD_TEXTON
    Wavelet wavelet;               ///< WEFT_METHOD_WAVELET
    Bilayer bilayer;               ///< WEFT_METHOD_BILAYER
    Planes picture;                ///< WEFT_METHOD_PICTURE; the tile of WEFT_METHOD_STATIONARY
    Correspondence correspondence; ///< WEFT_METHOD_STATIONARY
};

/// Throws Error(broken) unless every number is finite and every count within its bounds, and
/// Error(WEFT_ERROR_UNSUPPORTED) for a method that is not known.
void check_model(const Model& model, weft_status broken = WEFT_ERROR_FORMAT);

} // namespace weft
