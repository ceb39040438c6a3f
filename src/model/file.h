/// Model <-> bytes, as FORMAT.md has them.
#pragma once
#include "model/model.h"

namespace weft {

/// Untrusted bytes. Throws Error(WEFT_ERROR_FORMAT), or Error(WEFT_ERROR_UNSUPPORTED) for what a newer libweft wrote.
Model read_model(std::pmr::memory_resource* memory, const unsigned char* bytes, std::size_t size);

std::uint64_t size_of_file(const Model& model) noexcept;

/// `size` is size_of_file(model). The same model always gives the same bytes.
void write_model(const Model& model, unsigned char* bytes, std::size_t size);

} // namespace weft
