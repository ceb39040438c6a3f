/// Model + options -> weft_program: layers only, and all the data that they point to.
#pragma once
#include "base/core.h"
#include "synthesis/mips.h"

namespace weft {

/// Options of weft_texture_create, defaults filled in, checked against the model; errors name weft_texture_create.
weft_texture_options complete_options(const Model& model, weft_texture_options options);

/// Stays where it was made: it points into itself, and into the model.
class Program {
public:
    Program(Core& core, const Model& model, const weft_texture_options& options);
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    const weft_program& window() const noexcept { return window_; }
    const weft_program& points() const noexcept { return points_; }

private:
    static constexpr std::uint32_t most_layers = 16;
    void add_texton(Core& core, const Texton& texton, const weft_texture_options& options);
    void add_picture(Core& core, const Planes& picture, const weft_texture_options& options);
    void add_layer(weft_layer_kind kind, const float* mean);
    void publish(const weft_texture_options& options);

    std::uint32_t channels_, layer_count_ = 0;
    weft_program window_{}, points_{};
    weft_layer layers_[most_layers]{};
    const weft_layer* order_[most_layers]{};
    float identity_[most_channels * most_channels]{}, mean_[most_channels]{}, nothing_[most_channels]{};

    weft_splat splat_{};
    weft_tile tile_{};
    Mip_chain mips_;
    Array<std::uint32_t> counts_;
    float offset_[most_channels]{};
};

} // namespace weft
