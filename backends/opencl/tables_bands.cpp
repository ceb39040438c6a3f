/// Tables of BANDS: lattices that do not wrap around at once, each copied once however many bands share it.
#include "opencl/tables.h"
#include <algorithm>

namespace weft::opencl {

namespace {

/// Coefficients behind the last one of a row that are read at once: 16 by lattice_pyramid, else four columns, three
/// rows and three slices.
struct Frame {
    explicit Frame(weft_u32 form)
        : columns(form == WEFT_LATTICE_PYRAMID ? 15 : 3), rows(form == WEFT_LATTICE_PYRAMID ? 0 : 2),
          slices(form == WEFT_LATTICE_SOLID ? 2 : 0)
    {
    }
    std::uint32_t columns, rows, slices;
};

bool same(const weft_band& a, const weft_band& b)
{
    return a.lattice == b.lattice && a.width == b.width && a.height == b.height && a.depth == b.depth;
}

/// The first band with the lattice of band `index`: bands often share one, at different shifts.
std::uint32_t first_alike(const weft_band* bands, std::uint32_t index)
{
    return static_cast<std::uint32_t>(
        std::find_if(bands, bands + index, [&](const weft_band& band) { return same(band, bands[index]); }) - bands);
}

} // namespace

void Tables::add_bands(const weft_bands& bands, LayerLayout& to)
{
    to.first_level = static_cast<weft_u32>(lattices.size());
    for (std::uint32_t i = 0; i < bands.count * to.planes; ++i)
        if (bands.bands[i].lattice) to.levels = i / to.planes + 1;
    for (std::uint32_t i = 0; i < to.levels * to.planes; ++i) add_lattice(bands.bands, i, to);
}

void Tables::add_lattice(const weft_band* bands, std::uint32_t index, const LayerLayout& layer)
{
    const weft_band& band = bands[index];
    LatticeLayout& to = lattices.emplace_back();
    if (!band.lattice) return;
    const Frame frame(layer.form);
    const std::uint64_t row = std::uint64_t{band.width} + frame.columns, slice = row * (band.height + frame.rows);
    to = {slice,
          static_cast<weft_u32>(texel_count),
          1,
          static_cast<weft_u32>(row),
          band.width,
          band.height,
          band.depth,
          band.x % band.width,
          band.y % band.height,
          band.z % band.depth,
          band.weight};
    const std::uint32_t first = first_alike(bands, index);
    if (first != index)
        to.offset = lattices[layer.first_level + first].offset;
    else
        texel_count += (slice * (band.depth + frame.slices) + 3) / 4;
}

void Tables::fill_lattices(const weft_bands& bands, const LayerLayout& layer, float* texels) const
{
    const Frame frame(layer.form);
    for (std::uint32_t i = 0; i < layer.levels * layer.planes; ++i) {
        const weft_band& band = bands.bands[i];
        if (!band.lattice || first_alike(bands.bands, i) != i) continue;
        float* to = texels + std::size_t{lattices[layer.first_level + i].offset} * 4;
        for (std::uint32_t z = 0; z < band.depth + frame.slices; ++z)
            for (std::uint32_t y = 0; y < band.height + frame.rows; ++y) {
                const float* from =
                    band.lattice + (std::size_t{z % band.depth} * band.height + y % band.height) * band.width;
                for (std::uint32_t x = 0; x < band.width + frame.columns; ++x) *to++ = from[x % band.width];
            }
    }
}

} // namespace weft::opencl
