/// A program as the kernels read it: structs, numbers and framed texels, laid out by the host.
#pragma once
#include "opencl/device.h"
#include "opencl/layout.h"
#include <memory_resource>
#include <vector>

namespace weft::opencl {

/// Does a TILE ask for Wang tiles, exchange or displacement?
bool is_composed(const weft_tile& tile);

weft_u32 layer_of(weft_ref ref);

struct Tables {
    /// Throws WEFT_ERROR_UNSUPPORTED for what the kernels do not know or the device cannot hold.
    Tables(const Device& device, const weft_program& program, std::pmr::memory_resource* memory);

    /// Writes all texels and coefficients; `texels` has `texel_count` * 4 zeros.
    void fill_texels(float* texels) const;

    const weft_program& program;
    std::pmr::vector<LayerLayout> layers;
    std::pmr::vector<LevelLayout> levels;
    std::pmr::vector<LatticeLayout> lattices;
    std::pmr::vector<weft_u32> words;
    std::pmr::vector<float> numbers;
    std::uint64_t texel_count = 0; ///< in units of 4 floats
    std::uint32_t slots = 0;       ///< planes of the field
    std::uint32_t sums = 0;        ///< most accumulators of a layer of bands

private:
    void add_layer(const weft_layer& layer, bool rows);
    void add_splat(const weft_splat& splat, LayerLayout& to);
    void add_tile(const weft_layer& layer, LayerLayout& to);
    void add_wang(const weft_tile& tile, ComposedLayout& to);
    void add_exchange(const weft_tile& tile, ComposedLayout& to);
    weft_u32 add_bytes(const void* bytes, std::size_t count);
    void add_bands(const weft_bands& bands, LayerLayout& to);
    void add_lattice(const weft_band* bands, std::uint32_t index, const LayerLayout& layer);
    void fill_lattices(const weft_bands& bands, const LayerLayout& layer, float* texels) const;
    void fill_mips(const weft_mips& mips, const LayerLayout& layer, float* texels) const;
    void add_levels(const weft_mips& mips, LayerLayout& to);
    void add_sum(const weft_layer& layer, LayerLayout& to);
    void assign_slots();
};

} // namespace weft::opencl
