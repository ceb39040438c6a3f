/// SPLAT at a point in vectors. Included by rows.inl, inside its unnamed namespace.
///
/// In three steps, each a loop over arrays: the keys and counts of the cells that can reach, the impacts of those
/// cells, the texels of the impacts that do reach, which lie four planes side by side, with zeros around.

constexpr uint32_t chunk = lanes > 8 ? lanes : 8; ///< loops take so many at once, and arrays are filled up with zeros
constexpr uint32_t most_cells = 64, most_candidates = 256;

typedef float Pair __attribute__((vector_size(32))); ///< two texels of four planes
typedef uint64_t States __attribute__((vector_size(32)));
typedef uint32_t Eight __attribute__((vector_size(32)));
typedef int32_t Whole __attribute__((vector_size(32)));
typedef uint8_t Places __attribute__((vector_size(8)));
typedef int32_t Four __attribute__((vector_size(16)));

inline uint32_t whole_chunks(uint32_t count) { return (count + chunk - 1) / chunk * chunk; }

template <class T> inline void put(const T& value, void* to) { __builtin_memcpy(to, &value, sizeof value); }

template <class T> inline void clear_chunk(T* from) { __builtin_memset(from, 0, chunk * sizeof(T)); }

/// A stretch of one axis of cells. Pixels are relative to that of the point.
struct Axis {
    uint32_t count;
    uint64_t number[most_cells + 4];
    int32_t begin[most_cells + 4];
    int32_t pixels[most_cells + 4];
};

/// Cells around a point, in canonical order.
struct Cells {
    uint32_t count;
    alignas(64) uint64_t key[most_cells + chunk]; ///< at first what the last step of the key is made of
    alignas(64) uint32_t high[most_cells + chunk];
    alignas(64) uint32_t impacts[most_cells + chunk];
    alignas(64) int32_t x[most_cells + chunk], y[most_cells + chunk];
    alignas(64) int32_t pixels_x[most_cells + chunk], pixels_y[most_cells + chunk]; ///< only if some cells are cut
};

/// Impacts of cells: `state` is what their number is made of, x and y their cell, then their pixel.
struct Candidates {
    uint32_t count;
    alignas(64) uint64_t state[most_candidates + chunk];
    alignas(64) int32_t x[most_candidates + chunk], y[most_candidates + chunk];
    alignas(64) int32_t pixels_x[most_candidates + chunk], pixels_y[most_candidates + chunk];
    alignas(64) uint32_t low[most_candidates + chunk], high[most_candidates + chunk];
    alignas(64) float tx[most_candidates + chunk], ty[most_candidates + chunk], sign[most_candidates + chunk];
    alignas(64) float w0[most_candidates + chunk], w1[most_candidates + chunk], rho[most_candidates + chunk];
    alignas(64) int32_t origin[most_candidates + chunk];
    alignas(64) uint32_t reaches[most_candidates + chunk];
    uint32_t hits[most_candidates + chunk];
};

/// A point being evaluated.
struct Point {
    Point(const Splat& s, uint32_t l, const weft_spot& at, bool is_cut)
        : splat(s), texels(s.texels[l]), spot(at), level(l), groups((s.planes + 3) / 4), cut(is_cut)
    {
    }

