/// A large tile of a texton's noise, for where a look-up must do: the texton added at many places of a torus.
#pragma once
#include "base/core.h"
#include "model/model.h"

namespace weft {

/// Random-phase noise of the texton's covariance, mean 0, on width x height pixels. The places depend on `key` alone,
/// so that tiles of several textons are of the same phases. B-splines of order 1; the same bits on every machine.
Planes make_noise_tile(Core& core, const Planes& coefficients, std::uint32_t width, std::uint32_t height,
                       std::uint64_t key);

/// A side of a noise tile for a period (0: none): a divisor of it, where there is one of about 512.
std::uint32_t noise_tile_side(std::uint32_t period) noexcept;

} // namespace weft
