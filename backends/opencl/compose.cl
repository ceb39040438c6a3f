/* TILE of Wang tiles, with exchange or displacement: which places of the source a position shows, then their values. */

#pragma OPENCL FP_CONTRACT OFF

/* A place of the source. */
typedef struct Look {
    weft_place x, y;
    weft_between level;
} Look;

/* A view before exchange: a place in its cell, and its base texel. */
typedef struct View {
    weft_place x, y;
    weft_i32 texel_x, texel_y;
    weft_u32 map;
} View;

/* A view after exchange: the base, the content and its share; 0: none, 1: nothing else. */
typedef struct Shown {
    Look base, content;
    float share;
} Shown;

/* Both views of a position, and the share of the first. */
typedef struct Composition {
    Shown first, second;
    float share;
} Composition;

/* What a layer is composed by, and the level at which it is looked at, before it is clamped and after. */
typedef struct Composer {
    global const LayerLayout* layer;
    global const weft_u32* words;
    global const float* numbers;
    weft_u32 width, height; /* of the source */
    float wanted;
    weft_between level;
} Composer;

static Composer composer_of(global const LayerLayout* layer, global const LevelLayout* levels,
                            global const weft_u32* words, global const float* numbers, float level)
{
    Composer c;
    c.layer = layer;
    c.words = words;
    c.numbers = numbers;
    c.width = levels[layer->first_level].width;
    c.height = levels[layer->first_level].height;
    c.wanted = level + layer->level;
    c.level = weft_tile_level(level, layer->level, layer->levels);
    return c;
}

/* One number of a level, those of the next level being `step` further. */
static float between_levels(Composer c, weft_u32 at, weft_u32 step)
{
    global const float* numbers = c.numbers + at + (weft_u32)c.level.whole * step;
    return c.level.t > 0.0f ? weft_lerp(numbers[0], numbers[step], c.level.t) : numbers[0];
}

static float map_depth(global const weft_u32* map, weft_u32 width, weft_pair x, weft_pair y)
{
    global const weft_u32* upper = map + (size_t)y.first * width;
    global const weft_u32* lower = map + (size_t)y.second * width;
    return weft_depth(weft_map_depth(upper[x.first]), weft_map_depth(upper[x.second]), weft_map_depth(lower[x.first]),
                      weft_map_depth(lower[x.second]), x.t, y.t);
}

/* Number of the content that a patch shows, which began in a view's cell or in one before. */
static weft_u32 content_of(Composer c, View view, weft_u32 entry, global const weft_u32* patch)
{
    global const ComposedLayout* composed = &c.layer->composed;
    const weft_i64 x = weft_map_left(entry) ? weft_cell_before(view.x.cell, composed->cells_x) : view.x.cell;
    const weft_i64 y = weft_map_above(entry) ? weft_cell_before(view.y.cell, composed->cells_y) : view.y.cell;
    const weft_u32 drawn = weft_content_draw(composed->contents_key, x, y, weft_map_patch(entry));
    const weft_u32 last = patch[2] + patch[3] - 1;
    weft_u32 content = patch[2];
    while (content < last && drawn >= c.words[composed->contents + content * WEFT_CONTENT_WORDS]) ++content;
    return content;
}

static Shown base_of(Composer c, View view)
{
    Shown shown;
    shown.base.x = view.x;
    shown.base.y = view.y;
    shown.base.x.texel = view.texel_x;
    shown.base.y.texel = view.texel_y;
    shown.base.level = c.level;
    shown.content = shown.base;
    shown.share = 0.0f;
    return shown;
}

static Shown exchanged(Composer c, View view)
{
    Shown shown = base_of(c, view);
    global const ComposedLayout* composed = &c.layer->composed;
    const weft_u32 width = c.layer->grid_x.size, height = c.layer->grid_y.size;
    if (!composed->exchange) return shown;
    global const weft_u32* map = c.words + composed->map + (size_t)view.map * width * height;
    const float depth =
        map_depth(map, width, weft_pair_at(view.x, 0, 0.0f, width), weft_pair_at(view.y, 0, 0.0f, height));
    if (!(depth > 0.0f)) return shown;
    const weft_u32 entry = map[(size_t)view.y.texel * width + view.x.texel];
    global const weft_u32* patch = c.words + composed->patches + weft_map_patch(entry) * WEFT_PATCH_WORDS;
    const weft_u32 number = content_of(c, view, entry, patch);
    const float x = weft_from_anchor(view.x.texel, view.x.fraction, weft_map_left(entry), width, (weft_i32)patch[0]);
    const float y = weft_from_anchor(view.y.texel, view.y.fraction, weft_map_above(entry), height, (weft_i32)patch[1]);
    const weft_direction direction = weft_direction_of(x, y);
    global const uchar* contour =
        (global const uchar*)(c.words + composed->content_contours) + (size_t)number * 4 * WEFT_CONTOUR_SIDE;
    const float contour_depth =
        weft_lerp((float)contour[direction.first], (float)contour[direction.second], direction.t);
    shown.share = weft_content_share(depth, contour_depth, between_levels(c, composed->feather, 1));
    global const weft_u32* content = c.words + composed->contents + number * WEFT_CONTENT_WORDS;
    const float4 turn = (float4)(as_float(content[3]), as_float(content[4]), as_float(content[5]), as_float(content[6]));
    shown.content.x = weft_content_place((weft_i32)content[1], turn.x * x + turn.y * y);
    shown.content.y = weft_content_place((weft_i32)content[2], turn.z * x + turn.w * y);
    shown.content.x.texel = weft_wrap(shown.content.x.texel, c.width);
    shown.content.y.texel = weft_wrap(shown.content.y.texel, c.height);
    shown.content.level = weft_tile_level(c.wanted, as_float(content[7]), c.layer->levels);
    return shown;
}

