/// One endless realisation of a model on a device: windows of it, and samples at points.
#pragma once
#include "backend/device.h"
#include "base/core.h"
#include "base/progress.h"
#include "synthesis/program.h"
#include "synthesis/scratch.h"
#include <atomic>
#include <memory>
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

    /// The first call prepares what is in space; later ones allocate nothing. Errors name the functions of weft.h.
    void sample_surface(std::size_t count, const weft_surface_point* points, float* out) const;
    void sample_solid(std::size_t count, const weft_solid_point* points, float* out) const;

    std::uint32_t channels() const noexcept { return program_.channels(); }

private:
    struct Space;
    const Space& space(const char* function) const;
    template <class Point, class Place>
    void sample_space(std::size_t count, const Point* points, float* out, const char* function,
                      const Place& place) const;
    void open(Opened& opened, const weft_program& program, const char* function) const;

    Core& core_;
    Device& device_;
    const Model& model_;
    const weft_texture_options options_; ///< without the map, which is the caller's
    const bool mixed_;                   ///< there was a map
    Program program_;
    mutable std::optional<Device> scalar_; ///< for what the device cannot
    Opened window_, points_;
    Scratch_pool scratch_;

    mutable std::mutex opening_; ///< of scalar_ and space_ after the texture was made
    mutable std::shared_ptr<const Space> owner_;
    mutable std::atomic<const Space*> space_{nullptr};
};

} // namespace weft
