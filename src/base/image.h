/// The caller's pixels: checked views, and their conversion to and from planes of floats.
#pragma once
#include "base/array.h"
#include "base/parallel.h"
#include "base/progress.h"
#include <weft/weft.h>

namespace weft {

/// Throws Error(WEFT_ERROR_ARGUMENT) naming `function` and `argument` unless the view keeps weft.h's bounds: data,
/// width, height, channels, format, a stride that holds a row (0 is packed) and aligned rows of U16 and F32.
void check_image(const weft_image* image, const char* function, const char* argument);

std::size_t bytes_per_value(weft_format format) noexcept;
std::int64_t stride_of(const weft_image& image) noexcept; ///< in bytes, never 0

/// A checked image as planes of floats; integers become value / 255 or / 65535. Throws if a float is not finite, or
/// beyond 2^64.
Planes read_image(const weft_image& image, std::pmr::memory_resource* memory, Parallel& parallel, const char* function,
                  const char* argument, const Progress& progress = Progress());

/// Writes `rows` rows of planar floats (plane c, row y at source + (c * plane_rows + y) * stride) to the image from
/// (x, y) on: F32 as they are, integers rounded to nearest and clamped.
void write_window(const weft_image& image, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t rows,
                  const float* source, std::size_t stride, std::size_t plane_rows) noexcept;

} // namespace weft
