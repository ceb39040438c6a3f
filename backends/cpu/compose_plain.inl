/// TILE with WANG or exchange in plain loops: the reference. Included by rows.inl, inside its unnamed namespace.

/// Both axes of where something is looked up.
struct Spot_place {
    weft_place x, y;
};

/// What a position shows of a view, before exchange.
struct View {
    Spot_place cell;          ///< in the view's cell
    int32_t texel_x, texel_y; ///< of the source
    uint32_t map;
};

/// What exchange put into a view, and its share of it; 0: nothing.
struct Content {
    Spot_place source;
    float level, share;
};

float source_texel(const weft_mip& mip, uint32_t plane, int32_t x, int32_t y)
{
    return mip.data[(size_t(plane) * mip.height + size_t(y)) * mip.width + size_t(x)];
}

float source_level(const weft_mips& source, const Spot_place& at, int32_t level, uint32_t plane)
{
    const weft_mip& mip = source.level[level];
    const weft_pair x = weft_pair_at(at.x, level, mip.scale_x, mip.width);
    const weft_pair y = weft_pair_at(at.y, level, mip.scale_y, mip.height);
    const float upper =
        weft_lerp(source_texel(mip, plane, x.first, y.first), source_texel(mip, plane, x.second, y.first), x.t);
    const float lower =
        weft_lerp(source_texel(mip, plane, x.first, y.second), source_texel(mip, plane, x.second, y.second), x.t);
    return weft_lerp(upper, lower, y.t);
}

float source_value(const weft_mips& source, const Spot_place& at, const weft_between& level, uint32_t plane)
{
    const float f = source_level(source, at, level.whole, plane);
    return level.t > 0 ? weft_lerp(f, source_level(source, at, level.whole + 1, plane), level.t) : f;
}

/// Two views, and the share of the first, that of the north or south edge.
struct Views {
    View view[2];
    float share;
};

View view_of(const Composed& c, const Spot_place& at, uint32_t map, int32_t texel_x, int32_t texel_y)
{
    const weft_diamond& diamond = c.tile->wang->diamonds[map];
    View view = {at, weft_wang_texel(diamond.x, texel_x, c.tile->source->width),
                 weft_wang_texel(diamond.y, texel_y, c.tile->source->height), map};
    view.cell.x.texel = texel_x;
    view.cell.y.texel = texel_y;
    return view;
}

/// Sharpness of the contours' feather at a knot.
float sharp_at(const weft_wang& wang, const weft_between& level, int32_t knot)
{
    const float* sharp = wang.sharp + size_t(level.whole) * (wang.knots + 1) + size_t(knot);
    return level.t > 0 ? weft_lerp(sharp[0], sharp[wang.knots + 1], level.t) : sharp[0];
}

Views views_at(const Composed& c, const Spot_place& at, const weft_between& level)
{
    const weft_wang& wang = *c.tile->wang;
    const weft_half x = weft_half_at(at.x, c.tile->width, wang.unit_x);
    const weft_half y = weft_half_at(at.y, c.tile->height, wang.unit_y);
    Spot_place north = at, west = at;
    if (y.second != 0) north.y.cell = weft_cell_after(at.y.cell, c.cells[1]);
    if (x.second != 0) west.x.cell = weft_cell_after(at.x.cell, c.cells[0]);
    const uint32_t a = weft_wang_colour(c.north, north.x.cell, north.y.cell, wang.colours);
    const uint32_t b = weft_wang_colour(c.west, west.x.cell, west.y.cell, wang.colours);
    const weft_knot knot = weft_wang_knot(x.distance, y.distance, wang.knots);
    const int8_t* depths =
        wang.contours + size_t(weft_wang_contour(y.second, x.second, a, b, wang.colours)) * (wang.knots + 1) + knot.k;
    return {{view_of(c, north, a, at.x.texel, y.texel), view_of(c, west, wang.colours + b, x.texel, at.y.texel)},
            weft_wang_share(knot, float(depths[0]), float(depths[1]), sharp_at(wang, level, knot.k),
                            sharp_at(wang, level, knot.k + 1))};
}

float depth_at(const weft_tile& tile, const View& view)
{
    const weft_pair x = weft_pair_at(view.cell.x, 0, 0.0f, tile.width);
    const weft_pair y = weft_pair_at(view.cell.y, 0, 0.0f, tile.height);
    const uint32_t* map = tile.exchange->map + size_t(view.map) * tile.width * tile.height;
    const uint32_t* upper = map + size_t(y.first) * tile.width;
    const uint32_t* lower = map + size_t(y.second) * tile.width;
    return weft_depth(weft_map_depth(upper[x.first]), weft_map_depth(upper[x.second]), weft_map_depth(lower[x.first]),
                      weft_map_depth(lower[x.second]), x.t, y.t);
}

