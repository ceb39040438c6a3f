/// SPLAT on surfaces in vectors. Included by rows.inl, inside its unnamed namespace.
///
/// As in the plane: cells that may reach, their impacts in arrays, the texels of those that do reach, which lie four
/// planes side by side with zeros around.

/// Impacts of cells: `state` is what their number is made of, `begin` the first pixel of their cell, seen from the
/// spot.
struct Space_candidates {
    uint32_t count;
    alignas(64) uint64_t state[most_candidates];
    alignas(64) int32_t begin[3][most_candidates], pixels[3][most_candidates];
    alignas(64) uint32_t half[3][most_candidates], sign[most_candidates];
    alignas(64) float difference[3][most_candidates];
    alignas(64) float x[most_candidates], y[most_candidates], fade[most_candidates];
    alignas(64) uint32_t reaches[most_candidates];
};

/// A spot being evaluated.
struct Surface {
    Surface(const Splat& s, uint32_t l, const weft_spot& at, const float* tangents)
        : splat(s), texels(s.texels[l]), spot(at), frame(tangents),
          fade(2.0f / float(s.size[0] > s.size[1] ? s.size[0] : s.size[1])),
          unit(weft_level_unit(l)), middle{weft_surface_middle(s.size[0], l), weft_surface_middle(s.size[1], l)},
          reach(int32_t(texels.reach))
    {
        const float taps = float(s.taps);
        low[0] = float(texels.x) - taps;
        low[1] = float(texels.y) - taps;
        high[0] = float(texels.x + texels.width) + taps;
        high[1] = float(texels.y + texels.height) + taps;
        const float side = 0.5f * float(int64_t(1) << s.cell_log2) + 1; // the spot is within its pixel
        for (uint32_t v = 0; v < 3; ++v) {
            const float* f = frame + 3 * v;
            const float size = size_of(f[0]) + size_of(f[1]) + size_of(f[2]);
            slack[v] = size * (side + 0.001f * (float(reach) + 2 * side)) + 0.001f;
        }
    }

    static float size_of(float v) { return v < 0 ? -v : v; }

    /// Whether no impact of a cell can reach, by its centre. The slack covers half the cell, and all rounding.
    bool misses(const float* centre) const
    {
        const auto along = [&](uint32_t v) {
            const float* f = frame + 3 * v;
            return weft_surface_along(centre[0], centre[1], centre[2], f[0], f[1], f[2]);
        };
        const float x = along(0) * unit + middle[0], y = along(1) * unit + middle[1];
        const float more_x = slack[0] * unit, more_y = slack[1] * unit;
        return (size_of(along(2)) - slack[2]) * fade > 1.0f || x < low[0] - more_x || x > high[0] + more_x ||
               y < low[1] - more_y || y > high[1] + more_y;
    }

    const Splat& splat;
    const Texels& texels;
    const weft_spot& spot;
    const float* frame;
    float fade, unit, middle[2], low[2], high[2], slack[3];
    int32_t reach;
    Space_candidates candidates;
    float sums[40];
};

/// weft_surface_difference without 64-bit integers: the sum is exact in binary64.
inline float difference_of(int32_t pixels, int32_t spot_fraction, int32_t impact_fraction)
{
    return float(double(pixels) * 16777216.0 + double(spot_fraction - impact_fraction)) * WEFT_FRACTION_UNIT;
}

void locate_axis(Surface& s, uint32_t axis)
{
    Space_candidates& c = s.candidates;
    const uint32_t shift = 16 - s.splat.cell_log2;
    const int32_t fraction = int32_t(s.spot.fraction[axis]), reach = s.reach;
    for (uint32_t n = 0; n < c.count; ++n) {
        const uint32_t a = c.half[axis][n] >> shift;
        const int32_t in_cell = int32_t(a >> 16), pixel = c.begin[axis][n] + in_cell;
        const int32_t impact_fraction = int32_t(((a & 0xffff) * 2 + 1) << 7);
        c.difference[axis][n] = difference_of(-pixel, fraction, impact_fraction);
        c.reaches[n] &= uint32_t((in_cell < c.pixels[axis][n]) & (pixel >= -reach) & (pixel <= reach));
    }
}

void locate_in_space(Surface& s)
{
    Space_candidates& c = s.candidates;
    const uint32_t signs = s.splat.signs;
    for (uint32_t n = 0; n < c.count; ++n) {
        const uint64_t z = weft_mix(c.state[n]);
        c.half[0][n] = weft_low(z);
        c.half[1][n] = weft_high(z);
        c.half[2][n] = weft_low(weft_third(z));
        c.sign[n] = weft_low(z) & signs;
        c.reaches[n] = 1;
    }
    for (uint32_t a = 0; a < 3; ++a) locate_axis(s, a);
    const float* f = s.frame;
    for (uint32_t n = 0; n < c.count; ++n) {
        const float x = c.difference[0][n], y = c.difference[1][n], z = c.difference[2][n];
        const float across = weft_surface_fade(weft_surface_along(x, y, z, f[6], f[7], f[8]), s.fade);
        const float column = weft_surface_place(weft_surface_along(x, y, z, f[0], f[1], f[2]), s.unit, s.middle[0]);
        const float row = weft_surface_place(weft_surface_along(x, y, z, f[3], f[4], f[5]), s.unit, s.middle[1]);
        c.reaches[n] &= uint32_t((across > 0.0f) & (column > s.low[0]) & (column < s.high[0]) & (row > s.low[1]) &
                                 (row < s.high[1]));
        c.x[n] = column;
        c.y[n] = row;
        c.fade[n] = across * (1.0f - 2.0f * float(int32_t(c.sign[n])));
    }
}

