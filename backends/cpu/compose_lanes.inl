/// Views of many places at once: what depends on no hash and no patch goes through vectors of places. The same bits as
/// Looker's. Included by rows.inl, inside its unnamed namespace.

constexpr uint32_t composed_together = 32; ///< places
constexpr uint32_t most_views = 2 * composed_together;

/// One axis of some places: where in the cell, how many cells to the side displacement took them; then, for Wang tiles,
/// weft_half.
struct Lane_axis {
    alignas(64) int32_t texel[composed_together], side[composed_together];
    alignas(64) float fraction[composed_together];
    alignas(64) int32_t second[composed_together], seen[composed_together];
    alignas(64) float distance[composed_together];
};

/// Quarters of cells that places lie in, and of each, both views, that of the north or south edge and the other: cells,
/// corners of diamonds, maps.
struct Quarters {
    int64_t cell[2][most_views]; ///< of axis; view w of quarter q is at 2 q + w
    alignas(64) int32_t corner[2][most_views];
    const uint32_t* map[most_views];
    alignas(64) int32_t contour[composed_together]; ///< of the quarter
};

/// One axis of views: where in the view's cell, where in the source, and the taps of the map.
struct View_axis {
    alignas(64) int32_t texel[most_views], corner[most_views], base[most_views], first[most_views], next[most_views];
    alignas(64) float fraction[most_views], t[most_views];
};

/// One axis of where the bases of views are read at one level.
struct Base_axis {
    alignas(64) int32_t first[most_views];
    alignas(64) float t[most_views];
};

class Composer {
public:
    Composer(const Composed& c, Looker& looker) : c_(c), tile_(*c.tile), looker_(looker) {}

    /// Places begin..begin + count - 1, at most composed_together. The first view of place i is view i; second views,
    /// which only some places have, come from view composed_together on.
    void find(const Axis_places* places, uint32_t begin, uint32_t count)
    {
        const float steps[2] = {tile_.x.step, tile_.y.step};
        for (uint32_t a = 0; a < 2; ++a) move(places[a], begin, count, steps[a], size(a), axis_[a]);
        if (tile_.wang) halve();
        find_quarters(places, begin, count);
        for (uint32_t i = 0; i < composed_together; ++i) share_[i] = 1;
        if (tile_.wang) find_shares();
        choose(count);
        find_bases();
        if (tile_.exchange) find_depths();
    }

    /// Of the north or south edge's view, which is the first one if it is 1 and the second one if it is between 0
    /// and 1.
    float share(uint32_t i) const { return share_[i]; }

    /// Where the base of a view is read, at the level of the places or the next one.
    const Base_axis& bases(uint32_t axis, bool next) const { return bases_[next ? 1 : 0][axis]; }

    Content content(uint32_t v, uint32_t slot) const
    {
        if (!tile_.exchange || !(depth_[v] > 0)) return {};
        return looker_.content({{quarters_.cell[0][of_[v]], view_[0].texel[v], view_[0].fraction[v]},
                                {quarters_.cell[1][of_[v]], view_[1].texel[v], view_[1].fraction[v]}},
                               entry_[v], depth_[v], slot);
    }

private:
    uint32_t size(uint32_t a) const { return a == 0 ? tile_.width : tile_.height; }

    static void move(const Axis_places& places, uint32_t begin, uint32_t count, float step, uint32_t size,
                     Lane_axis& to)
    {
        const uint32_t from = begin * places.step;
        for (uint32_t i = 0; i < composed_together; ++i) {
            const uint32_t n = from + (i < count ? i : 0) * places.step;
            to.texel[i] = places.texel[n];
            to.fraction[i] = places.fraction[n];
            to.side[i] = to.second[i] = 0;
        }
        if (places.moved) {
            alignas(64) float moved[composed_together] = {0};
            for (uint32_t i = 0; i < count; ++i) moved[i] = places.moved[begin + i];
            for (uint32_t i = 0; i < composed_together; ++i) {
                const weft_place at = weft_displace({0, to.texel[i], to.fraction[i]}, moved[i], step, size, 0);
                to.texel[i] = at.texel;
                to.fraction[i] = at.fraction;
                to.side[i] = int32_t(at.cell);
            }
        }
        for (uint32_t i = 0; i < composed_together; ++i) to.seen[i] = to.texel[i];
    }

    void halve()
    {
        for (uint32_t a = 0; a < 2; ++a) {
            Lane_axis& axis = axis_[a];
            const float unit = a == 0 ? tile_.wang->unit_x : tile_.wang->unit_y;
            for (uint32_t i = 0; i < composed_together; ++i) {
                const weft_half half = weft_half_at({0, axis.texel[i], axis.fraction[i]}, size(a), unit);
                axis.second[i] = int32_t(half.second);
                axis.seen[i] = half.texel;
                axis.distance[i] = half.distance;
            }
        }
    }

