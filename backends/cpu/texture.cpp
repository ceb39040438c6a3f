/// Opening: refuses what is not there yet, and lays the textons out as the kernels like them.
#include "texture.h"
#include <new>

namespace weft {

namespace {

weft_status refuse(const weft_host* host, weft_status status, const char* sentence)
{
    host->error(host->self, sentence);
    return status;
}

/// In space there are no pictures: only impacts on surfaces and only bands in solids.
bool supports_in_space(const weft_layer& layer, weft_use use)
{
    if (use == WEFT_USE_SOLID) return layer.kind == WEFT_LAYER_BANDS;
    return layer.kind == WEFT_LAYER_SPLAT && layer.splat->choice.layer < 0 && layer.mask.layer < 0;
}

bool supports(const weft_layer& layer, const weft_program& program)
{
    if (program.use == WEFT_USE_SURFACE || program.use == WEFT_USE_SOLID) return supports_in_space(layer, program.use);
    if (layer.kind == WEFT_LAYER_BANDS) return true;
    if (layer.kind == WEFT_LAYER_SPLAT) {
        const weft_ref choice = layer.splat->choice;
        return choice.layer < 0 || program.layers[choice.layer]->kind == WEFT_LAYER_TILE;
    }
    return layer.kind == WEFT_LAYER_TILE;
}

bool supports(const weft_program& program)
{
    if (!weft_understands_program(&program)) return false;
    if (program.layer_count > most_layers) return false;
    for (uint32_t i = 0; i < program.layer_count; ++i)
        if (program.layers[i]->planes > most_planes || !supports(*program.layers[i], program)) return false;
    return true;
}

/// How copies of textons are laid out: `width` floats for a texel, zeros around the texels. The zeros to the right of a
/// row are those to the left of the next, the zeros below a plane those above the next.
struct Layout {
    uint32_t width, groups, columns, rows;

