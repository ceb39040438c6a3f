/// The chunk BILA of a model file: structure, masks, how they are rearranged, and the noises.
#pragma once
#include "base/bytes.h"
#include "model/model.h"

namespace weft {

std::uint64_t bilayer_length(const Model& model) noexcept; ///< bytes of the payload

/// Throws Error(WEFT_ERROR_FORMAT) where sizes do not fit; values are check_model's.
void read_bilayer(Reader& reader, std::pmr::memory_resource* memory, Model& model);
void write_bilayer(Writer& to, const Model& model);

} // namespace weft
