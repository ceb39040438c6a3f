/// TILE with WANG or exchange in vectors of planes: a texel's planes lie side by side, in eights, and a column and a
/// row more than there are repeat the first. Some places at a time, in three rounds: their views, what of the source
/// these show, its values; each round asks for the memory that the next one reads, since places lie scattered. Included
/// by rows.inl, inside its unnamed namespace.

constexpr uint32_t most_groups = (most_planes + 7) / 8;
constexpr uint32_t composed_together = 32; ///< places

/// Four texels that are joined: the first of them, those below it, weights.
struct Taps {
    const float* from;
    int64_t row;
    float x, y;
};

/// A place of the source, at one level or (t > 0) between two.
struct Shown {
    Taps fine, coarse;
    float t;
};

/// A view after exchange: its base, into which its content is blended if that has a share.
struct Exchanged {
    Shown base, content;
    float share;
};

/// The views of a place; the second one is blended into the first if it has a share.
struct Composition {
    View views[2];
    float share;
    Exchanged exchanged[2];
};

inline Taps taps_at(const Composed& c, const Spot_place& at, int32_t level)
{
    const weft_mip& mip = c.tile->source->level[level];
    const weft_pair x = weft_pair_at(at.x, level, mip.scale_x, mip.width);
    const weft_pair y = weft_pair_at(at.y, level, mip.scale_y, mip.height);
    const Texels& texels = c.texels[level];
    const float* from = texels.data + y.first * texels.row + x.first * int64_t(8) * c.groups;
    __builtin_prefetch(from);
    __builtin_prefetch(from + texels.row);
    return {from, texels.row, x.t, y.t};
}

inline Shown shown_at(const Composed& c, const Spot_place& at, const weft_between& level)
{
    Shown shown;
    shown.fine = taps_at(c, at, level.whole);
    shown.t = level.t;
    if (level.t > 0) shown.coarse = taps_at(c, at, level.whole + 1);
    return shown;
}

inline void find_views(const Composed& c, Looker& looker, const Spot_place& at, Composition& found)
{
    found.share = 0;
    if (c.tile->wang) {
        const float share = looker.views(at, found.views[1], found.views[0]);
        if (share >= 1)
            found.views[0] = found.views[1];
        else
            found.share = share;
    } else
        found.views[0] = {at, at.x.texel, at.y.texel, 0};
}

inline void exchange(const Composed& c, Looker& looker, const View& view, uint32_t slot, Exchanged& to)
{
    const Content content = c.tile->exchange ? looker.content(view, slot) : Content{};
    const bool whole = content.share >= 1;
    to.share = whole ? 0 : content.share;
    to.base = whole ? shown_at(c, content.source, content.level) : shown_at(c, view.base(), looker.level());
    if (to.share > 0) to.content = shown_at(c, content.source, content.level);
}

inline Pair lerp_pair(const Pair& a, const Pair& b, float t) { return (t - Pair{}) * (b - a) + a; }

inline Pair joined(const Taps& taps, uint32_t groups, uint32_t group)
{
    const float *upper = taps.from + 8 * group, *lower = upper + taps.row;
    return lerp_pair(lerp_pair(load_pair(upper), load_pair(upper + 8 * groups), taps.x),
                     lerp_pair(load_pair(lower), load_pair(lower + 8 * groups), taps.x), taps.y);
}

inline Pair value_of(const Shown& shown, uint32_t groups, uint32_t group)
{
    const Pair f = joined(shown.fine, groups, group);
    return shown.t > 0 ? lerp_pair(f, joined(shown.coarse, groups, group), shown.t) : f;
}

inline Pair value_of(const Exchanged& view, uint32_t groups, uint32_t group)
{
    const Pair f = value_of(view.base, groups, group);
    return view.share > 0 ? lerp_pair(f, value_of(view.content, groups, group), view.share) : f;
}

void compose(const Composed& c, const Axis_places* places, uint32_t count, float level, uint32_t first, uint32_t planes,
             float* f, size_t pitch)
{
    Looker looker(c, level);
    Composition found[composed_together];
    alignas(32) float values[composed_together * 8];
    for (uint32_t begin = 0; begin < count; begin += composed_together) {
        const uint32_t some = count - begin < composed_together ? count - begin : composed_together;
        for (uint32_t i = 0, n = begin; i < some; ++i, ++n)
            find_views(c, looker,
                       {{places[0].cell[n], places[0].texel[n], places[0].fraction[n]},
                        {places[1].cell[n], places[1].texel[n], places[1].fraction[n]}},
                       found[i]);
        for (uint32_t i = 0; i < some; ++i) {
            exchange(c, looker, found[i].views[0], 0, found[i].exchanged[0]);
            if (found[i].share > 0) exchange(c, looker, found[i].views[1], 1, found[i].exchanged[1]);
        }
        for (uint32_t g = first / 8; 8 * g < first + planes; ++g) {
            for (uint32_t i = 0; i < some; ++i) {
                Pair value = value_of(found[i].exchanged[0], c.groups, g);
                if (found[i].share > 0)
                    value = lerp_pair(value, value_of(found[i].exchanged[1], c.groups, g), found[i].share);
                put(value, values + 8 * i);
            }
            const uint32_t from = g * 8 > first ? g * 8 : first,
                           to = g * 8 + 8 < first + planes ? g * 8 + 8 : first + planes;
            for (uint32_t p = from; p < to; ++p)
                for (uint32_t i = 0; i < some; ++i) f[(p - first) * pitch + begin + i] = values[8 * i + p - 8 * g];
        }
    }
}
