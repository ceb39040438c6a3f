/// The images that a model holds, for people and for other programs.
#pragma once
#include "model/model.h"

namespace weft {

/// Planes of the model's own, or made for the asker.
struct Part {
    char name[32]{};
    const float* values = nullptr; ///< channels planes of width x height
    std::uint32_t width = 0, height = 0, channels = 0;
    Planes made; ///< what `values` points to, if the model does not have it as floats

    std::size_t count() const noexcept { return std::size_t{width} * height * channels; }
};

std::uint32_t count_parts(const Model& model) noexcept;

/// Part `index`, below count_parts. It borrows from the model.
Part part_of(const Model& model, std::uint32_t index, std::pmr::memory_resource* memory);

} // namespace weft
