/// TILE with WANG or exchange in vectors of planes: a texel's planes lie side by side, in eights, and a column and a
/// row more than there are repeat the first. Some places at a time, in three rounds: their views, what of the source
/// these show, its values; each round asks for the memory that the next one reads, since places lie scattered. Included
/// by rows.inl, inside its unnamed namespace.

/// Four texels that are joined: the first of them, floats to those below it, weights.
struct Taps {
    const float* from;
    int32_t row;
    float x, y;
};

/// A place of the source, at one level or (t > 0) between two.
struct Shown {
    Taps fine, coarse;
    float t;
};

/// Shares that are blended in: of the first view's content, of the second view, of its content. Only what has a share
/// has places in the lists.
struct Shares {
    float content, second, second_content;
};

/// What some places show, in lists that are read in the order in which they were written.
struct Composition {
    View views[most_views];
    Shown shown[2 * most_views];
    Shares shares[composed_together];
};

/// A texel of the copy of a level.
inline Taps taps_from(const Composed& c, int32_t level, int32_t x, int32_t y, float tx, float ty)
{
    const Texels& texels = c.texels[level];
    const float* from = texels.data + y * texels.row + x * int64_t(8) * c.groups;
    __builtin_prefetch(from);
    __builtin_prefetch(from + texels.row);
    return {from, int32_t(texels.row), tx, ty};
}

inline Taps taps_at(const Composed& c, const Spot_place& at, int32_t level)
{
    const weft_mip& mip = c.tile->source->level[level];
    const weft_pair x = weft_pair_at(at.x, level, mip.scale_x, mip.width);
    const weft_pair y = weft_pair_at(at.y, level, mip.scale_y, mip.height);
    return taps_from(c, level, x.first, y.first, x.t, y.t);
}

inline void show(const Composed& c, const Spot_place& at, const weft_between& level, Shown& shown)
{
    shown.fine = taps_at(c, at, level.whole);
    shown.t = level.t;
    if (level.t > 0) shown.coarse = taps_at(c, at, level.whole + 1);
}

/// Appends what a view shows to a list; the share of its content.
inline float show_view(const Composed& c, Looker& looker, const View& view, uint32_t slot, Shown*& shown)
{
    const Content content = c.tile->exchange ? looker.content(view, slot) : Content{};
    if (!(content.share >= 1)) show(c, view.base(), looker.level(), *shown++);
    if (content.share > 0) show(c, content.source, content.level, *shown++);
    return content.share >= 1 ? 0 : content.share;
}

void find_composition(const Composed& c, const Axis_places* places, uint32_t begin, uint32_t count, Looker& looker,
                      Composition& found)
{
    View* view = found.views;
    for (uint32_t i = 0; i < count; ++i) {
        View other;
        const float share = looker.views(looker.place(places, begin + i), other, *view);
        const bool alone = share >= 1;
        if (!alone) ++view;
        if (share > 0) *view++ = other;
        found.shares[i].second = alone ? 0 : share;
    }
    view = found.views;
    Shown* shown = found.shown;
    for (uint32_t i = 0; i < count; ++i) {
        Shares& shares = found.shares[i];
        shares.content = show_view(c, looker, *view++, 0, shown);
        if (shares.second > 0) shares.second_content = show_view(c, looker, *view++, 1, shown);
    }
}

/// Appends what view v shows to a list; the share of its content.
inline float show_view(const Composed& c, const Composer& composer, const weft_between& level, uint32_t v,
                       uint32_t slot, Shown*& shown)
{
    const Content content = composer.content(v, slot);
    if (!(content.share >= 1)) {
        const auto taps = [&](bool next) {
            const Base_axis &x = composer.bases(0, next), &y = composer.bases(1, next);
            return taps_from(c, level.whole + (next ? 1 : 0), x.first[v], y.first[v], x.t[v], y.t[v]);
        };
        shown->fine = taps(false);
        shown->t = level.t;
        if (level.t > 0) shown->coarse = taps(true);
        ++shown;
    }
    if (content.share > 0) show(c, content.source, content.level, *shown++);
    return content.share >= 1 ? 0 : content.share;
}

/// The same, for many places.
void find_composition(const Composed& c, const Composer& composer, const weft_between& level, uint32_t count,
                      Composition& found)
{
    Shown* shown = found.shown;
    uint32_t second = composed_together;
    for (uint32_t i = 0; i < count; ++i) {
        Shares& shares = found.shares[i];
        shares.second = composer.share(i) >= 1 ? 0 : composer.share(i);
        shares.content = show_view(c, composer, level, i, 0, shown);
        if (shares.second > 0) shares.second_content = show_view(c, composer, level, second++, 1, shown);
    }
}