    int64_t row(const weft_mip& mip) const { return (int64_t(mip.width) + columns) * width; }
    int64_t plane(const weft_mip& mip) const { return (int64_t(mip.height) + rows) * row(mip); }
    int64_t lead(const weft_mip& mip) const { return (rows * row(mip) + int64_t(columns) * width + 15) / 16 * 16; }
    int64_t size(const weft_mip& mip, uint32_t images) const
    {
        return (lead(mip) + int64_t(images) * groups * plane(mip) + int64_t(columns) * width + 15) / 16 * 16;
    }
};

Layout layout_for(const Rows& rows, weft_use use, const weft_splat& splat)
{
    const uint32_t planes = splat.textons->planes;
    if (use == WEFT_USE_WINDOW) return {1, planes, rows.apron, rows.apron_rows};
    return {4, (planes + 3) / 4, splat.taps, splat.taps};
}

void copy_texels(const weft_mips& textons, const weft_mip& mip, const Layout& layout, float* to)
{
    const size_t area = size_t(mip.width) * mip.height;
    for (uint32_t image = 0; image < textons.images; ++image)
        for (uint32_t p = 0; p < textons.planes; ++p) {
            const float* from = mip.data + (size_t(image) * textons.planes + p) * area;
            float* plane =
                to + (int64_t(image) * layout.groups + p / layout.width) * layout.plane(mip) + p % layout.width;
            for (uint32_t y = 0; y < mip.height; ++y)
                for (uint32_t x = 0; x < mip.width; ++x)
                    plane[y * layout.row(mip) + int64_t(x) * layout.width] = from[size_t(y) * mip.width + x];
        }
}

int64_t surface_reach(const weft_splat& splat, uint32_t level)
{
    const weft_mips& textons = *splat.textons;
    const weft_mip& mip = textons.level[level];
    return weft_surface_reach(weft_surface_extent(textons.width, mip.x, mip.width, splat.taps, level),
                              weft_surface_extent(textons.height, mip.y, mip.height, splat.taps, level),
                              textons.width > textons.height ? textons.width : textons.height);
}

bool copy_textons(Layer& layer, const Layout& layout)
{
    const weft_mips& textons = *layer.source->splat->textons;
    int64_t total = 0;
    for (uint32_t l = 0; l < textons.levels; ++l) total += layout.size(textons.level[l], textons.images);
    if (!layer.data.reserve(size_t(total))) return false;
    for (int64_t i = 0; i < total; ++i) layer.data.data()[i] = 0.0f;
    float* data = layer.data.data();
    for (uint32_t l = 0; l < textons.levels; ++l) {
        const weft_mip& mip = textons.level[l];
        float* first = data + layout.lead(mip);
        copy_texels(textons, mip, layout, first);
        layer.texels[l] = {first,
                           layout.row(mip),
                           layout.plane(mip),
                           layout.groups * layout.plane(mip),
                           int32_t(mip.width),
                           int32_t(mip.height),
                           mip.x,
                           mip.y,
                           surface_reach(*layer.source->splat, l)};
        data += layout.size(mip, textons.images);
    }
    return true;
}

/// The program's own textons, for kernels that look at bounds.
void refer_to_textons(Layer& layer)
{
    const weft_mips& textons = *layer.source->splat->textons;
    for (uint32_t l = 0; l < textons.levels; ++l) {
        const weft_mip& mip = textons.level[l];
        const int64_t plane = int64_t(mip.width) * mip.height;
        layer.texels[l] = {mip.data,
                           mip.width,
                           plane,
                           plane * textons.planes,
                           int32_t(mip.width),
                           int32_t(mip.height),
                           mip.x,
                           mip.y,
                           surface_reach(*layer.source->splat, l)};
    }
}

uint32_t choose(const void* choice, int64_t x, int64_t y)
{
    const Choice& c = *static_cast<const Choice*>(choice);
    const int64_t pixel[2] = {weft_choice_pixel(x, c.width), weft_choice_pixel(y, c.height)};
    const uint32_t centre[2] = {WEFT_FRACTION_HALF, WEFT_FRACTION_HALF};
    float value;
    if (is_composed(*c.tile->tile))
        compose_point(*c.rows, *c.tile, {{pixel[0], pixel[1], 0}, {centre[0], centre[1], 0}, 0.0f}, nullptr, c.plane, 1,
                      &value);
    else
        tile_point(*c.tile, pixel, centre, 0.0f, c.plane, 1, &value);
    if (c.tone) c.rows->tone(*c.tone, 1, &value);
    return weft_choose(value, c.images);
}

float mean_count(const weft_splat& splat)
{
    double count = 0;
    for (uint32_t i = 0; i < splat.count_limit; ++i) count += 1 - double(splat.counts[i]) / 4294967296.0;
    return float(count);
}

uint32_t usual_counts(const weft_splat& splat)
{
    uint32_t count = 0;
    while (count < splat.count_limit && splat.counts[count] < 0xff000000) ++count;
    return count;
}

bool open_splat(weft_backend_texture& texture, Layer& layer)
{
    const weft_program& program = *texture.program;
    const weft_splat& splat = *layer.source->splat;
    layer.splat = {weft_key(program.seed, layer.source->stream, WEFT_TAG_IMPACTS),
                   {program.period[0], program.period[1], program.period[2]},
                   {splat.textons->width, splat.textons->height},
                   splat.cell_log2,
                   splat.count_limit,
                   splat.signs,
                   splat.taps,
                   layer.source->planes,
                   splat.textons->levels,
                   usual_counts(splat),
                   splat.counts,
                   splat.offset,
                   layer.texels,
                   nullptr,
                   nullptr};
    const float side = float(uint32_t(1) << splat.cell_log2);
    layer.impacts_per_pixel = mean_count(splat) / (side * side);
    if (splat.choice.layer >= 0) {
        const Layer& chosen = texture.layers[splat.choice.layer];
        const bool toned = chosen.source->tones && splat.choice.plane < chosen.source->channels;
        layer.choice = {
            texture.rows,         &chosen.tile,          toned ? chosen.tones.data() + splat.choice.plane : nullptr,
            splat.choice.plane,   splat.textons->images, splat.textons->width,
            splat.textons->height};
        layer.splat.choose = choose;
        layer.splat.choice = &layer.choice;
    }
    const bool copied = program.use == WEFT_USE_WINDOW ? texture.rows->apron != 0 : texture.rows->interleaved != 0;
    if (copied) return copy_textons(layer, layout_for(*texture.rows, program.use, splat));
    refer_to_textons(layer);
    return true;
}

bool open_tile(weft_backend_texture& texture, Layer& layer)
{
    const weft_program& program = *texture.program;
    const weft_tile& tile = *layer.source->tile;
    layer.tile = {&tile, layer.source->planes, {program.period[0], program.period[1]}, {}};
    layer.composed = is_composed(tile);
    return !layer.composed || open_composed(*layer.source, program, texture.rows->interleaved != 0, layer.composed_data,
                                            layer.texels, layer.tile.composed);
}

Tone tone_of(const weft_tone& source)
{
    Tone tone;
    tone.low = source.low;
    tone.high = source.high;
    tone.count = source.count;
    for (uint32_t k = 0; k < most_pieces; ++k) {
        const weft_piece none = {__builtin_nanf(""), 0, 0, 0, 0};
        const weft_piece& piece = k < source.count ? source.pieces[k] : none;
        tone.x[k] = piece.x;
        tone.c[0][k] = piece.c0;
        tone.c[1][k] = piece.c1;
        tone.c[2][k] = piece.c2;
        tone.c[3][k] = piece.c3;
    }
    return tone;
}

bool open_tones(Layer& layer)
{
    if (!layer.source->tones || layer.source->channels == 0) return true;
    if (!layer.tones.reserve(layer.source->channels)) return false;
    for (uint32_t c = 0; c < layer.source->channels; ++c) layer.tones.data()[c] = tone_of(layer.source->tones[c]);
    return true;
}

bool open_layer(weft_backend_texture& texture, uint32_t index)
{
    const weft_program& program = *texture.program;
    Layer& layer = texture.layers[index];
    const weft_ref mask = layer.source->mask;
    layer.masked = mask.layer >= 0;
    if (layer.masked) texture.layers[mask.layer].referred = true;
    const int32_t moved = layer.source->tile ? layer.source->tile->displacement.layer : -1;
    if (moved >= 0) texture.layers[moved].referred = true;
    if (!open_tones(layer)) return false;
    if (layer.source->kind == WEFT_LAYER_SPLAT) return open_splat(texture, layer);
    if (layer.source->kind == WEFT_LAYER_BANDS)
        return open_bands(*layer.source, program.use, texture.rows->interleaved != 0, layer.lattices, layer.data,
                          layer.bands);
    return open_tile(texture, layer);
}

} // namespace

weft_status device_open(const weft_host* host, const Rows& rows, weft_backend_device** device) noexcept
{
    void* memory = host->allocate(host->self, sizeof(weft_backend_device), alignof(weft_backend_device));
    if (!memory) return WEFT_ERROR_MEMORY;
    *device = new (memory) weft_backend_device{host, &rows};
    return WEFT_OK;
}

void device_close(weft_backend_device* device) noexcept
{
    const weft_host* host = device->host;
    host->deallocate(host->self, device, sizeof(weft_backend_device), alignof(weft_backend_device));
}

weft_status texture_open(weft_backend_device* device, const weft_program* program,
                         weft_backend_texture** texture) noexcept
{
    const weft_host* host = device->host;
    if (!supports(*program))
        return refuse(
            host, WEFT_ERROR_UNSUPPORTED,
            "this device evaluates SPLAT, BANDS and TILE layers in the plane, SPLAT layers without choice and mask on "
            "surfaces, BANDS layers in space");
    void* memory = host->allocate(host->self, sizeof(weft_backend_texture), alignof(weft_backend_texture));
    if (!memory) return WEFT_ERROR_MEMORY;
    weft_backend_texture* made = new (memory) weft_backend_texture{};
    made->host = host;
    made->rows = device->rows;
    made->program = program;
    for (uint32_t i = 0; i < program->layer_count; ++i) {
        made->layers[i].source = program->layers[i];
        made->layers[i].data.use(host);
        made->layers[i].tones.use(host);
        made->layers[i].lattices.use(host);
        made->layers[i].composed_data.use(host);
        if (open_layer(*made, i)) continue;
        texture_close(made);
        return WEFT_ERROR_MEMORY;
    }
    *texture = made;
    return WEFT_OK;
}

void texture_close(weft_backend_texture* texture) noexcept
{
    const weft_host* host = texture->host;
    texture->~weft_backend_texture();
    host->deallocate(host->self, texture, sizeof(weft_backend_texture), alignof(weft_backend_texture));
}

} // namespace weft