    const Splat& splat;
    const Texels& texels;
    const weft_spot& spot;
    uint32_t level, groups;
    bool cut;                           ///< some cells are cut by the period
    alignas(32) float sums[10 * 6 * 4]; ///< of group g of four planes: tap i of plane p at (g * taps + i) * 4 + p
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
template <uint32_t taps, bool base> void locate_candidates(const Point& point, Candidates& c)
{
    const Texels& texels = point.texels;
    const uint32_t shift = 16 - point.splat.cell_log2, level = base ? 0 : point.level, signs = point.splat.signs;
    const int32_t fx = int32_t(point.spot.fraction[0]), fy = int32_t(point.spot.fraction[1]);
    const int32_t before = taps > 2 ? int32_t(taps) / 2 - 1 : 0;
    const int32_t left = texels.x + before, top = texels.y + before, pitch = int32_t(texels.row);
    const uint32_t reach = taps - 1, width = uint32_t(texels.width) + reach, height = uint32_t(texels.height) + reach;
    const uint32_t count = whole_chunks(c.count);
    for (uint32_t n = 0; n < count; ++n) {
        const uint64_t z = weft_mix(c.state[n]);
        c.low[n] = weft_low(z);
        c.high[n] = weft_high(z);
    }
    for (uint32_t n = 0; n < count; ++n) {
        const uint32_t ax = c.low[n] >> shift, ay = c.high[n] >> shift;
        const int32_t x = c.x[n] + int32_t(ax >> 16), y = c.y[n] + int32_t(ay >> 16);
        const Place at_x = place_at(-x, fx - int32_t(((ax & 0xffff) * 2 + 1) << 7), level, taps);
        const Place at_y = place_at(-y, fy - int32_t(((ay & 0xffff) * 2 + 1) << 7), level, taps);
        const int32_t column = at_x.first - left, row = at_y.first - top;
        c.x[n] = x;
        c.y[n] = y;
        c.reaches[n] = uint32_t((uint32_t(column) + reach < width) & (uint32_t(row) + reach < height));
        c.origin[n] = int32_t(uint32_t(row) * uint32_t(pitch) + uint32_t(column) * 4u);
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
    if (!point.cut) return;
    for (uint32_t n = 0; n < c.count; ++n)
        c.reaches[n] &= uint32_t((int32_t((c.low[n] >> shift) >> 16) < c.pixels_x[n]) &
                                 (int32_t((c.high[n] >> shift) >> 16) < c.pixels_y[n]));
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

/// Adds one impact to one group of planes, whose accumulators are the two halves of `sum`.
inline Pair add_linear(const float* from, int64_t row, const Candidates& c, uint32_t n, const Pair& sum)
{
    const Pair w0 = c.w0[n] - Pair{}, w1 = c.w1[n] - Pair{}, rho = c.rho[n] - Pair{};
    const Pair w = __builtin_shufflevector(w0, w1, 0, 1, 2, 3, 12, 13, 14, 15);
    return fma_pair(w, fma_pair(rho, load_pair(from + row), load_pair(from)), sum);
}

void add_linear(Point& point, const Candidates& c, uint32_t count)
{
    const int64_t row = point.texels.row;
    if (point.groups > 1 || point.splat.choose) {
        for (uint32_t i = 0; i < count; ++i) {
            const float* from = texel_under(point, c, c.hits[i]);
            for (uint32_t g = 0; g < point.groups; ++g, from += point.texels.plane)
                put(add_linear(from, row, c, c.hits[i], load_pair(point.sums + 8 * g)), point.sums + 8 * g);
        }
        return;
    }
    const float* data = point.texels.data;
    Pair sum = load_pair(point.sums);
    for (uint32_t i = 0; i < count; ++i) sum = add_linear(data + c.origin[c.hits[i]], row, c, c.hits[i], sum);
    put(sum, point.sums);
}

template <uint32_t taps> void add_spline(Point& point, const Candidates& c, uint32_t n)
{
    const Spline spline = spline_of(c.tx[n], c.ty[n], c.sign[n], taps);
    const float* from = texel_under(point, c, n);
    float* sum = point.sums;
    for (uint32_t g = 0; g < point.groups; ++g, from += point.texels.plane)
        for (uint32_t i = 0; i < taps; ++i, sum += 4)
            for (uint32_t p = 0; p < 4; ++p) {
                const float* texel = from + 4 * i + p;
                float v = spline.y[0] * *texel;
                for (uint32_t j = 1; j < taps; ++j) v = weft_fma(spline.y[j], texel[int64_t(j) * point.texels.row], v);
                sum[p] = weft_fma(spline.x[i], v, sum[p]);
            }
}

/// For each set of eight flags, where it has ones, and how many.
struct Positions {
    constexpr Positions()
    {
        for (uint32_t set = 0; set < 256; ++set)
            for (uint8_t i = 0; i < 8; ++i)
                if ((set >> i & 1) != 0) of[set][count[set]++] = i;
    }

    uint8_t of[256][8] = {};
    uint8_t count[256] = {};
};

constexpr Positions positions;

/// Lists the candidates that reach, eight at a time, so that no step waits for each flag in turn.
template <class Listed> inline uint32_t list_hits(Listed& c)
{
    clear_chunk(c.reaches + c.count);
    uint32_t hits = 0;
    for (uint32_t n = 0, count = c.count; n < count; n += 8) {
        uint64_t pairs[4];
        __builtin_memcpy(pairs, c.reaches + n, sizeof pairs);
        const uint64_t even = pairs[0] | pairs[1] << 2 | pairs[2] << 4 | pairs[3] << 6;
        const uint32_t set = (weft_low(even) | uint32_t(even >> 31)) & 255;
        Places places;
        __builtin_memcpy(&places, positions.of[set], sizeof places);
        put(n + __builtin_convertvector(places, Eight), c.hits + hits);
        hits += positions.count[set];
    }
    return hits;
}

template <uint32_t taps> void add_candidates(Point& point, Candidates& c)
{
    clear_chunk(c.state + c.count);
    clear_chunk(c.x + c.count);
    clear_chunk(c.y + c.count);
    if (point.level == 0)
        locate_candidates<taps, true>(point, c);
    else
        locate_candidates<taps, false>(point, c);
    const uint32_t hits = list_hits(c);
    if (taps == 2)
        add_linear(point, c, hits);
    else
        for (uint32_t i = 0; i < hits; ++i) add_spline<taps>(point, c, c.hits[i]);
    c.count = 0;
}

/// Keys, and how many of the usual thresholds each reaches.
void count_impacts(const Splat& splat, Cells& cells)
{
    clear_chunk(cells.key + cells.count);
    const uint32_t count = whole_chunks(cells.count);
    for (uint32_t n = 0; n < count; ++n) {
        cells.key[n] = weft_mix(cells.key[n]);
        cells.high[n] = weft_high(weft_draw(cells.key[n], 0));
    }
    for (uint32_t n = 0; n < count; n += 8) {
        Eight high, impacts = {};
        __builtin_memcpy(&high, cells.high + n, sizeof high);
        for (uint32_t i = 0; i < splat.usual_counts; ++i) impacts -= Eight(high >= splat.counts[i] + Eight{});
        put(impacts, cells.impacts + n);
    }
}

/// Lists eight impacts of cell n, whether there are so many or not: the stores depend on no count.
inline void list_eight(const Point& point, const Cells& cells, uint32_t n, const States& state, Candidates& c,
                       uint32_t to)
{
    put(state, c.state + to);
    put(state + 4 * WEFT_GOLDEN, c.state + to + 4);
    put(cells.x[n] + Whole{}, c.x + to);
    put(cells.y[n] + Whole{}, c.y + to);
    if (!point.cut) return;
    put(cells.pixels_x[n] + Whole{}, c.pixels_x + to);
    put(cells.pixels_y[n] + Whole{}, c.pixels_y + to);
}

/// Adds the impacts of some cells.
template <uint32_t taps> void add_cells(Point& point, Cells& cells, Candidates& c)
{
    const States steps = {2 * WEFT_GOLDEN, 3 * WEFT_GOLDEN, 4 * WEFT_GOLDEN, 5 * WEFT_GOLDEN};
    const Splat& splat = point.splat;
    count_impacts(splat, cells);
    const uint32_t listed = splat.usual_counts > 9 ? 16 : 8; // of every cell: then how many there are is no branch
    uint32_t to = c.count; // in a register: the stores could change c.count, for all a compiler knows
    for (uint32_t n = 0, count = cells.count; n < count; ++n) {
        uint32_t left = cells.impacts[n];
        if (left == splat.usual_counts) left = impact_count(splat, cells.key[n]);
        States state = cells.key[n] + steps;
        for (;;) {
            if (to > most_candidates - listed) {
                c.count = to;
                add_candidates<taps>(point, c);
                to = 0;
            }
            for (uint32_t i = 0; i < listed; i += 8, state += 8 * WEFT_GOLDEN)
                list_eight(point, cells, n, state, c, to + i);
            to += left < listed ? left : listed;
            if (left <= listed) break;
            left -= listed;
        }
    }
    c.count = to;
    cells.count = 0;
}

/// The next cells of an axis, up to the one that holds pixel `last`; false: there are no more behind them.
bool next_cells(const Splat& splat, uint32_t period, int64_t origin, int64_t last, Walk& walk, Axis& axis)
{
    for (axis.count = 0; axis.count < most_cells; advance(splat, period, walk)) {
        const Cell cell = cell_at(splat, period, walk);
        if (cell.begin > last) return false;
        axis.number[axis.count] = cell.number;
        axis.begin[axis.count] = int32_t(cell.begin - origin);
        axis.pixels[axis.count++] = cell.pixels;
    }
    return true;
}

/// Appends cells of one column, four at a time.
template <uint32_t taps>
void append_cells(Point& point, const Cell& cx, uint64_t column, const Axis& rows, Cells& cells, Candidates& candidates)
{
    if (cells.count + rows.count > most_cells) add_cells<taps>(point, cells, candidates);
    const Four x = int32_t(cx.begin - point.spot.cell[0]) + Four{};
    for (uint32_t j = 0; j < rows.count; j += 4) {
        States numbers;
        Four y;
        __builtin_memcpy(&numbers, rows.number + j, sizeof numbers);
        __builtin_memcpy(&y, rows.begin + j, sizeof y);
        put((column ^ numbers) + WEFT_GOLDEN, cells.key + cells.count + j);
        put(x, cells.x + cells.count + j);
        put(y, cells.y + cells.count + j);
        if (!point.cut) continue;
        __builtin_memcpy(&y, rows.pixels + j, sizeof y);
        put(cx.pixels + Four{}, cells.pixels_x + cells.count + j);
        put(y, cells.pixels_y + cells.count + j);
    }
    cells.count += rows.count;
}

template <uint32_t taps> void add_all(Point& point)
{
    const Splat& splat = point.splat;
    const Texels& texels = point.texels;
    const int64_t x = point.spot.cell[0], y = point.spot.cell[1];
    const Range rx = range_of(taps, point.level, texels.x, texels.width, x, int32_t(point.spot.fraction[0]));
    const Range ry = range_of(taps, point.level, texels.y, texels.height, y, int32_t(point.spot.fraction[1]));
    Axis rows;
    Cells cells;
    Candidates candidates;
    cells.count = candidates.count = 0;
    const Walk top = walk_from(splat, splat.period[1], ry.first);
    Walk wy = top;
    bool more = next_cells(splat, splat.period[1], y, ry.last, wy, rows);
    const bool once = !more; // then the same rows serve every column
    for (Walk wx = walk_from(splat, splat.period[0], rx.first);; advance(splat, splat.period[0], wx)) {
        const Cell cx = cell_at(splat, splat.period[0], wx);
        if (cx.begin > rx.last) break;
        const uint64_t column = weft_absorb(splat.key, cx.number);
        append_cells<taps>(point, cx, column, rows, cells, candidates);
        if (once) continue;
        while (more) {
            more = next_cells(splat, splat.period[1], y, ry.last, wy, rows);
            append_cells<taps>(point, cx, column, rows, cells, candidates);
        }
        wy = top;
        more = next_cells(splat, splat.period[1], y, ry.last, wy, rows);
    }
    add_cells<taps>(point, cells, candidates);
    add_candidates<taps>(point, candidates);
}

void splat_point(const Splat& splat, uint32_t level, const weft_spot& spot, float* f)
{
    const uint32_t taps = splat.taps, mask = (uint32_t(1) << splat.cell_log2) - 1;
    const bool cut = ((splat.period[0] | splat.period[1]) & mask) != 0;
    Point point(splat, level, spot, cut);
    for (uint32_t i = 0; i < point.groups * taps * 4; ++i) point.sums[i] = 0.0f;
    if (taps == 1)
        add_all<1>(point);
    else if (taps == 2)
        add_all<2>(point);
    else if (taps == 4)
        add_all<4>(point);
    else
        add_all<6>(point);
    for (uint32_t p = 0; p < splat.planes; ++p) {
        const float* sums = point.sums + (p / 4) * taps * 4 + p % 4;
        float sum = sums[0];
        for (uint32_t i = 1; i < taps; ++i) sum = sum + sums[4 * i];
        f[p] = sum + splat.offset[p];
    }
}
