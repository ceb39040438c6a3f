/// SPLAT on surfaces in plain loops: the reference. Included by rows.inl, inside its unnamed namespace.

/// What does not change from impact to impact.
struct Surface {
    Surface(const Splat& s, uint32_t l, const weft_spot& at, const float* tangents)
        : splat(s), texels(s.texels[l]), spot(at), frame(tangents), level(l), fade(2.0f / float(thickness(s))),
          unit(weft_level_unit(l)), middle{weft_surface_middle(s.size[0], l), weft_surface_middle(s.size[1], l)}
    {
    }

    static uint32_t thickness(const Splat& s) { return s.size[0] > s.size[1] ? s.size[0] : s.size[1]; }

    /// Along vector `v` of the frame.
    float along(const float* d, uint32_t v) const
    {
        return weft_surface_along(d[0], d[1], d[2], frame[3 * v], frame[3 * v + 1], frame[3 * v + 2]);
    }
    float place(const float* d, uint32_t axis) const { return weft_surface_place(along(d, axis), unit, middle[axis]); }

    const Splat& splat;
    const Texels& texels;
    const weft_spot& spot;
    const float* frame;
    uint32_t level;
    float fade, unit, middle[2];
    float sums[40] = {0};
};

/// Whether texels are read that are not 0: a place between `first` and `first` + count - 1, more or less.
bool is_near(float place, int32_t first, int32_t count, uint32_t taps)
{
    const float margin = float(taps);
    return place > float(first) - margin && place < float(first + count) + margin;
}

/// All texels under one impact, weighted, and added to the sums.
void add_texels(Surface& s, const weft_taps& tx, const weft_taps& ty, float weight)
{
    const Texels& texels = s.texels;
    const uint32_t taps = s.splat.taps;
    const int64_t column = tx.first - texels.x, row = ty.first - texels.y;
    const Spline spline = taps == 2 ? Spline{} : spline_of(tx.t, ty.t, 1.0f, taps);
    for (uint32_t p = 0; p < s.splat.planes; ++p) {
        const float* data = texels.data + p * texels.plane;
        const auto texel = [&](uint32_t i, uint32_t j) { return texel_at(texels, data, column + i, row + j); };
        float sum = 0.0f;
        if (taps == 2)
            sum = weft_lerp(weft_lerp(texel(0, 0), texel(1, 0), tx.t), weft_lerp(texel(0, 1), texel(1, 1), tx.t), ty.t);
        for (uint32_t i = 0; i < taps && taps != 2; ++i) {
            float v = spline.y[0] * texel(i, 0);
            for (uint32_t j = 1; j < taps; ++j) v = weft_fma(spline.y[j], texel(i, j), v);
            sum = i == 0 ? spline.x[0] * v : weft_fma(spline.x[i], v, sum);
        }
        s.sums[p] = weft_madd(weight, sum, s.sums[p]);
    }
}

/// Three axes of cells, and the one that is being searched.
struct Box {
    int64_t first[3], last[3];
    Cell cell[3];
};

void add_impact(Surface& s, const Box& box, uint64_t z)
{
    const uint32_t halves[3] = {weft_low(z), weft_high(z), weft_low(weft_third(z))};
    float d[3];
    for (uint32_t a = 0; a < 3; ++a) {
        const weft_impact_axis axis = weft_impact_at(halves[a], s.splat.cell_log2);
        const int64_t pixel = box.cell[a].begin + axis.pixel;
        if (axis.pixel >= box.cell[a].pixels || pixel < box.first[a] || pixel > box.last[a]) return;
        d[a] = weft_surface_difference(s.spot.cell[a] - pixel, int32_t(s.spot.fraction[a]), axis.fraction);
    }
    const float fade = weft_surface_fade(s.along(d, 2), s.fade), x = s.place(d, 0), y = s.place(d, 1);
    const uint32_t taps = s.splat.taps;
    if (!(fade > 0.0f) || !is_near(x, s.texels.x, s.texels.width, taps) ||
        !is_near(y, s.texels.y, s.texels.height, taps))
        return;
    add_texels(s, weft_surface_taps(x, taps), weft_surface_taps(y, taps), fade * weft_impact_sign(z, s.splat.signs));
}

void add_cell(Surface& s, const Box& box, uint64_t key)
{
    const uint32_t count = impact_count(s.splat, key);
    for (uint32_t i = 0; i < count; ++i) add_impact(s, box, weft_draw(key, i + 1));
}

/// All cells of axis `a` and of those behind it.
void add_cells(Surface& s, Box& box, uint32_t a, uint64_t key)
{
    const uint32_t period = s.splat.period[a];
    for (Walk walk = walk_from(s.splat, period, box.first[a]);; advance(s.splat, period, walk)) {
        box.cell[a] = cell_at(s.splat, period, walk);
        if (box.cell[a].begin > box.last[a]) return;
        const uint64_t next = weft_absorb(key, box.cell[a].number);
        if (a == 2)
            add_cell(s, box, next);
        else
            add_cells(s, box, a + 1, next);
    }
}

void splat_surface(const Splat& splat, uint32_t level, const weft_spot& spot, const float* frame, float* f)
{
    Surface surface(splat, level, spot, frame);
    Box box;
    for (uint32_t a = 0; a < 3; ++a) {
        box.first[a] = spot.cell[a] - splat.texels[level].reach;
        box.last[a] = spot.cell[a] + splat.texels[level].reach;
    }
    add_cells(surface, box, 0, splat.key);
    for (uint32_t p = 0; p < splat.planes; ++p) f[p] = surface.sums[p] + splat.offset[p];
}
