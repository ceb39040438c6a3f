/// Tables of TILE: grids, and what Wang tiles and content exchange are made of.
#include "opencl/host.h"
#include "opencl/tables.h"
#include <algorithm>

namespace weft::opencl {

namespace {

weft_u32 bits_of(float number)
{
    weft_u32 bits;
    std::memcpy(&bits, &number, sizeof bits);
    return bits;
}

std::uint32_t content_count(const weft_exchange& exchange)
{
    std::uint32_t count = 0;
    for (std::uint32_t p = 0; p < exchange.patch_count; ++p)
        count = std::max(count, exchange.patches[p].first + exchange.patches[p].count);
    return count;
}

} // namespace

void Tables::add_tile(const weft_layer& layer, LayerLayout& to)
{
    const weft_tile& tile = *layer.tile;
    to.level = tile.level;
    to.images = 1;
    to.grid_x = {tile.x.span, tile.x.cells, tile.width, tile.x.inverse, tile.x.step};
    to.grid_y = {tile.y.span, tile.y.cells, tile.height, tile.y.inverse, tile.y.step};
    ComposedLayout& composed = to.composed;
    composed.north = weft_key(program.seed, layer.stream, WEFT_TAG_NORTH);
    composed.west = weft_key(program.seed, layer.stream, WEFT_TAG_WEST);
    composed.contents_key = weft_key(program.seed, layer.stream, WEFT_TAG_CONTENTS);
    composed.cells_x = program.period[0] != 0 ? tile.x.cells : 0;
    composed.cells_y = program.period[1] != 0 ? tile.y.cells : 0;
    composed.moved_layer = layer_of(tile.displacement);
    composed.moved_plane = tile.displacement.plane;
    if (tile.wang) add_wang(tile, composed);
    if (tile.exchange) add_exchange(tile, composed);
    add_levels(*tile.source, to);
}

void Tables::add_wang(const weft_tile& tile, ComposedLayout& to)
{
    const weft_wang& wang = *tile.wang;
    const std::size_t knots = std::size_t{wang.knots} + 1;
    to.colours = wang.colours;
    to.knots = wang.knots;
    to.unit_x = wang.unit_x;
    to.unit_y = wang.unit_y;
    to.diamonds = add_bytes(wang.diamonds, 2 * std::size_t{wang.colours} * sizeof *wang.diamonds);
    to.contours = add_bytes(wang.contours, 4 * std::size_t{wang.colours} * wang.colours * knots);
    to.sharp = static_cast<weft_u32>(numbers.size());
    numbers.insert(numbers.end(), wang.sharp, wang.sharp + tile.source->levels * knots);
}

void Tables::add_exchange(const weft_tile& tile, ComposedLayout& to)
{
    const weft_exchange& exchange = *tile.exchange;
    const std::size_t views = tile.wang ? 2 * std::size_t{tile.wang->colours} : 1;
    const std::uint32_t count = content_count(exchange);
    static_assert(sizeof *exchange.patches == WEFT_PATCH_WORDS * sizeof(weft_u32));
    to.exchange = 1;
    to.map = add_bytes(exchange.map, views * tile.width * tile.height * sizeof *exchange.map);
    to.patches = add_bytes(exchange.patches, std::size_t{exchange.patch_count} * sizeof *exchange.patches);
    to.contents = static_cast<weft_u32>(words.size());
    for (const weft_content* c = exchange.contents; c != exchange.contents + count; ++c)
        words.insert(words.end(),
                     {c->until, static_cast<weft_u32>(c->x), static_cast<weft_u32>(c->y), bits_of(c->turn[0]),
                      bits_of(c->turn[1]), bits_of(c->turn[2]), bits_of(c->turn[3]), bits_of(c->level)});
    to.content_contours = add_bytes(exchange.contours, std::size_t{count} * WEFT_CONTOUR);
    to.feather = static_cast<weft_u32>(numbers.size());
    numbers.insert(numbers.end(), exchange.feather, exchange.feather + tile.source->levels);
}

/// Returns where in words.
weft_u32 Tables::add_bytes(const void* bytes, std::size_t count)
{
    const std::size_t at = words.size();
    words.resize(at + (count + sizeof(weft_u32) - 1) / sizeof(weft_u32));
    if (words.size() > INT32_MAX)
        throw Failure(WEFT_ERROR_UNSUPPORTED, "opencl: the program's tables have ", words.size(), " words");
    std::memcpy(words.data() + at, bytes, count);
    return static_cast<weft_u32>(at);
}

} // namespace weft::opencl
