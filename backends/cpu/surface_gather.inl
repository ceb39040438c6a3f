/// SPLAT on surfaces in vectors. Included by rows.inl, inside its unnamed namespace.
///
/// As in the plane: cells that may reach, their impacts in arrays, the texels of those that do reach, which lie four
/// planes side by side with zeros around.

/// As Cells and Candidates, with a third axis.
struct Space_cells : Cells {
    alignas(64) int32_t z[most_cells + chunk], pixels_z[most_cells + chunk];
};

struct Space_candidates {
    uint32_t count;
    alignas(64) uint64_t state[most_candidates + chunk];
    alignas(64) int32_t begin[3][most_candidates + chunk], pixels[3][most_candidates + chunk];
    alignas(64) uint32_t half[3][most_candidates + chunk];
    alignas(64) float difference[3][most_candidates + chunk];
    alignas(64) float x[most_candidates + chunk], y[most_candidates + chunk], fade[most_candidates + chunk];
    alignas(64) int32_t origin[most_candidates + chunk];
    alignas(64) uint32_t reaches[most_candidates + chunk];
    uint32_t hits[most_candidates + chunk];
};

/// A spot being evaluated.
struct Surface {
    Surface(const Splat& s, uint32_t l, const weft_spot& at, const float* tangents)
        : splat(s), texels(s.texels[l]), spot(at), frame(tangents),
          fade(2.0f / float(s.size[0] > s.size[1] ? s.size[0] : s.size[1])),
          unit(weft_level_unit(l)), middle{weft_surface_middle(s.size[0], l), weft_surface_middle(s.size[1], l)},
          reach(int32_t(texels.reach)),
          cut(((s.period[0] | s.period[1] | s.period[2]) & ((uint32_t(1) << s.cell_log2) - 1)) != 0)
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
    bool misses(float x, float y, float z) const
    {
        const auto along = [&](const float* f) { return weft_surface_along(x, y, z, f[0], f[1], f[2]); };
        const float column = along(frame) * unit + middle[0], row = along(frame + 3) * unit + middle[1];
        const float more_columns = slack[0] * unit, more_rows = slack[1] * unit;
        return ((size_of(along(frame + 6)) - slack[2]) * fade > 1.0f) | (column < low[0] - more_columns) |
               (column > high[0] + more_columns) | (row < low[1] - more_rows) | (row > high[1] + more_rows);
    }

    const Splat& splat;
    const Texels& texels;
    const weft_spot& spot;
    const float* frame;
    float fade, unit, middle[2], low[2], high[2], slack[3];
    int32_t reach;
    bool cut; ///< some cells are cut by the period
    Space_cells cells;
    Space_candidates candidates;
    float sums[most_planes];
};

/// weft_surface_difference without 64-bit integers: the sum is exact in binary64.
inline float difference_of(int32_t pixels, int32_t spot_fraction, int32_t impact_fraction)
{
    return float(double(pixels) * 16777216.0 + double(spot_fraction - impact_fraction)) * WEFT_FRACTION_UNIT;
}

void locate_axis(Surface& s, uint32_t axis, uint32_t count)
{
    Space_candidates& c = s.candidates;
    const uint32_t shift = 16 - s.splat.cell_log2;
    const int32_t fraction = int32_t(s.spot.fraction[axis]), reach = s.reach;
    for (uint32_t n = 0; n < count; ++n) {
        const uint32_t a = c.half[axis][n] >> shift;
        const int32_t pixel = c.begin[axis][n] + int32_t(a >> 16);
        const int32_t impact_fraction = int32_t(((a & 0xffff) * 2 + 1) << 7);
        c.difference[axis][n] = difference_of(-pixel, fraction, impact_fraction);
        c.reaches[n] &= uint32_t((pixel >= -reach) & (pixel <= reach));
    }
    for (uint32_t n = 0; n < count && s.cut; ++n)
        c.reaches[n] &= uint32_t(int32_t((c.half[axis][n] >> shift) >> 16) < c.pixels[axis][n]);
}

