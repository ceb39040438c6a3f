/// What "scalar" and "simd" are made of but for their tables: a device is a table of kernels, a texture is a program
/// prepared for it.
#pragma once
#include "bands.h"
#include "compose.h"
#include "memory.h"
#include "rows.h"
#include "tile.h"

/// A device: kernels and whom to ask for memory.
struct weft_backend_device {
    const weft_host* host;
    const weft::Rows* rows;
};

namespace weft {

constexpr uint32_t most_layers = 32, most_levels = 15;

/// Which plane of a TILE decides on the texton of an impact.
struct Choice {
    const Rows* rows;
    const Tile* tile;
    const Tone* tone; ///< null: none
    uint32_t plane, images;
    uint32_t width, height; ///< of the layer's textons
};

/// A layer, prepared. `splat`, `bands` or `tile` is filled, after its kind.
struct Layer {
    const weft_layer* source;
    Splat splat;
    Bands bands;
    Tile tile;
    Choice choice;
    Texels texels[most_levels];
    Buffer<Tone> tones; ///< of its channels; empty: none
    Buffer<Lattice> lattices;
    Buffer<float> data; ///< what `texels` or `lattices` point into, if the kernels want copies
    Composed_data composed_data;
    float impacts_per_pixel;
    bool composed;         ///< a TILE, and is_composed
    bool masked, referred; ///< has a mask; is referred to by a later layer
};

/// A level by which a spot or a window sees a SPLAT layer: 0 from splat.levels on.
inline bool splat_has(const Layer& layer, uint32_t level) { return level < layer.splat.levels; }

weft_status device_open(const weft_host* host, const Rows& rows, weft_backend_device** device) noexcept;

void device_close(weft_backend_device* device) noexcept;
weft_status texture_open(weft_backend_device* device, const weft_program* program,
                         weft_backend_texture** texture) noexcept;
weft_status texture_render(weft_backend_texture* texture, const weft_window* window) noexcept;
weft_status texture_sample(weft_backend_texture* texture, const weft_batch* batch) noexcept;
void texture_close(weft_backend_texture* texture) noexcept;

} // namespace weft

struct weft_backend_texture {
    const weft_host* host;
    const weft::Rows* rows;
    const weft_program* program;
    weft::Layer layers[weft::most_layers];
};