/// Number of the content that a patch shows, which began in the cell of a view or in one before.
uint32_t content_of(const Composed& c, const View& view, uint32_t entry)
{
    const weft_exchange& exchange = *c.tile->exchange;
    const uint32_t patch = weft_map_patch(entry);
    int64_t x = view.cell.x.cell, y = view.cell.y.cell;
    if (weft_map_left(entry) != 0) x = weft_cell_before(x, c.cells[0]);
    if (weft_map_above(entry) != 0) y = weft_cell_before(y, c.cells[1]);
    const uint32_t draw = weft_content_draw(c.contents, x, y, patch);
    uint32_t content = exchange.patches[patch].first;
    const uint32_t last = content + exchange.patches[patch].count - 1;
    while (content < last && draw >= exchange.contents[content].until) ++content;
    return content;
}

float content_depth(const uint8_t* contour, float x, float y)
{
    const weft_direction direction = weft_direction_of(x, y);
    return weft_lerp(float(contour[direction.first]), float(contour[direction.second]), direction.t);
}

/// `wanted` is the level before it is clamped.
Content content_at(const Composed& c, const View& view, float wanted, const weft_between& level)
{
    const weft_tile& tile = *c.tile;
    const weft_exchange& exchange = *tile.exchange;
    const float depth = depth_at(tile, view);
    if (!(depth > 0)) return {};
    const weft_place &x = view.cell.x, &y = view.cell.y;
    const uint32_t entry =
        exchange.map[(size_t(view.map) * tile.height + size_t(y.texel)) * tile.width + size_t(x.texel)];
    const weft_patch& patch = exchange.patches[weft_map_patch(entry)];
    const uint32_t number = content_of(c, view, entry);
    const weft_content& content = exchange.contents[number];
    const float dx = weft_from_anchor(x.texel, x.fraction, weft_map_left(entry), tile.width, patch.x);
    const float dy = weft_from_anchor(y.texel, y.fraction, weft_map_above(entry), tile.height, patch.y);
    const float* feather = exchange.feather + level.whole;
    const float share =
        weft_content_share(depth, content_depth(exchange.contours + size_t(number) * WEFT_CONTOUR, dx, dy),
                           level.t > 0 ? weft_lerp(feather[0], feather[1], level.t) : feather[0]);
    const float* turn = content.turn;
    return {{weft_content_place(content.x, turn[0] * dx + turn[1] * dy, tile.source->width),
             weft_content_place(content.y, turn[2] * dx + turn[3] * dy, tile.source->height)},
            wanted + content.level,
            share};
}

void view_values(const Composed& c, const View& view, float wanted, const weft_between& level, uint32_t first,
                 uint32_t planes, float* f)
{
    const weft_mips& source = *c.tile->source;
    Spot_place base = view.cell;
    base.x.texel = view.texel_x;
    base.y.texel = view.texel_y;
    Content content = {};
    if (c.tile->exchange) content = content_at(c, view, wanted, level);
    const weft_between content_level = weft_tile_level(content.level, 0.0f, source.levels);
    for (uint32_t p = 0; p < planes; ++p) {
        if (!(content.share >= 1)) f[p] = source_value(source, base, level, first + p);
        if (!(content.share > 0)) continue;
        const float g = source_value(source, content.source, content_level, first + p);
        f[p] = content.share >= 1 ? g : weft_lerp(f[p], g, content.share);
    }
}

void compose(const Composed& c, const Places* places, uint32_t count, float level, uint32_t first, uint32_t planes,
             float* f, size_t pitch)
{
    const float wanted = level + c.tile->level;
    const weft_between at_level = weft_tile_level(level, c.tile->level, c.tile->source->levels);
    for (uint32_t i = 0; i < count; ++i) {
        const Spot_place at = {{places[0].cell[i], places[0].texel[i], places[0].fraction[i]},
                               {places[1].cell[i], places[1].texel[i], places[1].fraction[i]}};
        float values[2][most_planes];
        if (c.tile->address == WEFT_ADDRESS_CELLS) {
            view_values(c, {at, at.x.texel, at.y.texel, 0}, wanted, at_level, first, planes, values[0]);
        } else {
            const Views views = views_at(c, at, at_level);
            if (views.share > 0) view_values(c, views.view[0], wanted, at_level, first, planes, values[0]);
            if (!(views.share >= 1)) view_values(c, views.view[1], wanted, at_level, first, planes, values[1]);
            for (uint32_t p = 0; p < planes && !(views.share >= 1); ++p)
                values[0][p] = views.share > 0 ? weft_lerp(values[1][p], values[0][p], views.share) : values[1][p];
        }
        for (uint32_t p = 0; p < planes; ++p) f[p * pitch + i] = values[0][p];
    }
}