    int64_t cell(const Axis_places& places, uint32_t a, uint32_t n, uint32_t i) const
    {
        const int64_t cell = places.cell[n * places.step];
        if (axis_[a].side[i] == 0) return cell;
        return axis_[a].side[i] > 0 ? weft_cell_after(cell, c_.cells[a]) : weft_cell_before(cell, c_.cells[a]);
    }

    /// Neighbours are mostly in the same quarter. Cells of neighbours are less than 2^32 apart.
    void find_quarters(const Axis_places* places, uint32_t begin, uint32_t count)
    {
        alignas(64) uint32_t cells[2][composed_together] = {{0}}, parts[composed_together];
        for (uint32_t a = 0; a < 2; ++a)
            for (uint32_t i = 0; i < count && places[a].step != 0; ++i)
                cells[a][i] = uint32_t(places[a].cell[begin + i]);
        for (uint32_t i = 0; i < composed_together; ++i)
            parts[i] = uint32_t(axis_[0].side[i] + 1 + 4 * (axis_[1].side[i] + 1) + 16 * axis_[0].second[i] +
                                32 * axis_[1].second[i]);
        alignas(64) uint32_t changes[composed_together] = {1};
        for (uint32_t i = 1; i < composed_together; ++i)
            changes[i] = (parts[i] ^ parts[i - 1]) | (cells[0][i] ^ cells[0][i - 1]) | (cells[1][i] ^ cells[1][i - 1]);
        uint32_t quarters = 0;
        for (uint32_t i = 0; i < count; ++i) {
            if (changes[i] != 0)
                set_quarter(quarters++, cell(places[0], 0, begin + i, i), cell(places[1], 1, begin + i, i), i);
            quarter_[i] = int32_t(quarters) - 1;
        }
        for (uint32_t i = count; i < composed_together; ++i) quarter_[i] = int32_t(quarters) - 1;
    }

    void set_view_of_quarter(uint32_t n, int64_t x, int64_t y, uint32_t map)
    {
        quarters_.cell[0][n] = x;
        quarters_.cell[1][n] = y;
        quarters_.corner[0][n] = tile_.wang ? tile_.wang->diamonds[map].x : 0;
        quarters_.corner[1][n] = tile_.wang ? tile_.wang->diamonds[map].y : 0;
        quarters_.map[n] = tile_.exchange ? looker_.map_of(map) : nullptr;
    }

    /// Quarter q is that of place i, in a cell.
    void set_quarter(uint32_t q, int64_t x, int64_t y, uint32_t i)
    {
        if (!tile_.wang) return set_view_of_quarter(2 * q, x, y, 0);
        const weft_wang& wang = *tile_.wang;
        const uint32_t east = uint32_t(axis_[0].second[i]), south = uint32_t(axis_[1].second[i]);
        const int64_t west = east != 0 ? weft_cell_after(x, c_.cells[0]) : x;
        const int64_t north = south != 0 ? weft_cell_after(y, c_.cells[1]) : y;
        const uint32_t a = looker_.north(x, north), b = looker_.west(west, y);
        set_view_of_quarter(2 * q, x, north, a);
        set_view_of_quarter(2 * q + 1, west, y, wang.colours + b);
        quarters_.contour[q] = int32_t(weft_wang_contour(south, east, a, b, wang.colours) * (wang.knots + 1));
    }

    void find_shares()
    {
        const weft_wang& wang = *tile_.wang;
        alignas(64) weft_knot knots[composed_together];
        alignas(64) float depths[2][composed_together], sharp[2][composed_together];
        for (uint32_t i = 0; i < composed_together; ++i)
            knots[i] = weft_wang_knot(axis_[0].distance[i], axis_[1].distance[i], wang.knots);
        for (uint32_t i = 0; i < composed_together; ++i) {
            const int8_t* depth = wang.contours + quarters_.contour[quarter_[i]] + knots[i].k;
            depths[0][i] = float(depth[0]);
            depths[1][i] = float(depth[1]);
            sharp[0][i] = looker_.sharp(uint32_t(knots[i].k));
            sharp[1][i] = looker_.sharp(uint32_t(knots[i].k) + 1);
        }
        for (uint32_t i = 0; i < composed_together; ++i)
            share_[i] = weft_wang_share(knots[i], depths[0][i], depths[1][i], sharp[0][i], sharp[1][i]);
    }