/// Where the texels under the impacts are; with two taps also where they are read.
void locate_on_surface(Surface& s, uint32_t count)
{
    Space_candidates& c = s.candidates;
    const float *f = s.frame, low_x = s.low[0], low_y = s.low[1], high_x = s.high[0], high_y = s.high[1];
    const uint32_t signs = s.splat.signs, width = uint32_t(s.texels.width), height = uint32_t(s.texels.height);
    const int32_t left = s.texels.x, top = s.texels.y, pitch = int32_t(s.texels.row);
    const bool linear = s.splat.taps == 2;
    for (uint32_t n = 0; n < count; ++n) {
        const float x = c.difference[0][n], y = c.difference[1][n], z = c.difference[2][n];
        const float across = weft_surface_fade(weft_surface_along(x, y, z, f[6], f[7], f[8]), s.fade);
        const float column = weft_surface_place(weft_surface_along(x, y, z, f[0], f[1], f[2]), s.unit, s.middle[0]);
        const float row = weft_surface_place(weft_surface_along(x, y, z, f[3], f[4], f[5]), s.unit, s.middle[1]);
        c.reaches[n] &=
            uint32_t((across > 0.0f) & (column > low_x) & (column < high_x) & (row > low_y) & (row < high_y));
        c.x[n] = column;
        c.y[n] = row;
        c.fade[n] = across * (1.0f - 2.0f * float(int32_t(c.half[0][n] & signs)));
    }
    for (uint32_t n = 0; n < count && linear; ++n) {
        const float x = weft_clamp(c.x[n], low_x, high_x), y = weft_clamp(c.y[n], low_y, high_y);
        const int32_t first = weft_floor(x), upper = weft_floor(y), column = first - left, row = upper - top;
        c.reaches[n] &= uint32_t((uint32_t(column) + 1 <= width) & (uint32_t(row) + 1 <= height));
        c.origin[n] = int32_t(uint32_t(row) * uint32_t(pitch) + uint32_t(column) * 4u);
        c.x[n] = x - float(first);
        c.y[n] = y - float(upper);
    }
}

void locate_in_space(Surface& s)
{
    Space_candidates& c = s.candidates;
    const uint32_t count = whole_chunks(c.count);
    clear_chunk(c.state + c.count);
    for (uint32_t a = 0; a < 3; ++a) clear_chunk(c.begin[a] + c.count);
    for (uint32_t n = 0; n < count; ++n) {
        const uint64_t z = weft_mix(c.state[n]);
        c.half[0][n] = weft_low(z);
        c.half[1][n] = weft_high(z);
        c.half[2][n] = weft_low(weft_third(z));
        c.reaches[n] = 1;
    }
    for (uint32_t a = 0; a < 3; ++a) locate_axis(s, a, count);
    locate_on_surface(s, count);
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

/// All groups of planes, or the only one, whose sums stay in a register.
void add_linear(Surface& s, uint32_t count)
{
    const Space_candidates& c = s.candidates;
    const int64_t pitch = s.texels.row;
    for (uint32_t p = 0; p < s.splat.planes; p += 4) {
        const float* data = s.texels.data + p / 4 * s.texels.plane;
        Quad sum = load_quad(s.sums + p);
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t n = c.hits[i];
            sum = c.fade[n] * lerp_texels(data + c.origin[n], pitch, c.x[n], c.y[n]) + sum;
        }
        put(sum, s.sums + p);
    }
}

void add_spline(Surface& s, uint32_t n)
{
    const Texels& texels = s.texels;
    const uint32_t taps = s.splat.taps;
    const weft_taps tx = weft_surface_taps(s.candidates.x[n], taps), ty = weft_surface_taps(s.candidates.y[n], taps);
    const int64_t column = tx.first - texels.x, row = ty.first - texels.y, reach = int64_t(taps) - 1;
    if (column < -reach || column >= texels.width || row < -reach || row >= texels.height) return;
    const Spline spline = spline_of(tx.t, ty.t, 1.0f, taps);
    const float* from = texels.data + row * texels.row + 4 * column;
    for (uint32_t p = 0; p < s.splat.planes; p += 4, from += texels.plane)
        put(s.candidates.fade[n] * spline_texels(from, texels.row, spline, taps) + load_quad(s.sums + p), s.sums + p);
}

void add_candidates(Surface& s)
{
    locate_in_space(s);
    const uint32_t hits = list_hits(s.candidates);
    if (s.splat.taps == 2)
        add_linear(s, hits);
    else
        for (uint32_t i = 0; i < hits; ++i) add_spline(s, s.candidates.hits[i]);
    s.candidates.count = 0;
}

/// Lists eight impacts of cell n, whether there are so many or not.
inline void list_eight(const Space_cells& cells, uint32_t n, const States& state, bool cut, Space_candidates& c,
                       uint32_t to)
{
    put(state, c.state + to);
    put(state + 4 * WEFT_GOLDEN, c.state + to + 4);
    put(cells.x[n] + Whole{}, c.begin[0] + to);
    put(cells.y[n] + Whole{}, c.begin[1] + to);
    put(cells.z[n] + Whole{}, c.begin[2] + to);
    if (!cut) return;
    put(cells.pixels_x[n] + Whole{}, c.pixels[0] + to);
    put(cells.pixels_y[n] + Whole{}, c.pixels[1] + to);
    put(cells.pixels_z[n] + Whole{}, c.pixels[2] + to);
}

