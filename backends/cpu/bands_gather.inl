/// BANDS at positions in vectors. Included by rows.inl, inside its unnamed namespace.
///
/// Four lanes of a vector belong to a spot; they hold the three coefficients of a row and one that has no meaning. The
/// lattices are copies in which three rows, slices and columns follow each other also across the border.

constexpr uint32_t spots = lanes / 4, most_together = 4; ///< spots, and planes, that are evaluated together

typedef int32_t Mask __attribute__((vector_size(WEFT_LANES * 4)));

/// The same permutation within each four lanes.
#if WEFT_LANES == 4
#define WEFT_PICK(v, a, b, c, d) __builtin_shufflevector(v, v, a, b, c, d)
#elif WEFT_LANES == 8
#define WEFT_PICK(v, a, b, c, d) __builtin_shufflevector(v, v, a, b, c, d, a + 4, b + 4, c + 4, d + 4)
#else
#define WEFT_PICK(v, a, b, c, d)                                                                                       \
    __builtin_shufflevector(v, v, a, b, c, d, a + 4, b + 4, c + 4, d + 4, a + 8, b + 8, c + 8, d + 8, a + 12, b + 12,  \
                            c + 12, d + 12)
#endif

typedef float Quad __attribute__((vector_size(16)));

inline Quad load_quad(const float* from)
{
    Quad v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}

/// Four lanes from each of `spots` addresses.
inline Vector load_spots(const float* const* from)
{
#if WEFT_LANES == 4
    return load_quad(from[0]);
#else
    typedef float Pair __attribute__((vector_size(32)));
    const Pair low = __builtin_shufflevector(load_quad(from[0]), load_quad(from[1]), 0, 1, 2, 3, 4, 5, 6, 7);
#if WEFT_LANES == 8
    return low;
#else
    const Pair high = __builtin_shufflevector(load_quad(from[2]), load_quad(from[3]), 0, 1, 2, 3, 4, 5, 6, 7);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
#endif
#endif
}

/// How an axis is refined, per spot, in all its lanes: of the coefficients a, b, c of the coarser band come near * a +
/// far * b, then the middle one, then near * b + far * c. The middle one is 3/4 b and 1/4 of a or, if `odd`, of c.
struct Parity {
    Vector near, far;
    Mask odd;
};

inline Parity parity_of(const weft_spot* const* at, uint32_t axis, uint32_t band)
{
    alignas(16) static constexpr float near[2][4] = {{0.75f, 0.75f, 0.75f, 0.75f}, {0.25f, 0.25f, 0.25f, 0.25f}};
    const float* from[spots];
    for (uint32_t s = 0; s < spots; ++s) from[s] = near[weft_band_cell(at[s]->cell[axis], band) & 1];
    Parity parity;
    parity.near = load_spots(from);
    parity.far = same(1.0f) - parity.near; // exact
    parity.odd = parity.near < parity.far;
    return parity;
}

inline Vector either(const Mask& mask, const Vector& yes, const Vector& no)
{
    return reinterpret_cast<Vector>((reinterpret_cast<Mask>(yes) & mask) | (reinterpret_cast<Mask>(no) & ~mask));
}

/// weft_refine_even and weft_refine_odd of three vectors; sums do not depend on the order of two terms.
inline void refine_lines(const Parity& parity, Vector& a, Vector& b, Vector& c)
{
    const Vector middle = same(0.75f) * b + same(0.25f) * either(parity.odd, c, a);
    const Vector first = parity.near * a + parity.far * b;
    c = parity.near * b + parity.far * c;
    a = first;
    b = middle;
}

/// The same of the first three lanes; `parity` has `near` and `far` 1/4 and 3/4 in the lane between.
inline Vector refine_lanes(const Parity& parity, const Vector& v)
{
    const Vector left = either(parity.odd, WEFT_PICK(v, 0, 2, 1, 3), WEFT_PICK(v, 0, 0, 1, 3));
    return parity.near * left + parity.far * WEFT_PICK(v, 1, 1, 2, 3);
}

inline Parity for_lanes(const Parity& parity)
{
    Mask between{};
    for (uint32_t s = 0; s < spots; ++s) between[4 * s + 1] = -1;
    return {either(between, same(0.25f), parity.near), either(between, same(0.75f), parity.far), parity.odd};
}