    void choose(uint32_t count)
    {
        alignas(64) int32_t other[composed_together];
        for (uint32_t i = 0; i < composed_together; ++i) other[i] = share_[i] >= 1 ? 0 : 1;
        for (uint32_t i = 0; i < composed_together; ++i) of_[i] = 2 * quarter_[i] + other[i];
        for (int32_t a = 0; a < 2; ++a) {
            const Lane_axis& axis = axis_[a];
            View_axis& view = view_[a];
            for (uint32_t i = 0; i < composed_together; ++i) {
                const int32_t texel = axis.texel[i], seen = axis.seen[i];
                view.texel[i] = other[i] != a ? seen : texel;
                view.fraction[i] = axis.fraction[i];
            }
            for (uint32_t i = 0; i < composed_together; ++i) view.corner[i] = quarters_.corner[a][of_[i]];
        }
        views_ = composed_together;
        for (uint32_t i = 0; i < count; ++i)
            if (share_[i] > 0 && share_[i] < 1) append_view(i);
        while (views_ % 8 != 0) append_view(0);
    }

    /// That of place i with the north or south edge.
    void append_view(uint32_t i)
    {
        const uint32_t v = views_++;
        of_[v] = 2 * quarter_[i];
        for (uint32_t a = 0; a < 2; ++a) {
            view_[a].texel[v] = a != 0 ? axis_[a].seen[i] : axis_[a].texel[i];
            view_[a].fraction[v] = axis_[a].fraction[i];
            view_[a].corner[v] = quarters_.corner[a][of_[v]];
        }
    }

    void find_bases()
    {
        const weft_mips& source = *tile_.source;
        const weft_between level = looker_.level();
        for (uint32_t a = 0; a < 2; ++a) {
            View_axis& view = view_[a];
            const uint32_t length = a == 0 ? source.width : source.height;
            for (uint32_t v = 0; v < views_; ++v) view.base[v] = weft_wang_texel(view.corner[v], view.texel[v], length);
            for (uint32_t n = 0; n < (level.t > 0 ? 2u : 1u); ++n) {
                const weft_mip& mip = source.level[uint32_t(level.whole) + n];
                find_pairs(view.base, view.fraction, level.whole + int32_t(n), a == 0 ? mip.scale_x : mip.scale_y,
                           a == 0 ? mip.width : mip.height, bases_[n][a].first, nullptr, bases_[n][a].t);
            }
        }
    }

    /// `next` may be null.
    void find_pairs(const int32_t* texel, const float* fraction, int32_t level, float scale, uint32_t length,
                    int32_t* __restrict first, int32_t* __restrict next, float* __restrict t) const
    {
        for (uint32_t v = 0; v < views_; ++v) {
            const weft_pair pair = weft_pair_at({0, texel[v], fraction[v]}, level, scale, length);
            first[v] = pair.first;
            t[v] = pair.t;
        }
        for (uint32_t v = 0; v < views_ && next; ++v) next[v] = first[v] + 1 == int32_t(length) ? 0 : first[v] + 1;
    }

    void find_depths()
    {
        alignas(64) uint32_t entries[4][most_views];
        const View_axis &x = view_[0], &y = view_[1];
        for (uint32_t a = 0; a < 2; ++a)
            find_pairs(view_[a].texel, view_[a].fraction, 0, 0.0f, size(a), view_[a].first, view_[a].next, view_[a].t);
        for (uint32_t v = 0; v < views_; ++v) {
            const uint32_t* map = quarters_.map[of_[v]];
            const uint32_t* upper = map + size_t(y.first[v]) * tile_.width;
            const uint32_t* lower = map + size_t(y.next[v]) * tile_.width;
            entries[0][v] = upper[x.first[v]];
            entries[1][v] = upper[x.next[v]];
            entries[2][v] = lower[x.first[v]];
            entries[3][v] = lower[x.next[v]];
            entry_[v] = map[size_t(y.texel[v]) * tile_.width + size_t(x.texel[v])];
        }
        for (uint32_t v = 0; v < views_; ++v)
            depth_[v] = weft_depth(weft_map_depth(entries[0][v]), weft_map_depth(entries[1][v]),
                                   weft_map_depth(entries[2][v]), weft_map_depth(entries[3][v]), x.t[v], y.t[v]);
    }

    const Composed& c_;
    const weft_tile& tile_;
    Looker& looker_;
    Lane_axis axis_[2];
    Quarters quarters_;
    alignas(64) float share_[composed_together];
    uint32_t views_ = 0; ///< a multiple of 8
    View_axis view_[2];
    Base_axis bases_[2][2];
    alignas(64) int32_t quarter_[composed_together];
    alignas(64) int32_t of_[most_views]; ///< which view of which quarter
    alignas(64) uint32_t entry_[most_views];
    alignas(64) float depth_[most_views];
};
