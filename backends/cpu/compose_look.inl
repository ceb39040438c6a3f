/// TILE with WANG or exchange: which places of the source a position shows. Included by rows.inl, inside its unnamed
/// namespace. Hashes are kept from position to position, since neighbours are in the same cells and patches.

/// Both axes of where something is looked up.
struct Spot_place {
    weft_place x, y;
};

/// What a position shows of a view, before exchange.
struct View {
    Spot_place cell;          ///< in the view's cell
    int32_t texel_x, texel_y; ///< of the source
    uint32_t map;

    Spot_place base() const { return {{0, texel_x, cell.x.fraction}, {0, texel_y, cell.y.fraction}}; }
};

/// What exchange put into a view, and its share of it; 0: nothing.
struct Content {
    Spot_place source;
    weft_between level;
    float share;
};

/// The colours of edges, as they were hashed last.
class Colours {
public:
    Colours(uint64_t key, uint32_t colours) : key_(key), colours_(colours) {}

    uint32_t at(int64_t x, int64_t y)
    {
        Held& held = held_[(x & 1) + 2 * (y & 1)];
        if (held.colour == none || held.x != x || held.y != y) held = {x, y, weft_wang_colour(key_, x, y, colours_)};
        return held.colour;
    }

private:
    static constexpr uint32_t none = UINT32_MAX;
    struct Held {
        int64_t x, y;
        uint32_t colour;
    };

    uint64_t key_;
    uint32_t colours_;
    Held held_[4] = {{0, 0, none}, {0, 0, none}, {0, 0, none}, {0, 0, none}};
};

/// A level of a composed TILE, looked at.
class Looker {
public:
    Looker(const Composed& c, float level)
        : level_(weft_tile_level(level, c.tile->level, c.tile->source->levels)), c_(c), tile_(*c.tile),
          wanted_(level + tile_.level), north_(c.north, tile_.wang ? tile_.wang->colours : 0),
          west_(c.west, tile_.wang ? tile_.wang->colours : 0)
    {
        if (tile_.exchange) feather_ = between(tile_.exchange->feather + level_.whole, 1);
    }

    const weft_between& level() const { return level_; }

    /// The i-th of some places.
    Spot_place place(const Axis_places* places, uint32_t i) const
    {
        return {place(places[0], i, tile_.x.step, tile_.width, c_.cells[0]),
                place(places[1], i, tile_.y.step, tile_.height, c_.cells[1])};
    }

    /// The share of the first view, that of the north or south edge. Views without a share are left as they are.
    float views(const Spot_place& at, View& first, View& second)
    {
        if (!tile_.wang) {
            first = {at, at.x.texel, at.y.texel, 0};
            return 1;
        }
        const weft_wang& wang = *tile_.wang;
        const weft_half x = weft_half_at(at.x, tile_.width, wang.unit_x);
        const weft_half y = weft_half_at(at.y, tile_.height, wang.unit_y);
        const int64_t north = y.second != 0 ? weft_cell_after(at.y.cell, c_.cells[1]) : at.y.cell;
        const int64_t west = x.second != 0 ? weft_cell_after(at.x.cell, c_.cells[0]) : at.x.cell;
        const uint32_t a = north_.at(at.x.cell, north), b = west_.at(west, at.y.cell);
        const weft_knot knot = weft_wang_knot(x.distance, y.distance, wang.knots);
        const size_t row = weft_wang_contour(y.second, x.second, a, b, wang.colours);
        const int8_t* depths = wang.contours + row * (wang.knots + 1) + knot.k;
        const float share = weft_wang_share(knot, float(depths[0]), float(depths[1]), sharp(uint32_t(knot.k)),
                                            sharp(uint32_t(knot.k) + 1));
        if (share > 0) first = view(at.x, {north, y.texel, at.y.fraction}, a);
        if (!(share >= 1)) second = view({west, x.texel, at.x.fraction}, at.y, wang.colours + b);
        return share;
    }

    /// `slot` is 0 or 1: whose hashes to keep.
    Content content(const View& view, uint32_t slot)
    {
        const uint32_t* map = map_of(view.map);
        const float depth = depth_at(map, view.cell);
        if (!(depth > 0)) return {};
        return content(view.cell, map[size_t(view.cell.y.texel) * tile_.width + size_t(view.cell.x.texel)], depth,
                       slot);
    }

    /// The same where the map has this entry and this depth, which is above 0.
    Content content(const Spot_place& at, uint32_t entry, float depth, uint32_t slot)
    {
        const weft_patch& patch = tile_.exchange->patches[weft_map_patch(entry)];
        const uint32_t number = content_of(at, entry, held_[slot]);
        const float dx = weft_from_anchor(at.x.texel, at.x.fraction, weft_map_left(entry), tile_.width, patch.x);
        const float dy = weft_from_anchor(at.y.texel, at.y.fraction, weft_map_above(entry), tile_.height, patch.y);
        const float share = share_of(number, depth, dx, dy);
        if (!(share > 0)) return {};
        const weft_between level =
            weft_tile_level(wanted_, tile_.exchange->contents[number].level, tile_.source->levels);
        return {content_place(number, dx, dy), level, share};
    }

