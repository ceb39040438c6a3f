/// BANDS in space in vectors, and the choice between plane and space. Included by rows.inl, inside its unnamed
/// namespace.
///
/// Four lanes of a vector belong to a spot: the three columns of a cell's coefficients and one that has no meaning, or
/// the axes x, y, z. All sums but the last, once for all bands, are within lanes.

typedef uint64_t Axes __attribute__((vector_size(32))); ///< of one spot

/// Spots as fixed point numbers with 24 bits of fraction.
struct Solid_spots {
    explicit Solid_spots(const Lanes& at)
    {
        for (uint32_t s = 0; s < spots; ++s)
            for (uint32_t a = 0; a < 3; ++a)
                fixed[s][a] = (uint64_t(at.at[s]->cell[a]) << WEFT_FRACTION_BITS) + at.at[s]->fraction[a];
    }

    /// weft_band_place of three axes.
    Quad place(uint32_t s, uint32_t band) const
    {
        const Axes bits = fixed[s] >> band & uint64_t(WEFT_FRACTION_MASK);
        typedef int32_t Whole4 __attribute__((vector_size(16)));
        return __builtin_convertvector(__builtin_convertvector(bits, Whole4), Quad) * WEFT_FRACTION_UNIT;
    }

    Axes fixed[spots]{};
};

/// Weights of the spline in one band: of x side by side, of y and z each in all lanes of its spot.
struct Solid_weights {
    Solid_weights(const Solid_spots& at, uint32_t band)
    {
        float places[spots][4];
        const float* from[spots];
        for (uint32_t s = 0; s < spots; ++s) {
            const Quad place = at.place(s, band);
            __builtin_memcpy(places[s], &place, sizeof place);
            from[s] = places[s];
        }
        const Vector t = load_spots(from), rest = same(1.0f) - t;
        const Vector w0 = same(0.5f) * (rest * rest), w2 = same(0.5f) * (t * t), w1 = same(1.0f) - (w0 + w2);
        y[0] = WEFT_PICK(w0, 1, 1, 1, 1);
        y[1] = WEFT_PICK(w1, 1, 1, 1, 1);
        y[2] = WEFT_PICK(w2, 1, 1, 1, 1);
        z[0] = WEFT_PICK(w0, 2, 2, 2, 2);
        z[1] = WEFT_PICK(w1, 2, 2, 2, 2);
        z[2] = WEFT_PICK(w2, 2, 2, 2, 2);
        Mask second{}, third{};
        for (uint32_t s = 0; s < spots; ++s) second[4 * s + 1] = third[4 * s + 2] = -1;
        x = either(third, WEFT_PICK(w2, 0, 0, 0, 0), either(second, WEFT_PICK(w1, 0, 0, 0, 0), w0));
    }

    static Vector sum(const Vector* w, const Vector& a, const Vector& b, const Vector& c)
    {
        return w[0] * a + (w[1] * b + w[2] * c);
    }

    Vector x, y[3], z[3];
};

/// The sums along z and then y of each column.
inline Vector sum_columns(const Lattice& lattice, const float* const* from, const Solid_weights& w)
{
    Vector u[3];
#pragma GCC unroll 3
    for (uint32_t y = 0; y < 3; ++y) {
        Vector slice[3];
#pragma GCC unroll 3
        for (uint32_t z = 0; z < 3; ++z) {
            const float* row[spots];
            for (uint32_t s = 0; s < spots; ++s) row[s] = from[s] + z * lattice.slice + y * lattice.row;
            slice[z] = load_spots(row);
        }
        u[y] = w.sum(w.z, slice[0], slice[1], slice[2]);
    }
    return w.sum(w.y, u[0], u[1], u[2]);
}

void bands_in_space(const Bands& bands, const Lanes& at, uint32_t count, float* f, size_t pitch)
{
    Vector sums[most_planes];
    Sources sources[2]; // of even and of odd bands
    const Solid_spots positions(at);
    for (uint32_t p = 0; p < bands.planes; ++p) sums[p] = Vector{};
    find_sources<3>(bands, at, bands.count - 1, sources[(bands.count - 1) & 1]);
    for (uint32_t b = bands.count; b-- > at.level;) {
        if (b > at.level) find_sources<3>(bands, at, b - 1, sources[(b - 1) & 1]);
        const Solid_weights weights(positions, b);
        for (uint32_t p = 0; p < bands.planes; ++p) {
            const Lattice& lattice = bands.lattices[size_t(b) * bands.planes + p];
            if (!lattice.data) continue;
            const Vector v = sum_columns(lattice, sources[b & 1].from[p], weights);
            sums[p] = weights.x * at.weight(lattice, b) * v + sums[p];
        }
    }
    for (uint32_t p = 0; p < bands.planes; ++p)
        for (uint32_t s = 0; s < count; ++s)
            f[p * pitch + s] = sums[p][4 * s] + (sums[p][4 * s + 1] + sums[p][4 * s + 2]);
}

void bands_spots(const Bands& bands, uint32_t axes, const weft_spot* from, uint32_t count, float* f, size_t pitch)
{
    for (uint32_t i = 0, n = 0; i < count; i += n, f += n) {
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
            for (uint32_t j = 0; j < n * bands.planes; ++j) f[j / n * pitch + j % n] = 0.0f;
        else if (axes == 3)
            bands_in_space(bands, at, n, f, pitch);
        else
            bands_in_plane(bands, at, n, f, pitch);
    }
}
