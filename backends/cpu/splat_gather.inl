/// SPLAT at a point in vectors. Included by rows.inl, inside its unnamed namespace.
///
/// In three steps, each a loop over arrays: the keys and counts of the cells that can reach, the impacts of those cells,
/// the texels of the impacts that do reach, which lie four planes side by side, with zeros around.

constexpr uint32_t most_cells = 64, most_candidates = 256;

typedef float Quad __attribute__((vector_size(16)));
typedef float Pair __attribute__((vector_size(32))); ///< two texels

/// Cells around a point, in canonical order. Pixels are relative to that of the point.
struct Cells {
    uint32_t count;
    alignas(64) uint64_t column[most_cells]; ///< key of the column of cells
    alignas(64) uint64_t number[most_cells];
    alignas(64) uint64_t key[most_cells];
    alignas(64) uint32_t high[most_cells];
    alignas(64) uint32_t impacts[most_cells];
    alignas(64) int32_t x[most_cells], y[most_cells];
    alignas(64) int32_t pixels_x[most_cells], pixels_y[most_cells];
};

/// Impacts of cells; what follows `low` is computed from what precedes it.
struct Candidates {
    uint32_t count;
    alignas(64) uint64_t state[most_candidates];
    alignas(64) int32_t x[most_candidates], y[most_candidates];
    alignas(64) int32_t pixels_x[most_candidates], pixels_y[most_candidates];
    alignas(64) uint32_t low[most_candidates], high[most_candidates];
    alignas(64) float tx[most_candidates], ty[most_candidates], sign[most_candidates];
    alignas(64) float w0[most_candidates], w1[most_candidates], rho[most_candidates];
    alignas(64) int32_t origin[most_candidates];
    alignas(64) int32_t reaches[most_candidates];
    uint32_t hits[most_candidates];
};

/// A point being evaluated. Accumulators: two of four planes in `pairs`, or taps of four planes in `quads`.
struct Point {
    const Splat& splat;
    const Texels& texels;
    const weft_spot& spot;
    uint32_t level, groups;
    Pair pairs[10];
    Quad quads[10][6];
};

/// weft_distance and weft_taps_at in 32 bits, which is exact where the impact can reach: |pixels| is below 2^30.
struct Place {
    int32_t first;
    float t;
};

inline Place place_at(int32_t pixels, int32_t fraction, uint32_t level, uint32_t taps)
{
    pixels += fraction >> 24;
    const int32_t rest = pixels & ((1 << level) - 1);
    int32_t e = (rest << (24 - level)) + ((fraction & WEFT_FRACTION_MASK) >> level);
    e -= taps == 1 ? 0 : WEFT_FRACTION_HALF;
    Place place;
    place.first = (pixels >> level) + (e >> 24);
    place.t = float(e & WEFT_FRACTION_MASK) * WEFT_FRACTION_UNIT;
    return place;
}

/// Where the candidates are and what they weigh.
template <uint32_t taps> void locate_candidates(const Point& point, Candidates& c)
{
    const Texels& texels = point.texels;
    const uint32_t shift = 16 - point.splat.cell_log2, level = point.level, signs = point.splat.signs, count = c.count;
    const int32_t fx = int32_t(point.spot.fraction[0]), fy = int32_t(point.spot.fraction[1]);
    const int32_t before = taps > 2 ? int32_t(taps) / 2 - 1 : 0, reach = int32_t(taps) - 1;
    const int32_t left = texels.x + before, top = texels.y + before, width = texels.width, height = texels.height;
    const int32_t row_pitch = int32_t(texels.row);
    for (uint32_t n = 0; n < count; ++n) {
        const uint64_t z = weft_mix(c.state[n]);
        c.low[n] = weft_low(z);
        c.high[n] = weft_high(z);
    }
    for (uint32_t n = 0; n < count; ++n) {
        const uint32_t ax = c.low[n] >> shift, ay = c.high[n] >> shift;
        const int32_t px = int32_t(ax >> 16), py = int32_t(ay >> 16);
        const int32_t x = c.x[n] + px, y = c.y[n] + py;
        const Place at_x = place_at(-x, fx - int32_t(((ax & 0xffff) * 2 + 1) << 7), level, taps);
        const Place at_y = place_at(-y, fy - int32_t(((ay & 0xffff) * 2 + 1) << 7), level, taps);
        const int32_t column = at_x.first - left, row = at_y.first - top;
        c.x[n] = x;
        c.y[n] = y;
        c.reaches[n] = (px < c.pixels_x[n]) & (py < c.pixels_y[n]) & (column >= -reach) & (column < width) &
                       (row >= -reach) & (row < height);
        c.origin[n] = int32_t(uint32_t(row) * uint32_t(row_pitch) + uint32_t(column) * 4u);
        const float sign = 1.0f - 2.0f * float(int32_t(c.low[n] & signs));
        if (taps == 2) {
            const weft_weights2 w = weft_linear(at_x.t, at_y.t, sign);
            c.w0[n] = w.w0;
            c.w1[n] = w.w1;
            c.rho[n] = w.rho;
        } else {
            c.tx[n] = at_x.t;
            c.ty[n] = at_y.t;
            c.sign[n] = sign;
        }
    }
}

