/// SPLAT windows in vectors. Included by rows.inl, inside its unnamed namespace.
///
/// All pixels of a window see an impact with the same fractions, so what an impact adds to a row of accumulators is a
/// row of texels times constants. Accumulator i of pixel x takes what lies in texel column x + i; it is kept under the
/// number of that column, where all accumulators of a column take the same sum of texels, and the shift by i is done
/// once, at the end. A block of one vector of columns by `band` rows stays in registers while all its impacts pass;
/// zeros around the texels replace tests of bounds, and add nothing to any sum.

constexpr uint32_t lanes = WEFT_LANES;
constexpr uint32_t band_apron = 8; ///< rows of zeros: at least rows + taps - 2 of every band

constexpr uint32_t strip_height = lanes == 8 ? 20 : 24; ///< a multiple of the rows of a block

/// Rows of a block: as many as leave registers for the weights and two rows of texels.
constexpr uint32_t band_rows(uint32_t taps)
{
    constexpr uint32_t most = lanes == 8 ? 10 : 16; // 16 vector registers with AVX2, 32 with AVX-512 and NEON
    return taps == 1 ? 8 : most / taps;
}

typedef float Vector __attribute__((vector_size(WEFT_LANES * 4)));

inline Vector load(const float* from)
{
    Vector v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}

inline void store(const Vector& v, float* to) { __builtin_memcpy(to, &v, sizeof v); }

inline Vector fma(const Vector& a, const Vector& b, const Vector& c)
{
    Vector sum;
    for (uint32_t i = 0; i < lanes; ++i) sum[i] = weft_fma(a[i], b[i], c[i]); // one instruction with both compilers
    return sum;
}

/// Keeps a vector in a register that is used more than once: GCC would rather load it again, and loads are scarce.
inline void keep(Vector& v)
{
#if defined(__x86_64__)
    __asm__("" : "+v"(v));
#elif defined(__aarch64__)
    __asm__("" : "+w"(v));
#endif
}

inline Vector same(float a) { return a - Vector{}; }

/// One block of one plane: `texels` is that of an impact of origin 0, under the block's first pixel.
template <uint32_t taps> struct Gather {
    static constexpr uint32_t rows = band_rows(taps);

    static void block(const float* texels, int64_t pitch, const Impacts& found, const uint32_t* list, uint32_t count,
                      float* sums, uint32_t stride)
    {
        Vector sum[rows][taps];
#pragma GCC unroll 16
        for (uint32_t r = 0; r < rows; ++r)
#pragma GCC unroll 16
            for (uint32_t i = 0; i < taps; ++i) sum[r][i] = Vector{};
        for (uint32_t n = 0; n < count; ++n) {
            const Spline& spline = found.splines[list[n]];
            const float* from = texels + found.impacts[list[n]].origin;
#pragma GCC unroll 16
            for (uint32_t r = 0; r < rows; ++r, from += pitch) {
                Vector v = same(spline.y[0]) * load(from);
#pragma GCC unroll 16
                for (uint32_t j = 1; j < taps; ++j) v = fma(same(spline.y[j]), load(from + j * pitch), v);
#pragma GCC unroll 16
                for (uint32_t i = 0; i < taps; ++i) sum[r][i] = fma(same(spline.x[i]), v, sum[r][i]);
            }
        }
#pragma GCC unroll 16
        for (uint32_t r = 0; r < rows; ++r)
#pragma GCC unroll 16
            for (uint32_t i = 0; i < taps; ++i) store(sum[r][i], sums + (r * taps + i) * stride);
    }
};

/// v without its first element, and then the first of `next`.
inline Vector shift(const Vector& v, const Vector& next)
{
#if WEFT_LANES == 4
    return __builtin_shufflevector(v, next, 1, 2, 3, 4);
#elif WEFT_LANES == 8
    return __builtin_shufflevector(v, next, 1, 2, 3, 4, 5, 6, 7, 8);
#else
    return __builtin_shufflevector(v, next, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);
#endif
}

/// Two taps. Blocks come from right to left: `carry` is A1 of the block to the right, a vector by row, and becomes that
/// of this one. It lies in memory, so that no register is held for it while a block is summed.
struct Linear_block {
    static constexpr uint32_t rows = band_rows(2);

    const Impacts& found;
    int64_t pitch;
    float offset;
    uint32_t stride, height; ///< of what is written; 0 rows of the block that lies beyond the window
    float* carry;

