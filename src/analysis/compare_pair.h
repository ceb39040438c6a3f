/// An exemplar and an output in the coordinates in which the metrics of weft_compare measure them.
#pragma once
#include "base/array.h"
#include "base/core.h"
#include "base/progress.h"
#include "model/model.h"

namespace weft {

/// Both pictures in the principal channels of the exemplar, the most varied first; the exemplar's mean is taken off
/// both and both are divided by the exemplar's total standard deviation, so that its variances add up to 1.
struct Pair {
    Planes exemplar, output;
    double variance[most_channels] = {}; ///< of the exemplar
    double output_mean[most_channels] = {}, output_variance[most_channels] = {};
    bool exemplar_varies = false, output_varies = false; ///< by more than the rounding of a float

    std::uint32_t channels() const noexcept { return exemplar.count; }
};

Pair prepare_pair(Core& core, const weft_image& exemplar, const weft_image& output, const Progress& progress);

/// Runs body(i) for every i < count in batches, reporting in between: a batch is about 2^24 of the elementary
/// operations of which one body takes `cost`.
void for_each_step(Core& core, std::uint32_t count, double cost, const Progress& progress,
                   const std::function<void(std::uint32_t)>& body);

} // namespace weft
