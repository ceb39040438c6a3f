/// TILE with WANG or exchange in vectors of planes: a texel's planes lie side by side, in eights, and a column and a
/// row more than there are repeat the first. Included by rows.inl, inside its unnamed namespace.

constexpr uint32_t most_groups = (most_planes + 7) / 8;
constexpr uint32_t composed_together = 16; ///< places

/// Four texels that are joined: the first of them, those below it, weights.
struct Taps {
    const float* from;
    int64_t row;
    float x, y;
};

inline Taps taps_at(const Composed& c, const Spot_place& at, int32_t level)
{
    const weft_mip& mip = c.tile->source->level[level];
    const weft_pair x = weft_pair_at(at.x, level, mip.scale_x, mip.width);
    const weft_pair y = weft_pair_at(at.y, level, mip.scale_y, mip.height);
    const Texels& texels = c.texels[level];
    return {texels.data + y.first * texels.row + x.first * int64_t(8) * c.groups, texels.row, x.t, y.t};
}

inline Pair lerp_pair(const Pair& a, const Pair& b, float t) { return (t - Pair{}) * (b - a) + a; }

inline Pair joined(const Taps& taps, uint32_t groups, uint32_t group)
{
    const float *upper = taps.from + 8 * group, *lower = upper + taps.row;
    return lerp_pair(lerp_pair(load_pair(upper), load_pair(upper + 8 * groups), taps.x),
                     lerp_pair(load_pair(lower), load_pair(lower + 8 * groups), taps.x), taps.y);
}

/// All planes of the source at a place.
inline void source_values(const Composed& c, const Spot_place& at, const weft_between& level, float* f)
{
    const Taps taps = taps_at(c, at, level.whole);
    for (uint32_t g = 0; g < c.groups; ++g) put(joined(taps, c.groups, g), f + 8 * g);
    if (!(level.t > 0)) return;
    const Taps coarse = taps_at(c, at, level.whole + 1);
    for (uint32_t g = 0; g < c.groups; ++g)
        put(lerp_pair(load_pair(f + 8 * g), joined(coarse, c.groups, g), level.t), f + 8 * g);
}

/// f = lerp(f, g, t).
inline void blend_values(const Composed& c, const float* g, float t, float* f)
{
    for (uint32_t i = 0; i < c.groups; ++i) put(lerp_pair(load_pair(f + 8 * i), load_pair(g + 8 * i), t), f + 8 * i);
}

/// All planes of a view, after exchange.
inline void view_values(const Composed& c, Looker& looker, const View& view, uint32_t slot, float* f)
{
    const Content content = c.tile->exchange ? looker.content(view, slot) : Content{};
    if (content.share >= 1) return source_values(c, content.source, content.level, f);
    source_values(c, view.base(), looker.level(), f);
    if (!(content.share > 0)) return;
    alignas(32) float shown[8 * most_groups];
    source_values(c, content.source, content.level, shown);
    blend_values(c, shown, content.share, f);
}

/// All planes at a place.
inline void place_values(const Composed& c, Looker& looker, const Spot_place& at, float* f)
{
    if (!c.tile->wang) return view_values(c, looker, {at, at.x.texel, at.y.texel, 0}, 0, f);
    View north, west;
    const float share = looker.views(at, north, west);
    if (share >= 1) return view_values(c, looker, north, 0, f);
    view_values(c, looker, west, 1, f);
    if (!(share > 0)) return;
    alignas(32) float shown[8 * most_groups];
    view_values(c, looker, north, 0, shown);
    blend_values(c, shown, share, f);
}

void compose(const Composed& c, const Axis_places* places, uint32_t count, float level, uint32_t first, uint32_t planes,
             float* f, size_t pitch)
{
    Looker looker(c, level);
    alignas(32) float values[composed_together * 8 * most_groups];
    const uint32_t width = 8 * c.groups;
    for (uint32_t begin = 0; begin < count; begin += composed_together) {
        const uint32_t some = count - begin < composed_together ? count - begin : composed_together;
        for (uint32_t i = 0; i < some; ++i)
            place_values(c, looker,
                         {{places[0].cell[begin + i], places[0].texel[begin + i], places[0].fraction[begin + i]},
                          {places[1].cell[begin + i], places[1].texel[begin + i], places[1].fraction[begin + i]}},
                         values + i * width);
        for (uint32_t p = 0; p < planes; ++p)
            for (uint32_t i = 0; i < some; ++i) f[p * pitch + begin + i] = values[i * width + first + p];
    }
}
