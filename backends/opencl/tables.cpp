/// Program -> tables: which kernel computes a layer, where its numbers are, how its texels are framed.
#include "opencl/tables.h"
#include "opencl/host.h"
#include <algorithm>

namespace weft::opencl {

bool is_composed(const weft_tile& tile)
{
    return tile.address != WEFT_ADDRESS_CELLS || tile.exchange || tile.displacement.layer >= 0;
}

weft_u32 layer_of(weft_ref ref) { return ref.layer < 0 ? WEFT_NONE : static_cast<weft_u32>(ref.layer); }

namespace {

bool known_splat(const weft_splat& splat)
{
    return splat.taps == 1 || splat.taps == 2 || splat.taps == 4 || splat.taps == 6;
}

bool known_in_plane(const weft_layer& layer, const weft_program& program)
{
    if (layer.kind == WEFT_LAYER_BANDS) return true;
    if (layer.kind == WEFT_LAYER_SPLAT) {
        const weft_ref choice = layer.splat->choice;
        return known_splat(*layer.splat) && (choice.layer < 0 || program.layers[choice.layer]->kind == WEFT_LAYER_TILE);
    }
    return layer.kind == WEFT_LAYER_TILE;
}

/// In space there are no pictures: only impacts on surfaces and only bands in solids.
bool known(const weft_layer& layer, const weft_program& program)
{
    if (program.use == WEFT_USE_SOLID) return layer.kind == WEFT_LAYER_BANDS;
    if (program.use == WEFT_USE_SURFACE)
        return layer.kind == WEFT_LAYER_SPLAT && known_splat(*layer.splat) && layer.splat->choice.layer < 0 &&
               layer.mask.layer < 0;
    return known_in_plane(layer, program);
}

bool known(const weft_program& program)
{
    return std::all_of(program.layers, program.layers + program.layer_count,
                       [&](const weft_layer* layer) { return known(*layer, program); });
}

std::uint32_t groups(std::uint32_t planes) { return (planes + 3) / 4; }

/// How far impacts reach, in pixels before and after a sample; `first` and `size` are the texels of a level.
void set_reach(std::uint32_t taps, std::uint32_t whole, std::int64_t first, std::int64_t size, weft_i32& before,
               weft_i32& after)
{
    const std::int64_t half = taps == 1 ? 1 : taps / 2, unit = std::int64_t{1} << whole;
    before = static_cast<weft_i32>(std::max<std::int64_t>((first + size + half) * unit + 1, 0));
    after = static_cast<weft_i32>((half - first) * unit + 1);
}

/// Images that may be shown.
std::uint32_t shown_images(const weft_splat& splat) { return splat.choice.layer < 0 ? 1 : splat.textons->images; }

/// Impacts in a band's list say in 31 bits where their texels are.
bool fits_lists(const weft_splat& splat, std::uint32_t planes)
{
    const weft_mips& mips = *splat.textons;
    const std::uint64_t frame = 2 * (WEFT_BLOCK_COLUMNS + 8);
    return (mips.width + frame) * (mips.height + frame) * planes * shown_images(splat) < INT32_MAX;
}

/// The host does not look into composed tiles: there impacts choose their images sample by sample.
bool chooses_on_device(const weft_splat& splat, const weft_program& program)
{
    return splat.choice.layer >= 0 && is_composed(*program.layers[splat.choice.layer]->tile);
}

weft_u32 splat_form(const weft_program& program, bool rows, const weft_splat& splat, std::uint32_t planes)
{
    if (program.use == WEFT_USE_SURFACE) return WEFT_SURFACE_GATHER;
    return rows && fits_lists(splat, planes) && !chooses_on_device(splat, program) ? WEFT_SPLAT_BANDS
                                                                                   : WEFT_SPLAT_GATHER;
}

weft_u32 bands_form(weft_use use, bool rows)
{
    if (use == WEFT_USE_SOLID) return WEFT_LATTICE_SOLID;
    return rows ? WEFT_LATTICE_PYRAMID : WEFT_LATTICE_GATHER;
}

} // namespace

Tables::Tables(const Device& device, const weft_program& from, std::pmr::memory_resource* memory)
    : program(from), layers(memory), levels(memory), lattices(memory), words(memory), numbers(memory)
{
    if (!known(program))
        throw Failure(WEFT_ERROR_UNSUPPORTED,
                      "opencl: the program has a layer or a use that this backend does not know");
    for (std::uint32_t i = 0; i < program.layer_count; ++i)
        add_layer(*program.layers[i], device.cpu && program.use == WEFT_USE_WINDOW);
    if (texel_count >= device.largest_buffer / 16 || texel_count >= UINT32_MAX)
        throw Failure(WEFT_ERROR_UNSUPPORTED, "opencl: the program's textons, tiles and lattices need ",
                      texel_count * 16, " bytes, the device's largest buffer has ", device.largest_buffer);
    assign_slots();
    // Never empty: a buffer of no bytes cannot be made.
    words.resize(words.size() + 1);
    levels.resize(levels.size() + 1);
    lattices.resize(lattices.size() + 1);
    texel_count += 1;
}

void Tables::add_layer(const weft_layer& layer, bool rows)
{
    LayerLayout to = {};
    to.planes = layer.planes;
    to.channels = layer.channels;
    to.period_x = program.period[0];
    to.period_y = program.period[1];
    to.period_z = program.period[2];
    to.mask_layer = layer_of(layer.mask);
    to.mask_plane = layer.mask.plane;
    to.choice_layer = to.mask_slot = to.tones = to.composed.moved_layer = WEFT_NONE;
    if (layer.kind == WEFT_LAYER_SPLAT) {
        to.key = weft_key(program.seed, layer.stream, WEFT_TAG_IMPACTS);
        to.form = splat_form(program, rows, *layer.splat, layer.planes);
        add_splat(*layer.splat, to);
    } else if (layer.kind == WEFT_LAYER_BANDS) {
        to.form = bands_form(program.use, rows);
        add_bands(*layer.bands, to);
    } else {
        to.form = is_composed(*layer.tile) ? WEFT_TILE_COMPOSED : WEFT_TILE_GATHER;
        add_tile(layer, to);
    }
    add_sum(layer, to);
    layers.push_back(to);
}

void Tables::add_splat(const weft_splat& splat, LayerLayout& to)
{
    to.taps = splat.taps;
    to.cell_log2 = splat.cell_log2;
    to.count_limit = splat.count_limit;
    to.signs = splat.signs;
    to.images = shown_images(splat);
    to.choice_layer = layer_of(splat.choice);
    to.choice_plane = splat.choice.plane;
    to.texton_width = splat.textons->width;
    to.texton_height = splat.textons->height;
    to.counts = static_cast<weft_u32>(words.size());
    words.insert(words.end(), splat.counts, splat.counts + splat.count_limit);
    to.offset = static_cast<weft_u32>(numbers.size());
    numbers.insert(numbers.end(), splat.offset, splat.offset + to.planes);
    numbers.resize(to.offset + groups(to.planes) * 4);
    add_levels(*splat.textons, to);
}

void Tables::add_levels(const weft_mips& mips, LayerLayout& to)
{
    const bool bands = to.form == WEFT_SPLAT_BANDS, tile = to.taps == 0;
    const std::uint32_t frame = tile || bands ? 0 : to.taps - 1;
    const std::uint32_t frame_y = bands ? WEFT_BLOCK_ROWS(to.taps) + to.taps - 2 : frame;
    to.first_level = static_cast<weft_u32>(levels.size());
    to.levels = mips.levels;
    for (std::uint32_t i = 0; i < mips.levels; ++i) {
        const weft_mip& mip = mips.level[i];
        LevelLayout level = {};
        level.offset = static_cast<weft_u32>(texel_count);
        level.width = mip.width;
        level.height = mip.height;
        level.x = mip.x;
        level.y = mip.y;
        level.scale_x = mip.scale_x;
        level.scale_y = mip.scale_y;
        level.stride = mip.width + (bands ? WEFT_BLOCK_COLUMNS : 2 * frame);
        level.frame_y = frame_y;
        level.frame_x = bands ? WEFT_BLOCK_COLUMNS : frame;
        level.plane_step = level.stride * (mip.height + 2 * frame_y) + (bands ? WEFT_BLOCK_COLUMNS : 0);
        level.image_step = level.plane_step * (bands ? to.planes : groups(to.planes));
        const std::uint64_t size = std::uint64_t{level.image_step} * to.images;
        texel_count += bands ? (size + 3) / 4 : size;
        if (to.form == WEFT_SURFACE_GATHER) {
            level.reach = weft_surface_reach(weft_surface_extent(to.texton_width, mip.x, mip.width, to.taps, i),
                                             weft_surface_extent(to.texton_height, mip.y, mip.height, to.taps, i),
                                             std::max(to.texton_width, to.texton_height));
        } else if (!tile) {
            set_reach(to.taps, i, mip.x, mip.width, level.before_x, level.after_x);
            set_reach(to.taps, i, mip.y, mip.height, level.before_y, level.after_y);
        }
        levels.push_back(level);
    }
}

void Tables::add_sum(const weft_layer& layer, LayerLayout& to)
{
    to.colours = program.channels;
    to.mean = static_cast<weft_u32>(numbers.size());
    numbers.insert(numbers.end(), layer.mean, layer.mean + program.channels);
    to.colour = static_cast<weft_u32>(numbers.size());
    if (layer.channels != 0)
        numbers.insert(numbers.end(), layer.colour, layer.colour + program.channels * layer.channels);
    if (!layer.tones) return;
    to.tones = static_cast<weft_u32>(words.size());
    for (std::uint32_t c = 0; c < layer.channels; ++c) {
        const weft_tone& tone = layer.tones[c];
        words.push_back(tone.count);
        words.push_back(static_cast<weft_u32>(numbers.size()));
        numbers.push_back(tone.low);
        numbers.push_back(tone.high);
        for (const weft_piece* p = tone.pieces; p != tone.pieces + tone.count; ++p)
            numbers.insert(numbers.end(), {p->x, p->c0, p->c1, p->c2, p->c3});
    }
}

/// Layers that are referred to keep their planes; all others share the planes behind them.
void Tables::assign_slots()
{
    for (const LayerLayout& layer : layers)
        if (layer.mask_layer != WEFT_NONE) {
            LayerLayout& owner = layers[layer.mask_layer];
            owner.kept = 1;
            if (owner.mask_layer != WEFT_NONE) owner.mask_slot = 0;
        }
    for (const LayerLayout& layer : layers)
        if (layer.composed.moved_layer != WEFT_NONE) layers[layer.composed.moved_layer].kept = 1;
    for (LayerLayout& layer : layers) {
        if (layer.mask_slot != WEFT_NONE) layer.mask_slot = slots++;
        if (!layer.kept) continue;
        layer.plane_slot = slots;
        slots += layer.planes;
    }
    std::uint32_t shared = 0;
    for (LayerLayout& layer : layers) {
        if (layer.form == WEFT_SPLAT_BANDS) sums = std::max(sums, layer.planes * layer.taps);
        if (layer.kept) continue;
        layer.plane_slot = slots;
        if (layer.form != WEFT_SPLAT_BANDS) shared = std::max(shared, layer.planes);
    }
    slots += shared;
}

void Tables::fill_texels(float* texels) const
{
    for (std::uint32_t i = 0; i < program.layer_count; ++i) {
        const weft_layer& layer = *program.layers[i];
        if (layer.kind == WEFT_LAYER_BANDS)
            fill_lattices(*layer.bands, layers[i], texels);
        else
            fill_mips(layer.kind == WEFT_LAYER_SPLAT ? *layer.splat->textons : *layer.tile->source, layers[i], texels);
    }
}

void Tables::fill_mips(const weft_mips& mips, const LayerLayout& layer, float* texels) const
{
    const std::uint32_t lanes = layer.form == WEFT_SPLAT_BANDS ? 1 : 4;
    for (std::uint32_t l = 0; l < mips.levels; ++l) {
        const LevelLayout& level = levels[layer.first_level + l];
        const float* from = mips.level[l].data;
        for (std::uint32_t plane = 0; plane < layer.images * layer.planes; ++plane) {
            const std::uint32_t image = plane / layer.planes, p = plane % layer.planes;
            const std::size_t start = std::size_t{level.image_step} * image +
                                      std::size_t{level.plane_step} * (p / lanes) +
                                      std::size_t{level.frame_y} * level.stride + level.frame_x;
            float* row = texels + std::size_t{level.offset} * 4 + start * lanes + p % lanes;
            for (std::uint32_t y = 0; y < level.height; ++y, row += std::size_t{level.stride} * lanes)
                for (std::uint32_t x = 0; x < level.width; ++x) row[std::size_t{x} * lanes] = *from++;
        }
    }
}

} // namespace weft::opencl