inline Quad fma_quad(const Quad& a, const Quad& b, const Quad& c)
{
    Quad sum;
    for (uint32_t i = 0; i < 4; ++i) sum[i] = weft_fma(a[i], b[i], c[i]);
    return sum;
}

/// Two rows, each the lerp of two texels, side by side, and then their lerp.
inline Quad lerp_texels(const float* from, int64_t row, float tx, float ty)
{
    const Quad a0 = load_quad(from), b0 = load_quad(from + 4);
    const Quad a1 = load_quad(from + row), b1 = load_quad(from + row + 4);
    const Quad x = tx - Quad{}, upper = x * (b0 - a0) + a0, lower = x * (b1 - a1) + a1;
    return (ty - Quad{}) * (lower - upper) + upper;
}

inline Quad spline_texels(const float* from, int64_t row, const Spline& spline, uint32_t taps)
{
    Quad sum{};
    for (uint32_t i = 0; i < taps; ++i) {
        const float* texel = from + 4 * i;
        Quad v = spline.y[0] * load_quad(texel);
        for (uint32_t j = 1; j < taps; ++j) v = fma_quad(spline.y[j] - Quad{}, load_quad(texel + j * row), v);
        sum = i == 0 ? spline.x[0] * v : fma_quad(spline.x[i] - Quad{}, v, sum);
    }
    return sum;
}

void add_texels(Surface& s, uint32_t n)
{
    const Texels& texels = s.texels;
    const uint32_t taps = s.splat.taps;
    const weft_taps tx = weft_surface_taps(s.candidates.x[n], taps), ty = weft_surface_taps(s.candidates.y[n], taps);
    const int64_t column = tx.first - texels.x, row = ty.first - texels.y, reach = int64_t(taps) - 1;
    if (column < -reach || column >= texels.width || row < -reach || row >= texels.height) return;
    const Spline spline = taps == 2 ? Spline{} : spline_of(tx.t, ty.t, 1.0f, taps);
    const float* from = texels.data + row * texels.row + 4 * column;
    for (uint32_t p = 0; p < s.splat.planes; p += 4, from += texels.plane) {
        const Quad v =
            taps == 2 ? lerp_texels(from, texels.row, tx.t, ty.t) : spline_texels(from, texels.row, spline, taps);
        put(s.candidates.fade[n] * v + load_quad(s.sums + p), s.sums + p);
    }
}

void add_candidates(Surface& s)
{
    locate_in_space(s);
    for (uint32_t n = 0; n < s.candidates.count; ++n)
        if (s.candidates.reaches[n] != 0) add_texels(s, n);
    s.candidates.count = 0;
}

void add_cell(Surface& s, const Cell* cell, uint64_t key)
{
    Space_candidates& c = s.candidates;
    const uint32_t count = impact_count(s.splat, key);
    for (uint32_t i = 0; i < count; ++i) {
        if (c.count == most_candidates) add_candidates(s);
        c.state[c.count] = key + (uint64_t(i) + 2) * WEFT_GOLDEN; // weft_draw without its mix
        for (uint32_t a = 0; a < 3; ++a) {
            c.begin[a][c.count] = int32_t(cell[a].begin - s.spot.cell[a]);
            c.pixels[a][c.count] = cell[a].pixels;
        }
        ++c.count;
    }
}

/// All cells of axis `a` and of those behind it; `centre` is the spot seen from the middle of the cell.
void add_cells(Surface& s, Cell* cell, float* centre, uint32_t a, uint64_t key)
{
    const uint32_t period = s.splat.period[a];
    const float half = 0.5f * float(int64_t(1) << s.splat.cell_log2);
    for (Walk walk = walk_from(s.splat, period, s.spot.cell[a] - s.reach);; advance(s.splat, period, walk)) {
        cell[a] = cell_at(s.splat, period, walk);
        if (cell[a].begin > s.spot.cell[a] + s.reach) return;
        centre[a] = float(int32_t(s.spot.cell[a] - cell[a].begin)) - half;
        if (a == 2 && s.misses(centre)) continue;
        const uint64_t next = weft_absorb(key, cell[a].number);
        if (a == 2)
            add_cell(s, cell, next);
        else
            add_cells(s, cell, centre, a + 1, next);
    }
}

void splat_surface(const Splat& splat, uint32_t level, const weft_spot& spot, const float* frame, float* f)
{
    Surface surface(splat, level, spot, frame);
    Cell cell[3];
    float centre[3];
    surface.candidates.count = 0;
    for (float& sum : surface.sums) sum = 0.0f;
    add_cells(surface, cell, centre, 0, splat.key);
    add_candidates(surface);
    for (uint32_t p = 0; p < splat.planes; ++p) f[p] = surface.sums[p] + splat.offset[p];
}