    void sum(const float* texels, const uint32_t* list, uint32_t count, float* out)
    {
        Vector left[rows], right[rows];
#pragma GCC unroll 16
        for (uint32_t r = 0; r < rows; ++r) left[r] = right[r] = Vector{};
        for (uint32_t n = 0; n < count; ++n) {
            const Impact& impact = found.impacts[list[n]];
            const Vector w0 = same(impact.w0), w1 = same(impact.w1), rho = same(impact.rho);
            const float* from = texels + impact.origin;
            Vector above = load(from);
            keep(above);
#pragma GCC unroll 16
            for (uint32_t r = 0; r < rows; ++r) {
                from += pitch;
                Vector below = load(from);
                keep(below);
                const Vector v = fma(rho, below, above);
                left[r] = fma(w0, v, left[r]);
                right[r] = fma(w1, v, right[r]);
                above = below;
            }
        }
#pragma GCC unroll 16
        for (uint32_t r = 0; r < rows; ++r) {
            if (r < height)
                store((left[r] + shift(right[r], load(carry + r * lanes))) + same(offset), out + r * stride);
            store(right[r], carry + r * lanes);
        }
    }
};

/// What a strip is rendered with, in its scratch: the impacts that reach the strip, those that reach a band of it, and
/// of these, for each block of columns, those that reach the block, all in order; and the accumulators of a band.
struct Band {
    uint32_t blocks, stride;
    float* sums;     ///< rows * taps * stride; with two taps rows * lanes, carried from block to block
    uint32_t* strip; ///< numbers of impacts, as in `band` and `lists`
    uint32_t* band;
    int32_t* begin;   ///< of the impacts in `band`: the pixel over their first column of texels,
    int32_t* latest;  ///< the greatest of these up to here,
    int32_t* first;   ///< and the least from here on
    uint32_t* starts; ///< of the lists of the blocks, and the end of the last
    uint32_t* lists;
    bool* hidden; ///< blocks that nothing is seen of

    const uint32_t* list(uint32_t block) const { return lists + starts[block]; }
    uint32_t count(uint32_t block) const { return starts[block + 1] - starts[block]; }
};

uint32_t blocks_for(uint32_t width, uint32_t taps) { return (width + taps - 1 + lanes - 1) / lanes; }

size_t sum_count(uint32_t taps, uint32_t blocks)
{
    return size_t(band_rows(taps)) * lanes * (taps == 2 ? 1 : taps * (size_t(blocks) + 1));
}

size_t scratch(uint32_t impacts, uint32_t width, uint32_t taps)
{
    const size_t blocks = blocks_for(width, taps);
    const size_t sums = sum_count(taps, uint32_t(blocks));
    return (sums + (blocks + 5) * (size_t(impacts) + 1) + 2 * blocks + 1) * sizeof(float);
}

Band band_in(const Strip& strip, uint32_t impacts, uint32_t taps)
{
    Band band;
    band.blocks = blocks_for(strip.width, taps);
    band.stride = (band.blocks + 1) * lanes;
    const size_t limit = size_t(impacts) + 1;
    band.sums = static_cast<float*>(strip.scratch);
    band.strip = reinterpret_cast<uint32_t*>(band.sums + sum_count(taps, band.blocks));
    band.band = band.strip + limit;
    band.begin = reinterpret_cast<int32_t*>(band.band + limit);
    band.latest = band.begin + limit;
    band.first = band.latest + limit;
    band.starts = reinterpret_cast<uint32_t*>(band.first + limit);
    band.hidden = reinterpret_cast<bool*>(band.starts + band.blocks + 1);
    band.lists = band.starts + 2 * band.blocks + 1;
    return band;
}

/// Of `count` impacts, those in `from` or if it is null the first, copies the numbers of those that reach some rows.
uint32_t select(const Impacts& found, const uint32_t* from, uint32_t count, const Texels& texels, uint32_t taps,
                uint32_t first, uint32_t rows, uint32_t* to)
{
    const int32_t highest = texels.height - int32_t(first), lowest = -int32_t(first + rows + taps - 2);
    uint32_t selected = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t n = from ? from[i] : i;
        const int32_t row = found.impacts[n].row;
        to[selected] = n;
        selected += uint32_t((row >= lowest) & (row < highest));
    }
    return selected;
}

/// Where the impacts of a band begin. They come by cell x, so that begin grows but for the size of a cell: all those
/// before the first with latest >= x lie left of x, and all those from the first with first > x on lie right of it.
void find_begins(const Band& band, const Impacts& found, uint32_t count)
{
    int32_t latest = INT32_MIN, first = INT32_MAX;
    for (uint32_t i = 0; i < count; ++i) {
        const int32_t begin = -found.impacts[band.band[i]].column;
        latest = begin > latest ? begin : latest;
        band.begin[i] = begin;
        band.latest[i] = latest;
    }
    for (uint32_t i = count; i-- > 0;) {
        first = band.begin[i] < first ? band.begin[i] : first;
        band.first[i] = first;
    }
}