inline Pair lerp_pair(const Pair& a, const Pair& b, float t) { return (t - Pair{}) * (b - a) + a; }

inline Pair joined(const Taps& taps, uint32_t width, uint32_t first)
{
    const float *upper = taps.from + first, *lower = upper + taps.row;
    return lerp_pair(lerp_pair(load_pair(upper), load_pair(upper + width), taps.x),
                     lerp_pair(load_pair(lower), load_pair(lower + width), taps.x), taps.y);
}

inline Pair value_of(const Shown& shown, uint32_t width, uint32_t first)
{
    const Pair f = joined(shown.fine, width, first);
    return shown.t > 0 ? lerp_pair(f, joined(shown.coarse, width, first), shown.t) : f;
}

/// Eight planes from `first` on of a place; `shown` moves on.
inline Pair value_of(const Shares& shares, const Shown*& shown, uint32_t width, uint32_t first)
{
    Pair f = value_of(*shown++, width, first);
    if (shares.content > 0) f = lerp_pair(f, value_of(*shown++, width, first), shares.content);
    if (!(shares.second > 0)) return f;
    Pair g = value_of(*shown++, width, first);
    if (shares.second_content > 0) g = lerp_pair(g, value_of(*shown++, width, first), shares.second_content);
    return lerp_pair(f, g, shares.second);
}

/// Rows become columns.
inline void transpose(Pair* v)
{
    Pair u[8];
#pragma GCC unroll 4
    for (uint32_t i = 0; i < 4; ++i) {
        u[i] = __builtin_shufflevector(v[i], v[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        u[i + 4] = __builtin_shufflevector(v[i], v[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
    }
#pragma GCC unroll 2
    for (uint32_t h = 0; h < 8; h += 4) {
        const Pair a = __builtin_shufflevector(u[h], u[h + 1], 0, 8, 1, 9, 4, 12, 5, 13);
        const Pair b = __builtin_shufflevector(u[h], u[h + 1], 2, 10, 3, 11, 6, 14, 7, 15);
        const Pair d = __builtin_shufflevector(u[h + 2], u[h + 3], 0, 8, 1, 9, 4, 12, 5, 13);
        const Pair e = __builtin_shufflevector(u[h + 2], u[h + 3], 2, 10, 3, 11, 6, 14, 7, 15);
        v[h] = __builtin_shufflevector(a, d, 0, 1, 8, 9, 4, 5, 12, 13);
        v[h + 1] = __builtin_shufflevector(a, d, 2, 3, 10, 11, 6, 7, 14, 15);
        v[h + 2] = __builtin_shufflevector(b, e, 0, 1, 8, 9, 4, 5, 12, 13);
        v[h + 3] = __builtin_shufflevector(b, e, 2, 3, 10, 11, 6, 7, 14, 15);
    }
}

/// Eight planes from plane `first` on, of `count` places: those from `begin` to `end` go to f and on.
void write_planes(const Composition& found, uint32_t width, uint32_t first, uint32_t begin, uint32_t end,
                  uint32_t count, float* f, size_t pitch)
{
    const Shown* shown = found.shown;
    for (uint32_t n = 0; n < count; n += 8) {
        const uint32_t some = count - n < 8 ? count - n : 8;
        Pair values[8];
        for (uint32_t i = some; i < 8; ++i) values[i] = Pair{};
        for (uint32_t i = 0; i < some; ++i) values[i] = value_of(found.shares[n + i], shown, width, first);
        transpose(values);
        for (uint32_t p = begin; p < end; ++p) {
            float* to = f + (p - begin) * pitch + n;
            if (some == 8)
                put(values[p - first], to);
            else
                for (uint32_t i = 0; i < some; ++i) to[i] = values[p - first][i];
        }
    }
}

void compose(const Composed& c, const Axis_places* places, uint32_t count, float level, uint32_t first, uint32_t planes,
             float* f, size_t pitch)
{
    Looker looker(c, level);
    Composition found;
    const uint32_t last = first + planes;
    for (uint32_t n = 0; n < count; n += composed_together) {
        const uint32_t some = count - n < composed_together ? count - n : composed_together;
        if (some < composed_together / 4) {
            find_composition(c, places, n, some, looker, found);
        } else {
            Composer composer(c, looker);
            composer.find(places, n, some);
            find_composition(c, composer, looker.level(), some, found);
        }
        for (uint32_t p = first / 8 * 8; p < last; p += 8) {
            const uint32_t begin = p > first ? p : first, end = p + 8 < last ? p + 8 : last;
            write_planes(found, 8 * c.groups, p, begin, end, some, f + (begin - first) * pitch + n, pitch);
        }
    }
}
