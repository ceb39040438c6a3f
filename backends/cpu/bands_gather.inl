/// BANDS at positions in vectors. Included by rows.inl, inside its unnamed namespace.
///
/// Four lanes of a vector belong to a spot; they hold the three coefficients of a row and one that has no meaning. The
/// lattices are copies in which three rows, slices and columns follow each other also across the border.

constexpr uint32_t spots = lanes / 4; ///< that are evaluated together

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

inline Vector either(const Mask& mask, const Vector& yes, const Vector& no) { return mask ? yes : no; }

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

/// Offset of the first coefficient of a cell.
template <uint32_t axes> inline int64_t first_of(const Lattice& lattice, const int64_t* cell)
{
    const uint32_t *shift = lattice.shift, *size = lattice.size;
    uint32_t first[3];
    for (uint32_t a = 0; a < axes; ++a)
        first[a] = lattice.powers ? (uint32_t(cell[a]) + shift[a]) & (size[a] - 1)
                                  : weft_band_index(cell[a], shift[a], size[a]);
    const int64_t in_slice = first[1] * lattice.row + first[0];
    return axes > 2 ? first[2] * lattice.slice + in_slice : in_slice;
}

/// Where the lattices of a band are read, for each plane and spot.
struct Sources {
    const float* from[most_planes][spots];
};

/// Finds the first coefficients, and asks early for all that are needed: lattices do not stay in the nearest caches.
template <uint32_t axes> inline void find_sources(const Bands& bands, const Lanes& at, uint32_t band, Sources& sources)
{
    int64_t cell[spots][3];
    for (uint32_t s = 0; s < spots; ++s)
        for (uint32_t a = 0; a < 3; ++a) cell[s][a] = weft_band_cell(at.at[s]->cell[a], band);
    for (uint32_t p = 0; p < bands.planes; ++p) {
        const Lattice& lattice = bands.lattices[size_t(band) * bands.planes + p];
        if (!lattice.data) continue;
        for (uint32_t s = 0; s < spots; ++s) {
            const float* from = lattice.data + first_of<axes>(lattice, cell[s]);
            sources.from[p][s] = from;
#pragma GCC unroll 9
            for (uint32_t y = 0; y < (axes > 2 ? 9 : 3); ++y)
                __builtin_prefetch(from + y / 3 * lattice.slice + y % 3 * lattice.row);
        }
    }
}

/// c = weight * lattice + c, of three rows.
inline void add_coefficients(const Lattice& lattice, const float* const* from, const Vector& weight, Vector* c)
{
#pragma GCC unroll 3
    for (uint32_t y = 0; y < 3; ++y) {
        const float* row[spots];
        for (uint32_t s = 0; s < spots; ++s) row[s] = from[s] + y * lattice.row;
        c[y] = weight * load_spots(row) + c[y];
    }
}

/// Weights of the spline of an axis: of x side by side, of y each in all lanes of its spot.
struct Spline_lanes {
    explicit Spline_lanes(const Lanes& at)
    {
        for (uint32_t a = 0; a < 2; ++a)
            for (uint32_t s = 0; s < spots; ++s) {
                const weft_quadratic q =
                    weft_quadratic_weights(weft_band_place(at.at[s]->cell[a], at.at[s]->fraction[a], at.level));
                const float weights[3] = {q.w0, q.w1, q.w2};
                for (uint32_t i = 0; i < 12; ++i) w[a][i / 4][4 * s + i % 4] = weights[a == 0 ? i % 4 % 3 : i / 4];
            }
    }

    /// f in the first lane of each spot.
    Vector f(Vector* c) const
    {
        for (uint32_t y = 0; y < 3; ++y) {
            const Vector product = w[0][0] * c[y];
            c[y] = product + (WEFT_PICK(product, 1, 1, 1, 1) + WEFT_PICK(product, 2, 2, 2, 2));
        }
        return w[1][0] * c[0] + (w[1][1] * c[1] + w[1][2] * c[2]);
    }

    Vector w[2][3];
};

void bands_in_plane(const Bands& bands, const Lanes& at, uint32_t count, float* f, size_t pitch)
{
    Vector c[most_planes * 3];
    Sources sources[2]; // of even and of odd bands
    for (uint32_t i = 0; i < bands.planes * 3; ++i) c[i] = Vector{};
    find_sources<2>(bands, at, bands.count - 1, sources[(bands.count - 1) & 1]);
    for (uint32_t b = bands.count; b-- > at.level;) {
        if (b > at.level) find_sources<2>(bands, at, b - 1, sources[(b - 1) & 1]);
        const Parity x = for_lanes(parity_of(at.at, 0, b)), y = parity_of(at.at, 1, b);
        for (uint32_t p = 0; p < bands.planes; ++p) {
            const Lattice& lattice = bands.lattices[size_t(b) * bands.planes + p];
            Vector v[3] = {c[3 * p], c[3 * p + 1], c[3 * p + 2]}; // in registers
            if (b + 1 < bands.count) {
                refine_lines(y, v[0], v[1], v[2]);
                for (uint32_t i = 0; i < 3; ++i) v[i] = refine_lanes(x, v[i]);
            }
            if (lattice.data) add_coefficients(lattice, sources[b & 1].from[p], at.weight(lattice, b), v);
            for (uint32_t i = 0; i < 3; ++i) c[3 * p + i] = v[i];
        }
    }
    const Spline_lanes spline(at);
    for (uint32_t p = 0; p < bands.planes; ++p) {
        const Vector value = spline.f(c + p * 3);
        for (uint32_t s = 0; s < count; ++s) f[p * pitch + s] = value[4 * s];
    }
}