/// Which blocks of rows y..y + height - 1 the mask hides. Accumulators are shifted to the left, so that a block is seen
/// through those before it too, as far as the taps reach.
void find_hidden(const Band& band, const Strip& strip, uint32_t y, uint32_t height, uint32_t taps)
{
    const uint32_t reach = (taps - 1 + lanes - 1) / lanes;
    uint32_t zeros = reach; // blocks in succession
    for (uint32_t b = 0; b < band.blocks; ++b) {
        const uint32_t begin = b * lanes, end = begin + lanes < strip.width ? begin + lanes : strip.width;
        bool zero = strip.mask != nullptr;
        for (uint32_t r = y; r < y + height && zero; ++r)
            for (uint32_t x = begin; x < end; ++x) zero &= strip.mask[size_t(r) * strip.stride + x] == 0;
        zeros = zero ? zeros + 1 : 0;
        band.hidden[b] = zeros > reach;
    }
}

/// For each block, the impacts of the band that reach it, unless it is hidden.
void fill_lists(const Band& band, const Texels& texels, const Impacts& found, uint32_t count)
{
    find_begins(band, found, count);
    const uint32_t reach = uint32_t(texels.width) + lanes - 1, blocks = band.blocks;
    const int32_t* const begins = band.begin;
    const uint32_t* const numbers = band.band;
    uint32_t* const lists = band.lists;
    uint32_t from = 0, to = 0, filled = 0;
    for (uint32_t b = 0; b < blocks; ++b) {
        const int32_t right = int32_t(b * lanes + lanes - 1), left = right - int32_t(reach) + 1;
        while (from < count && band.latest[from] < left) ++from;
        while (to < count && band.first[to] <= right) ++to;
        band.starts[b] = filled;
        for (uint32_t i = from; i < to && !band.hidden[b]; ++i) {
            lists[filled] = numbers[i];
            filled += uint32_t(begins[i] - left) < reach ? 1u : 0u;
        }
    }
    band.starts[blocks] = filled;
}

/// Rows y..y + height - 1 of a strip, one plane after another.
template <uint32_t taps> struct Rows_of {
    static void render(const Splat& splat, const Texels& texels, const Impacts& found, const Strip& strip,
                       const Band& band, uint32_t y, uint32_t height)
    {
        for (uint32_t p = 0; p < splat.planes; ++p) {
            const float* plane = texels.data + p * texels.plane + int64_t(strip.first + y) * texels.row;
            for (uint32_t b = 0; b < band.blocks; ++b)
                Gather<taps>::block(plane + b * lanes, texels.row, found, band.list(b), band.count(b),
                                    band.sums + b * lanes, band.stride);
            for (uint32_t r = 0; r < height; ++r) {
                const float* sums = band.sums + size_t(r) * taps * band.stride;
                float* out = strip.data + (size_t(p) * strip.count + y + r) * strip.stride;
                for (uint32_t x = 0; x < strip.width; ++x) {
                    float f = sums[x];
                    for (uint32_t i = 1; i < taps; ++i) f = f + sums[i * band.stride + x + i];
                    out[x] = f + splat.offset[p];
                }
            }
        }
    }
};

template <> struct Rows_of<2> {
    static void render(const Splat& splat, const Texels& texels, const Impacts& found, const Strip& strip,
                       const Band& band, uint32_t y, uint32_t height)
    {
        for (uint32_t p = 0; p < splat.planes; ++p) {
            const float* plane = texels.data + p * texels.plane + int64_t(strip.first + y) * texels.row;
            float* out = strip.data + (size_t(p) * strip.count + y) * strip.stride;
            Linear_block block = {found, texels.row, splat.offset[p], strip.stride, 0, band.sums};
            for (uint32_t i = 0; i < block.rows * lanes; ++i) block.carry[i] = 0.0f;
            for (uint32_t b = band.blocks; b-- > 0;) {
                block.height = b * lanes < strip.width ? height : 0;
                block.sum(plane + b * lanes, band.list(b), band.count(b), out + b * lanes);
            }
        }
    }
};

template <uint32_t taps>
void splat_bands(const Splat& splat, const Texels& texels, const Impacts& found, const Strip& strip)
{
    constexpr uint32_t rows = band_rows(taps);
    const Band band = band_in(strip, found.count, taps);
    const uint32_t near = select(found, nullptr, found.count, texels, taps, strip.first, strip.count, band.strip);
    for (uint32_t y = 0; y < strip.count; y += rows) {
        find_hidden(band, strip, y, strip.count - y < rows ? strip.count - y : rows, taps);
        fill_lists(band, texels, found,
                   select(found, band.strip, near, texels, taps, strip.first + y, rows, band.band));
        Rows_of<taps>::render(splat, texels, found, strip, band, y, strip.count - y < rows ? strip.count - y : rows);
    }
}

void splat_strip(const Splat& splat, uint32_t level, const Impacts& found, const Strip& strip)
{
    const Texels& texels = splat.texels[level];
    if (splat.taps == 1)
        splat_bands<1>(splat, texels, found, strip);
    else if (splat.taps == 2)
        splat_bands<2>(splat, texels, found, strip);
    else if (splat.taps == 4)
        splat_bands<4>(splat, texels, found, strip);
    else
        splat_bands<6>(splat, texels, found, strip);
}
