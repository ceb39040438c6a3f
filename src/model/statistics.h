/// Mean and standard deviation of the textures that a model makes.
#pragma once
#include "base/parallel.h"
#include "model/model.h"

namespace weft {

struct Statistics {
    std::array<float, most_channels> mean{}, deviation{};
};

/// At pixel centres of level 0, per channel; of a mixed model those of its first step. The same on every machine: sums
/// in double, in a fixed order.
Statistics statistics_of(const Model& model, std::pmr::memory_resource* memory, Parallel& parallel);

/// Variance of the noise of the first `planes` textons, at pixel centres.
std::array<double, most_channels> texton_variance(const Planes& coefficients, std::uint32_t planes, std::uint32_t taps,
                                                  std::pmr::memory_resource* memory, Parallel& parallel);

/// Of WEFT_METHOD_BILAYER.
Statistics bilayer_statistics(const Model& model, std::pmr::memory_resource* memory, Parallel& parallel);

} // namespace weft