static View wang_view(Composer c, weft_place x, weft_place y, weft_u32 map)
{
    global const weft_u32* corner = c.words + c.layer->composed.diamonds + 2 * map;
    View view;
    view.x = x;
    view.y = y;
    view.texel_x = weft_wang_texel((weft_i32)corner[0], x.texel, c.width);
    view.texel_y = weft_wang_texel((weft_i32)corner[1], y.texel, c.height);
    view.map = map;
    return view;
}

static Composition compose_wang(Composer c, weft_place x, weft_place y)
{
    global const ComposedLayout* wang = &c.layer->composed;
    const weft_half half_x = weft_half_at(x, c.layer->grid_x.size, wang->unit_x);
    const weft_half half_y = weft_half_at(y, c.layer->grid_y.size, wang->unit_y);
    weft_place north = y, west = x;
    if (half_y.second) north.cell = weft_cell_after(y.cell, wang->cells_y);
    if (half_x.second) west.cell = weft_cell_after(x.cell, wang->cells_x);
    north.texel = half_y.texel;
    west.texel = half_x.texel;
    const weft_u32 a = weft_wang_colour(wang->north, x.cell, north.cell, wang->colours);
    const weft_u32 b = weft_wang_colour(wang->west, west.cell, y.cell, wang->colours);
    const weft_knot knot = weft_wang_knot(half_x.distance, half_y.distance, wang->knots);
    const weft_u32 row = weft_wang_contour(half_y.second, half_x.second, a, b, wang->colours);
    global const char* depths =
        (global const char*)(c.words + wang->contours) + (size_t)row * (wang->knots + 1) + knot.k;
    const weft_u32 sharp = wang->sharp + (weft_u32)knot.k;
    Composition made;
    made.share = weft_wang_share(knot, (float)depths[0], (float)depths[1], between_levels(c, sharp, wang->knots + 1),
                                 between_levels(c, sharp + 1, wang->knots + 1));
    const View first = wang_view(c, x, north, a), second = wang_view(c, west, y, wang->colours + b);
    if (made.share > 0.0f) made.first = exchanged(c, first);
    if (!(made.share >= 1.0f)) made.second = exchanged(c, second);
    return made;
}

static Composition compose(Composer c, weft_place x, weft_place y)
{
    if (c.layer->composed.colours) return compose_wang(c, x, y);
    View view;
    view.x = x;
    view.y = y;
    view.texel_x = x.texel;
    view.texel_y = y.texel;
    view.map = 0;
    Composition made;
    made.first = exchanged(c, view);
    made.share = 1.0f;
    return made;
}

static float4 look_at(Look look, global const LevelLayout* levels, global const float4* texels, weft_u32 group)
{
    global const LevelLayout* level = levels + look.level.whole;
    const float4 f = tile_level(level, texels, look.x, look.y, look.level.whole, group);
    if (!(look.level.t > 0.0f)) return f;
    return lerp4(f, tile_level(level + 1, texels, look.x, look.y, look.level.whole + 1, group), look.level.t);
}

static float4 shown_at(Shown shown, global const LevelLayout* levels, global const float4* texels, weft_u32 group)
{
    if (shown.share >= 1.0f) return look_at(shown.content, levels, texels, group);
    const float4 f = look_at(shown.base, levels, texels, group);
    if (!(shown.share > 0.0f)) return f;
    return lerp4(f, look_at(shown.content, levels, texels, group), shown.share);
}

static float4 composed_at(Composition made, global const LevelLayout* levels, global const float4* texels,
                          weft_u32 group)
{
    if (made.share >= 1.0f) return shown_at(made.first, levels, texels, group);
    const float4 f = shown_at(made.second, levels, texels, group);
    if (!(made.share > 0.0f)) return f;
    return lerp4(f, shown_at(made.first, levels, texels, group), made.share);
}

static weft_place moved(weft_place at, float pixels, GridLayout grid, weft_u32 cells)
{
    return weft_displace(at, pixels, grid.step, grid.size, cells);
}

kernel __attribute__((reqd_work_group_size(64, 1, 1))) void
tile_composed(global const LayerLayout* layers, global const LevelLayout* levels, global const float4* texels,
              global const SpotLayout* spots, global float* field, SamplesLayout samples, weft_u32 index,
              global const weft_u32* words, global const float* numbers)
{
    const weft_u32 column = get_global_id(0), row = get_global_id(1);
    if (column >= samples.width) return;
    global const LayerLayout* layer = layers + index;
    const Position at = position_of(samples, spots, column, row);
    weft_place x = locate(at.x, at.fraction_x, layer->period_x, layer->grid_x);
    weft_place y = locate(at.y, at.fraction_y, layer->period_y, layer->grid_y);
    if (layer->composed.moved_layer != WEFT_NONE) {
        const weft_u32 plane = layers[layer->composed.moved_layer].plane_slot + layer->composed.moved_plane;
        global const float* pixels =
            field + (size_t)plane * samples.pitch + (size_t)row * samples.stride + column;
        x = moved(x, pixels[0], layer->grid_x, layer->composed.cells_x);
        y = moved(y, pixels[samples.pitch], layer->grid_y, layer->composed.cells_y);
    }
    const Composition made = compose(composer_of(layer, levels, words, numbers, at.level), x, y);
    for (weft_u32 group = 0; group * 4 < layer->planes; ++group)
        store_group(field, layer, samples, column, row, group,
                    composed_at(made, levels + layer->first_level, texels, group));
}
