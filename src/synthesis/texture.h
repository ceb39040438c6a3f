/// One endless realisation of a model on a device: windows of it, and samples at points.
#pragma once
#include "backend/device.h"
#include "base/core.h"
#include "base/progress.h"
#include "synthesis/program.h"
#include "synthesis/scratch.h"
#include <optional>

namespace weft {

/// Stays where it was made. Core, device and model outlive it.
class Texture {
public:
    /// Options are complete_options'. Opens the program for windows and for points, on scalar what the device cannot.
    Texture(Core& core, Device& device, const Model& model, const weft_texture_options& options);

    /// `image` is checked; all else is checked here. Errors name weft_texture_render.
    void render(std::int64_t x, std::int64_t y, std::uint32_t level, const Progress& progress,
                const weft_image& image) const;

    /// Allocates nothing. Errors name weft_texture_sample.
    void sample(std::size_t count, const weft_point* points, float* out) const;

    std::uint32_t channels() const noexcept { return program_.window().channels; }

private:
    void open(Opened& opened, Device& device, const weft_program& program);

    Core& core_;
    Program program_;
    std::optional<Device> scalar_; ///< for what the device cannot
    Opened window_, points_;
    Scratch_pool scratch_;
};

} // namespace weft