const float* texel_under(const Point& point, const Candidates& c, uint32_t n)
{
    const Splat& splat = point.splat;
    const int64_t image =
        splat.choose ? splat.choose(splat.choice, point.spot.cell[0] + c.x[n], point.spot.cell[1] + c.y[n]) : 0;
    return point.texels.data + image * point.texels.image + c.origin[n];
}

inline Pair load_pair(const float* from)
{
    Pair v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}

inline Pair fma_pair(const Pair& a, const Pair& b, const Pair& c)
{
    Pair sum;
    for (uint32_t i = 0; i < 8; ++i) sum[i] = weft_fma(a[i], b[i], c[i]);
    return sum;
}

inline void add_linear(Point& point, const Candidates& c, uint32_t n)
{
    const float* from = texel_under(point, c, n);
    const float w0 = c.w0[n], w1 = c.w1[n];
    const Pair w = {w0, w0, w0, w0, w1, w1, w1, w1}, rho = c.rho[n] - Pair{};
    for (uint32_t g = 0; g < point.groups; ++g, from += point.texels.plane)
        point.pairs[g] = fma_pair(w, fma_pair(rho, load_pair(from + point.texels.row), load_pair(from)), point.pairs[g]);
}

/// The same for one group of planes, whose accumulators stay in a register.
inline void add_linear(Point& point, const Candidates& c, const uint32_t* hits, uint32_t count)
{
    const float* data = point.texels.data;
    const int64_t row = point.texels.row;
    Pair sum = point.pairs[0];
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t n = hits[i];
        const float* from = data + c.origin[n];
        const float w0 = c.w0[n], w1 = c.w1[n];
        const Pair w = {w0, w0, w0, w0, w1, w1, w1, w1}, rho = c.rho[n] - Pair{};
        sum = fma_pair(w, fma_pair(rho, load_pair(from + row), load_pair(from)), sum);
    }
    point.pairs[0] = sum;
}

template <uint32_t taps> void add_spline(Point& point, const Candidates& c, uint32_t n)
{
    const Spline spline = spline_of(c.tx[n], c.ty[n], c.sign[n], taps);
    const float* from = texel_under(point, c, n);
    for (uint32_t g = 0; g < point.groups; ++g, from += point.texels.plane)
        for (uint32_t i = 0; i < taps; ++i) {
            const float* column = from + 4 * i;
            for (uint32_t p = 0; p < 4; ++p) {
                float v = spline.y[0] * column[p];
                for (uint32_t j = 1; j < taps; ++j)
                    v = weft_fma(spline.y[j], column[int64_t(j) * point.texels.row + p], v);
                point.quads[g][i][p] = weft_fma(spline.x[i], v, point.quads[g][i][p]);
            }
        }
}

template <uint32_t taps> void add_candidates(Point& point, Candidates& c)
{
    locate_candidates<taps>(point, c);
    uint32_t hits = 0;
    for (uint32_t n = 0; n < c.count; ++n) {
        c.hits[hits] = n;
        hits += uint32_t(c.reaches[n]);
    }
    if (taps == 2 && point.groups == 1 && !point.splat.choose)
        add_linear(point, c, c.hits, hits);
    else
        for (uint32_t i = 0; i < hits; ++i)
            if (taps == 2)
                add_linear(point, c, c.hits[i]);
            else
                add_spline<taps>(point, c, c.hits[i]);
    c.count = 0;
}