/// Spots whose levels have the same whole part, one for each four lanes.
struct Lanes {
    const weft_spot* at[spots];
    uint32_t level;
    bool whole; ///< none is between two levels
    alignas(64) float t[lanes];

    Vector weight(const Lattice& lattice, uint32_t band) const
    {
        const Vector weight = same(lattice.weight);
        if (band != level || whole) return weight;
        Vector between;
        __builtin_memcpy(&between, t, sizeof between);
        return weight * (same(1.0f) - between);
    }
};

/// Where the lattices of a band are read, for each plane and spot.
struct Sources {
    const float* from[most_together][spots];
};

/// Offset of the first coefficient of a cell.
template <uint32_t slices> inline int64_t first_of(const Lattice& lattice, const int64_t* cell)
{
    const uint32_t *shift = lattice.shift, *size = lattice.size;
    uint32_t first[3];
    for (uint32_t a = 0; a < (slices > 1 ? 3 : 2); ++a)
        first[a] = lattice.powers ? (uint32_t(cell[a]) + shift[a]) & (size[a] - 1)
                                  : weft_band_index(cell[a], shift[a], size[a]);
    const int64_t in_slice = first[1] * lattice.row + first[0];
    return slices > 1 ? first[2] * lattice.slice + in_slice : in_slice;
}

/// Finds the first coefficients. Solids are large: most of the time would go by with waiting for memory, if it were not
/// asked early for all that a band needs.
template <uint32_t slices>
inline void find_sources(const Lattice* lattices, uint32_t planes, const Lanes& at, uint32_t band, Sources& sources)
{
    int64_t cell[spots][3];
    for (uint32_t s = 0; s < spots; ++s)
        for (uint32_t a = 0; a < 3; ++a) cell[s][a] = weft_band_cell(at.at[s]->cell[a], band);
    for (uint32_t p = 0; p < planes; ++p) {
        const Lattice& lattice = lattices[p];
        if (!lattice.data) continue;
        for (uint32_t s = 0; s < spots; ++s) {
            const float* from = lattice.data + first_of<slices>(lattice, cell[s]);
            sources.from[p][s] = from;
#pragma GCC unroll 9
            for (uint32_t y = 0; y < 9 && slices > 1; ++y)
                __builtin_prefetch(from + y / 3 * lattice.slice + y % 3 * lattice.row);
        }
    }
}

/// c = weight * lattice + c, of `slices` times three rows.
template <uint32_t slices>
inline void add_coefficients(const Lattice& lattice, const float* const* from, const Vector& weight, Vector* c)
{
#pragma GCC unroll 9
    for (uint32_t y = 0; y < 3 * slices; ++y) {
        const float* row[spots];
        for (uint32_t s = 0; s < spots; ++s) row[s] = from[s] + y / 3 * lattice.slice + y % 3 * lattice.row;
        c[y] = weight * load_spots(row) + c[y];
    }
}

template <uint32_t slices> inline void refine_all(const Parity* parity, Vector* c)
{
    if (slices > 1)
#pragma GCC unroll 3
        for (uint32_t y = 0; y < 3; ++y) refine_lines(parity[2], c[y], c[3 + y], c[6 + y]);
#pragma GCC unroll 3
    for (uint32_t z = 0; z < slices; ++z) refine_lines(parity[1], c[3 * z], c[3 * z + 1], c[3 * z + 2]);
#pragma GCC unroll 9
    for (uint32_t y = 0; y < 3 * slices; ++y) c[y] = refine_lanes(parity[0], c[y]);
}