/// Adds the impacts of the cells that are listed.
void add_cells(Surface& s)
{
    const States steps = {2 * WEFT_GOLDEN, 3 * WEFT_GOLDEN, 4 * WEFT_GOLDEN, 5 * WEFT_GOLDEN};
    const Splat& splat = s.splat;
    Space_candidates& c = s.candidates;
    count_impacts(splat, s.cells);
    for (uint32_t n = 0, count = s.cells.count; n < count; ++n) {
        uint32_t left = s.cells.impacts[n];
        if (left == splat.usual_counts) left = impact_count(splat, s.cells.key[n]);
        for (States state = s.cells.key[n] + steps; left > 0; state += 8 * WEFT_GOLDEN) {
            const uint32_t some = left < 8 ? left : 8;
            if (c.count > most_candidates - 8) add_candidates(s);
            list_eight(s.cells, n, state, s.cut, c, c.count);
            c.count += some;
            left -= some;
        }
    }
    s.cells.count = 0;
}

/// Lists those of a column's cells that may reach.
void append_cells(Surface& s, const Cell& cx, const Cell& cy, uint64_t column, const Axis& axis)
{
    Space_cells& cells = s.cells;
    if (cells.count + axis.count > most_cells) add_cells(s);
    const float half = 0.5f * float(int64_t(1) << s.splat.cell_log2);
    const float x = float(int32_t(s.spot.cell[0] - cx.begin)) - half;
    const float y = float(int32_t(s.spot.cell[1] - cy.begin)) - half;
    uint32_t kept[most_cells];
    for (uint32_t j = 0; j < axis.count; ++j) kept[j] = s.misses(x, y, float(-axis.begin[j]) - half) ? 0 : 1;
    uint32_t to = cells.count;
    for (uint32_t j = 0; j < axis.count; ++j) {
        cells.key[to] = (column ^ axis.number[j]) + WEFT_GOLDEN;
        cells.x[to] = int32_t(cx.begin - s.spot.cell[0]);
        cells.y[to] = int32_t(cy.begin - s.spot.cell[1]);
        cells.z[to] = axis.begin[j];
        cells.pixels_x[to] = cx.pixels;
        cells.pixels_y[to] = cy.pixels;
        cells.pixels_z[to] = axis.pixels[j];
        to += kept[j];
    }
    cells.count = to;
}

/// All cells of columns x, y; `first` are those that begin an axis z, and all of them if it ends there.
void add_column(Surface& s, const Cell& cx, const Cell& cy, uint64_t key, const Axis& first, bool more, Walk walk)
{
    append_cells(s, cx, cy, key, first);
    while (more) {
        Axis axis;
        more = next_cells(s.splat, s.splat.period[2], s.spot.cell[2], s.spot.cell[2] + s.reach, walk, axis);
        append_cells(s, cx, cy, key, axis);
    }
}

void add_all(Surface& s)
{
    const Splat& splat = s.splat;
    const int64_t* spot = s.spot.cell;
    Axis first;
    Walk walk = walk_from(splat, splat.period[2], spot[2] - s.reach);
    const bool more = next_cells(splat, splat.period[2], spot[2], spot[2] + s.reach, walk, first);
    for (Walk wx = walk_from(splat, splat.period[0], spot[0] - s.reach);; advance(splat, splat.period[0], wx)) {
        const Cell cx = cell_at(splat, splat.period[0], wx);
        if (cx.begin > spot[0] + s.reach) break;
        const uint64_t column = weft_absorb(splat.key, cx.number);
        for (Walk wy = walk_from(splat, splat.period[1], spot[1] - s.reach);; advance(splat, splat.period[1], wy)) {
            const Cell cy = cell_at(splat, splat.period[1], wy);
            if (cy.begin > spot[1] + s.reach) break;
            add_column(s, cx, cy, weft_absorb(column, cy.number), first, more, walk);
        }
    }
    add_cells(s);
    add_candidates(s);
}

void splat_surface(const Splat& splat, uint32_t level, const weft_spot& spot, const float* frame, float* f)
{
    Surface surface(splat, level, spot, frame);
    surface.cells.count = surface.candidates.count = 0;
    for (float& sum : surface.sums) sum = 0.0f;
    add_all(surface);
    for (uint32_t p = 0; p < splat.planes; ++p) f[p] = surface.sums[p] + splat.offset[p];
}
