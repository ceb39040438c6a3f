/// The number of impacts in a cell: integer thresholds of a Poisson distribution, and the cells it is drawn in.
#pragma once
#include "base/array.h"
#include <cstdint>

namespace weft {

/// Thresholds for Poisson counts of mean 0 < `mean` <= most_mean: a count is how many of them a uniform 32-bit number
/// reaches. Ascending, 1 to 255 of them; the tail that is cut off has a probability below 2^-32.
constexpr double most_mean = 96;
Array<std::uint32_t> poisson_thresholds(std::pmr::memory_resource* memory, double mean);

/// log2 of the edge of the cells with which a sample is found fastest: impacts of `rate` per pixel that reach
/// width x height pixels. Cells hold at most most_mean impacts, and are not much larger than the period (0: none).
std::uint32_t choose_cell_log2(double rate, double width, double height, std::uint32_t period_x,
                               std::uint32_t period_y) noexcept;

/// The same in space: impacts of `rate` per pixel cubed, from within half a `side` along each axis of a frame turned
/// any way.
std::uint32_t choose_cell_log2_in_space(double rate, double side) noexcept;

} // namespace weft
