/// The lattices of a BANDS layer, prepared once: where they are, or copies of them that reads of three and more
/// neighbours never leave.
#include "bands.h"

namespace weft {

namespace {

/// What is read behind the last coefficient: in windows two vectors of columns, at positions a vector of four columns,
/// three rows and three slices.
constexpr uint32_t more_in_window = overrun, more_columns = 3, more_lines = 2;

bool is_power(uint32_t size) { return (size & (size - 1)) == 0; }

uint32_t used_bands(const weft_bands& source, uint32_t planes)
{
    uint32_t used = 0;
    for (uint32_t i = 0; i < source.count * planes; ++i)
        if (source.bands[i].lattice) used = i / planes + 1;
    return used;
}

Lattice lattice_of(const weft_band& band)
{
    const int64_t slice = int64_t(band.width) * band.height;
    return {band.lattice,
            band.width,
            slice,
            {band.width, band.height, band.depth},
            {band.x % band.width, band.y % band.height, band.z % band.depth},
            band.weight,
            is_power(band.width) && is_power(band.height) && is_power(band.depth)};
}

struct Copied {
    uint32_t columns, rows, slices;
    size_t size() const { return size_t(columns) * rows * slices; }
};

Copied copied(const Lattice& lattice, weft_use use)
{
    if (use == WEFT_USE_WINDOW) return {lattice.size[0] + more_in_window, lattice.size[1], 1};
    const uint32_t slices = use == WEFT_USE_SOLID ? lattice.size[2] + more_lines : 1;
    return {lattice.size[0] + more_columns, lattice.size[1] + more_lines, slices};
}

bool same(const weft_band& a, const weft_band& b)
{
    return a.lattice == b.lattice && a.width == b.width && a.height == b.height && a.depth == b.depth;
}

/// The first band with the lattice of band i: bands often share one, at different shifts.
uint32_t first_alike(const weft_band* bands, uint32_t i)
{
    uint32_t first = 0;
    while (!same(bands[first], bands[i])) ++first;
    return first;
}

void copy(Lattice& lattice, const Copied& shape, float* to)
{
    const Lattice from = lattice;
    lattice.data = to;
    lattice.row = shape.columns;
    lattice.slice = int64_t(shape.columns) * shape.rows;
    for (uint32_t z = 0; z < shape.slices; ++z)
        for (uint32_t y = 0; y < shape.rows; ++y) {
            const float* row = from.data + z % from.size[2] * from.slice + y % from.size[1] * from.row;
            for (uint32_t x = 0; x < shape.columns; ++x) *to++ = row[x % from.size[0]];
        }
}

bool copy_lattices(const weft_bands& source, uint32_t count, weft_use use, Lattice* lattices, Buffer<float>& data)
{
    size_t total = 0;
    for (uint32_t i = 0; i < count; ++i)
        if (lattices[i].data && first_alike(source.bands, i) == i) total += copied(lattices[i], use).size();
    if (!data.reserve(total)) return false;
    float* to = data.data();
    for (uint32_t i = 0; i < count; ++i) {
        Lattice& lattice = lattices[i];
        if (!lattice.data) continue;
        const uint32_t first = first_alike(source.bands, i);
        if (first == i) {
            const Copied shape = copied(lattice, use);
            copy(lattice, shape, to);
            to += shape.size();
        } else {
            lattice.data = lattices[first].data;
            lattice.row = lattices[first].row;
            lattice.slice = lattices[first].slice;
        }
    }
    return true;
}

} // namespace

bool open_bands(const weft_layer& layer, weft_use use, bool padded, Buffer<Lattice>& lattices, Buffer<float>& data,
                Bands& bands)
{
    const weft_bands& source = *layer.bands;
    const uint32_t used = used_bands(source, layer.planes), count = used * layer.planes;
    if (!lattices.reserve(count)) return false;
    for (uint32_t i = 0; i < count; ++i)
        lattices.data()[i] = source.bands[i].lattice ? lattice_of(source.bands[i]) : Lattice{};
    bands = {used, layer.planes, lattices.data()};
    return !padded || copy_lattices(source, count, use, lattices.data(), data);
}

} // namespace weft