void count_impacts(const Splat& splat, Cells& cells)
{
    const uint32_t count = cells.count;
    for (uint32_t n = 0; n < count; ++n) {
        cells.key[n] = weft_absorb(cells.column[n], cells.number[n]);
        cells.high[n] = weft_high(weft_draw(cells.key[n], 0));
        cells.impacts[n] = 0;
    }
    uint32_t highest = 0;
    for (uint32_t n = 0; n < count; ++n) highest = cells.high[n] > highest ? cells.high[n] : highest;
    for (uint32_t i = 0; i < splat.count_limit && splat.counts[i] <= highest; ++i) {
        const uint32_t threshold = splat.counts[i];
        for (uint32_t n = 0; n < count; ++n) cells.impacts[n] += cells.high[n] >= threshold ? 1u : 0u;
    }
}

/// Adds the impacts of some cells. They are listed four at a time, so that the stores need no count.
template <uint32_t taps> void add_cells(Point& point, Cells& cells, Candidates& c)
{
    count_impacts(point.splat, cells);
    for (uint32_t n = 0; n < cells.count; ++n)
        for (uint32_t i = 0; i < cells.impacts[n]; i += 4) {
            if (c.count > most_candidates - 4) add_candidates<taps>(point, c);
            const uint64_t state = cells.key[n] + (uint64_t(i) + 2) * WEFT_GOLDEN;
            for (uint32_t j = 0; j < 4; ++j) {
                c.state[c.count + j] = state + j * WEFT_GOLDEN;
                c.x[c.count + j] = cells.x[n];
                c.y[c.count + j] = cells.y[n];
                c.pixels_x[c.count + j] = cells.pixels_x[n];
                c.pixels_y[c.count + j] = cells.pixels_y[n];
            }
            c.count += cells.impacts[n] - i < 4 ? cells.impacts[n] - i : 4;
        }
    cells.count = 0;
}

template <uint32_t taps> void add_all(Point& point)
{
    const Splat& splat = point.splat;
    const Texels& texels = point.texels;
    const int64_t x = point.spot.cell[0], y = point.spot.cell[1];
    const Range rx = range_of(taps, point.level, texels.x, texels.width, x, int32_t(point.spot.fraction[0]));
    const Range ry = range_of(taps, point.level, texels.y, texels.height, y, int32_t(point.spot.fraction[1]));
    Cells cells;
    Candidates candidates;
    cells.count = candidates.count = 0;
    const Walk top = walk_from(splat, splat.period[1], ry.first);
    for (Walk wx = walk_from(splat, splat.period[0], rx.first);; advance(splat, splat.period[0], wx)) {
        const Cell cx = cell_at(splat, splat.period[0], wx);
        if (cx.begin > rx.last) break;
        const uint64_t column = weft_absorb(splat.key, cx.number);
        for (Walk wy = top;; advance(splat, splat.period[1], wy)) {
            const Cell cy = cell_at(splat, splat.period[1], wy);
            if (cy.begin > ry.last) break;
            const uint32_t n = cells.count++;
            cells.column[n] = column;
            cells.number[n] = cy.number;
            cells.x[n] = int32_t(cx.begin - x);
            cells.y[n] = int32_t(cy.begin - y);
            cells.pixels_x[n] = cx.pixels;
            cells.pixels_y[n] = cy.pixels;
            if (cells.count == most_cells) add_cells<taps>(point, cells, candidates);
        }
    }
    add_cells<taps>(point, cells, candidates);
    add_candidates<taps>(point, candidates);
}

void splat_point(const Splat& splat, uint32_t level, const weft_spot& spot, float* f)
{
    const uint32_t taps = splat.taps;
    Point point = {splat, splat.texels[level], spot, level, (splat.planes + 3) / 4, {}, {}};
    if (taps == 1) add_all<1>(point);
    else if (taps == 2) add_all<2>(point);
    else if (taps == 4) add_all<4>(point);
    else add_all<6>(point);
    for (uint32_t p = 0; p < splat.planes; ++p) {
        const uint32_t g = p / 4, lane = p % 4;
        float sum = taps == 2 ? point.pairs[g][lane] + point.pairs[g][4 + lane] : point.quads[g][0][lane];
        for (uint32_t i = 1; taps != 2 && i < taps; ++i) sum = sum + point.quads[g][i][lane];
        f[p] = sum + splat.offset[p];
    }
}
