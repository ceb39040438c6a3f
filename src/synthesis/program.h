/// Model + options -> weft_program: layers only, and all the data that they point to.
#pragma once
#include "base/core.h"
#include "synthesis/bilayer_tables.h"
#include <optional>

namespace weft {

/// Checks the options of weft_texture_create against the model, and fills in defaults but for the impacts, whose
/// default depends on the use.
weft_texture_options complete_options(const Model& model, weft_texture_options options);

/// Stays where it was made: it points into itself, and into the model.
class Program {
public:
    enum Positions { in_plane, in_space };

    /// options.mix is only looked at here, and only in the plane. In space there are textons and wavelet noise.
    Program(Core& core, const Model& model, const weft_texture_options& options, Positions positions);
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    std::uint32_t channels() const noexcept { return channels_; }
    const weft_program& window() const noexcept { return program_; } ///< in_plane
    const weft_program& points() const noexcept { return points_; }  ///< in_plane
    const weft_program& space() const noexcept { return program_; }  ///< in_space: WEFT_USE_SURFACE or WEFT_USE_SOLID

private:
    static constexpr std::uint32_t most_layers = 16;
    void add_textons(Core& core, const Texton& texton, std::uint32_t images, const weft_texture_options& options,
                     const Splat_kernels& kernels, const weft_ref& choice);
    void add_texton(Core& core, const Texton& texton, const weft_texture_options& options);
    void add_surface(Core& core, const Texton& texton, const weft_texture_options& options);
    void add_mix(Core& core, const Texton& texton, const weft_texture_options& options);
    void add_map(Core& core, const weft_texture_options& options);
    void add_bands(Core& core, const Wavelet& wavelet, const weft_texture_options& options, Positions positions);
    void add_bilayer(Core& core, const Bilayer& bilayer, const weft_texture_options& options);
    weft_ref add_structure(Core& core, const Bilayer& bilayer, const weft_texture_options& options);
    void add_picture(Core& core, const Planes& picture, const weft_texture_options& options);
    weft_layer& add_layer(weft_layer_kind kind, const float* mean);
    void publish(const weft_texture_options& options, weft_use use);

    std::uint32_t channels_, layer_count_ = 0;
    weft_program program_{}, points_{};
    weft_layer layers_[most_layers]{};
    const weft_layer* order_[most_layers]{};
    float identity_[most_channels * most_channels]{}, mean_[most_channels]{}, nothing_[most_channels]{};

    Splat_tables splat_;
    weft_tile tile_{};
    Mip_chain mips_; ///< of the picture, or of the map
    Planes map_;
    float colour_[most_channels]{}; ///< of the map's plane
    std::optional<Band_lattices> lattices_;
    Tone_tables tones_;
    std::optional<Bilayer_tables> bilayer_;
};

} // namespace weft