    const uint32_t* map_of(uint32_t view) const
    {
        return tile_.exchange->map + size_t(view) * tile_.width * tile_.height;
    }

    /// Sharpness of contours at a knot.
    float sharp(uint32_t knot) const
    {
        const weft_wang& wang = *tile_.wang;
        return between(wang.sharp + size_t(level_.whole) * (wang.knots + 1) + knot, wang.knots + 1);
    }

    /// Colour of a cell's north edge, of its west edge.
    uint32_t north(int64_t x, int64_t y) { return north_.at(x, y); }
    uint32_t west(int64_t x, int64_t y) { return west_.at(x, y); }

private:
    /// The content that was hashed last: of an entry of the map, but for its depth, in a cell.
    struct Held {
        int64_t x, y;
        uint32_t place, content;
    };

    static weft_place place(const Axis_places& places, uint32_t i, float step, uint32_t size, uint32_t cells)
    {
        const uint32_t n = i * places.step;
        const weft_place at = {places.cell[n], places.texel[n], places.fraction[n]};
        return places.moved ? weft_displace(at, places.moved[i], step, size, cells) : at;
    }

    /// Where a content looks, at a distance from its anchor.
    Spot_place content_place(uint32_t number, float x, float y) const
    {
        const weft_content& content = tile_.exchange->contents[number];
        const float* turn = content.turn;
        Spot_place at = {weft_content_place(content.x, turn[0] * x + turn[1] * y),
                         weft_content_place(content.y, turn[2] * x + turn[3] * y)};
        at.x.texel = weft_wrap(at.x.texel, tile_.source->width);
        at.y.texel = weft_wrap(at.y.texel, tile_.source->height);
        return at;
    }

    /// One number of a level, those of the next level being `step` further.
    float between(const float* numbers, size_t step) const
    {
        return level_.t > 0 ? weft_lerp(numbers[0], numbers[step], level_.t) : numbers[0];
    }

    View view(const weft_place& x, const weft_place& y, uint32_t map) const
    {
        if (tile_.exchange) __builtin_prefetch(map_of(map) + size_t(y.texel) * tile_.width + size_t(x.texel));
        const weft_diamond& diamond = tile_.wang->diamonds[map];
        return {{x, y},
                weft_wang_texel(diamond.x, x.texel, tile_.source->width),
                weft_wang_texel(diamond.y, y.texel, tile_.source->height),
                map};
    }

    float depth_at(const uint32_t* map, const Spot_place& at) const
    {
        const weft_pair x = weft_pair_at(at.x, 0, 0.0f, tile_.width), y = weft_pair_at(at.y, 0, 0.0f, tile_.height);
        const uint32_t* upper = map + size_t(y.first) * tile_.width;
        const uint32_t* lower = map + size_t(y.second) * tile_.width;
        return weft_depth(weft_map_depth(upper[x.first]), weft_map_depth(upper[x.second]),
                          weft_map_depth(lower[x.first]), weft_map_depth(lower[x.second]), x.t, y.t);
    }

    /// Share of a content. A contour is looked at only where it decides, with a margin that no rounding reaches.
    float share_of(uint32_t content, float depth, float x, float y) const
    {
        constexpr float margin = 0x1p-10f;
        const Contour_range range = c_.ranges[content];
        if (weft_content_share(depth, float(range.least), feather_) <= -margin) return 0;
        if (weft_content_share(depth, float(range.most), feather_) >= 1 + margin) return 1;
        const uint8_t* contour = tile_.exchange->contours + size_t(content) * WEFT_CONTOUR;
        const weft_direction direction = weft_direction_of(x, y);
        const float shown = weft_lerp(float(contour[direction.first]), float(contour[direction.second]), direction.t);
        return weft_content_share(depth, shown, feather_);
    }

    /// Number of the content that a patch shows, which began in this cell or in one before.
    uint32_t content_of(const Spot_place& at, uint32_t entry, Held& held) const
    {
        const weft_exchange& exchange = *tile_.exchange;
        const uint32_t place = entry & (WEFT_MAP_PATCH | WEFT_MAP_LEFT | WEFT_MAP_ABOVE);
        if (held.place == place && held.x == at.x.cell && held.y == at.y.cell) return held.content;
        const int64_t x = weft_map_left(entry) != 0 ? weft_cell_before(at.x.cell, c_.cells[0]) : at.x.cell;
        const int64_t y = weft_map_above(entry) != 0 ? weft_cell_before(at.y.cell, c_.cells[1]) : at.y.cell;
        const uint32_t patch = weft_map_patch(entry), draw = weft_content_draw(c_.contents, x, y, patch);
        uint32_t content = exchange.patches[patch].first;
        const uint32_t last = content + exchange.patches[patch].count - 1;
        while (content < last && draw >= exchange.contents[content].until) ++content;
        held = {at.x.cell, at.y.cell, place, content};
        return content;
    }

    weft_between level_;
    const Composed& c_;
    const weft_tile& tile_;
    float wanted_; ///< the level before it is clamped
    float feather_ = 0;
    Colours north_, west_;
    Held held_[2] = {{0, 0, UINT32_MAX, 0}, {0, 0, UINT32_MAX, 0}};
};