/// Weights of the spline of an axis: of x side by side, of others each in all lanes of its spot.
template <uint32_t slices> struct Spline_lanes {
    explicit Spline_lanes(const Lanes& at)
    {
        for (uint32_t a = 0; a < (slices > 1 ? 3 : 2); ++a)
            for (uint32_t s = 0; s < spots; ++s) {
                const weft_quadratic q =
                    weft_quadratic_weights(weft_band_place(at.at[s]->cell[a], at.at[s]->fraction[a], at.level));
                const float weights[3] = {q.w0, q.w1, q.w2};
                for (uint32_t i = 0; i < 12; ++i) w[a][i / 4][4 * s + i % 4] = weights[a == 0 ? i % 4 % 3 : i / 4];
            }
    }

    Vector sum(uint32_t axis, const Vector& a, const Vector& b, const Vector& c) const
    {
        return w[axis][0] * a + (w[axis][1] * b + w[axis][2] * c);
    }

    /// f in the first lane of each spot.
    Vector f(Vector* c) const
    {
        for (uint32_t y = 0; y < 3 * slices; ++y) {
            const Vector product = w[0][0] * c[y];
            c[y] = product + (WEFT_PICK(product, 1, 1, 1, 1) + WEFT_PICK(product, 2, 2, 2, 2));
        }
        for (uint32_t z = 0; z < slices; ++z) c[z] = sum(1, c[3 * z], c[3 * z + 1], c[3 * z + 2]);
        return slices > 1 ? sum(2, c[0], c[1], c[2]) : c[0];
    }

    Vector w[3][3];
};

template <uint32_t slices> void bands_lanes(const Bands& bands, const Lanes& at, uint32_t count, float* f, size_t pitch)
{
    constexpr uint32_t lines = 3 * slices;
    Vector c[most_together * lines];
    const Spline_lanes<slices> spline(at);
    for (uint32_t first = 0; first < bands.planes; first += most_together) {
        const uint32_t planes = bands.planes - first < most_together ? bands.planes - first : most_together;
        for (uint32_t i = 0; i < planes * lines; ++i) c[i] = Vector{};
        Sources sources[2]; // of odd and of even bands
        const auto lattices_of = [&](uint32_t b) { return bands.lattices + size_t(b) * bands.planes + first; };
        find_sources<slices>(lattices_of(bands.count - 1), planes, at, bands.count - 1, sources[(bands.count - 1) & 1]);
        for (uint32_t b = bands.count; b-- > at.level;) {
            const Lattice* lattices = lattices_of(b);
            if (b > at.level) find_sources<slices>(lattices_of(b - 1), planes, at, b - 1, sources[(b - 1) & 1]);
            const Parity parity[3] = {for_lanes(parity_of(at.at, 0, b)), parity_of(at.at, 1, b),
                                      parity_of(at.at, slices > 1 ? 2 : 1, b)};
            for (uint32_t p = 0; p < planes; ++p) {
                Vector v[lines]; // in registers
                for (uint32_t i = 0; i < lines; ++i) v[i] = c[p * lines + i];
                if (b + 1 < bands.count) refine_all<slices>(parity, v);
                if (lattices[p].data)
                    add_coefficients<slices>(lattices[p], sources[b & 1].from[p], at.weight(lattices[p], b), v);
                for (uint32_t i = 0; i < lines; ++i) c[p * lines + i] = v[i];
            }
        }
        for (uint32_t p = 0; p < planes; ++p) {
            const Vector value = spline.f(c + p * lines);
            for (uint32_t s = 0; s < count; ++s) f[s * pitch + first + p] = value[4 * s];
        }
    }
}

void bands_spots(const Bands& bands, uint32_t axes, const weft_spot* from, uint32_t count, float* f, size_t pitch)
{
    for (uint32_t i = 0, n = 0; i < count; i += n, f += n * pitch) {
        Lanes at;
        at.level = uint32_t(weft_level(from[i].level).whole);
        at.whole = true;
        for (n = 0; n < spots && i + n < count; ++n) {
            const weft_between between = weft_level(from[i + n].level);
            if (uint32_t(between.whole) != at.level) break;
            at.whole = at.whole && !(between.t > 0);
            at.at[n] = from + i + n;
            for (uint32_t s = n; s < spots; ++s)
                for (uint32_t j = 0; j < 4; ++j) at.t[4 * s + j] = between.t;
        }
        for (uint32_t s = n; s < spots; ++s) at.at[s] = from + i;
        if (at.level >= bands.count)
            for (uint32_t j = 0; j < n * bands.planes; ++j) f[j / bands.planes * pitch + j % bands.planes] = 0.0f;
        else if (axes == 3)
            bands_lanes<3>(bands, at, n, f, pitch);
        else
            bands_lanes<1>(bands, at, n, f, pitch);
    }
}
