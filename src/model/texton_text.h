/// The `.texton` text of the authors of texton noise.
///
///     TEXTON
///     1                                  version
///     1                                  order of the interpolation: 0, 1, 3, 5
///     5.5e-01 5.9e-01 2.9e-01            mean colour, in 0..1
///     16 16                              width and height, the frame of zeros included
///     0e+00 0e+00 0e+00                  width * height coefficients, bottom row first, each row from the left;
///     ...                                they carry the 1 / sqrt(|Omega|) of the exemplar, as ours do
///     Original image: ...                a note
///
/// The authors' program wants a texton that is 0 on its border, so that a graphics card may clamp there; their writer
/// adds a frame of zeros, one wide, and counts it in the size.
#pragma once
#include "base/core.h"
#include "model/model.h"

namespace weft {

/// Numbers may be separated by any white space; a frame that is all zeros is taken off. Throws WEFT_ERROR_FORMAT.
Model read_texton_text(Core& core, const char* text, std::size_t size);

/// Returns the text's length, and writes the text if that is not above `size`. Each number is the shortest that reads
/// back as the same float. Throws WEFT_ERROR_UNSUPPORTED unless the model is a single texton of 1 or 3 channels.
std::size_t write_texton_text(const Model& model, char* text, std::size_t size);

} // namespace weft
