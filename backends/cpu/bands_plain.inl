/// BANDS at a position in plain loops: the reference. Included by rows.inl, inside its unnamed namespace.

/// Three coefficients of an axis, from those of the next coarser band; `odd` if the finer cell is the second of two.
void refine_three(float* c, uint32_t stride, bool odd)
{
    float &c0 = c[0], &c1 = c[stride], &c2 = c[2 * stride];
    const float a = c0, b = c1, d = c2;
    c0 = odd ? weft_refine_odd(a, b) : weft_refine_even(a, b);
    c1 = odd ? weft_refine_even(b, d) : weft_refine_odd(a, b);
    c2 = odd ? weft_refine_odd(b, d) : weft_refine_even(b, d);
}

void refine_all(float* c, const int64_t* cell)
{
    for (uint32_t x = 0; x < 3; ++x) refine_three(c + x, 3, (cell[1] & 1) != 0);
    for (uint32_t y = 0; y < 9; y += 3) refine_three(c + y, 1, (cell[0] & 1) != 0);
}

/// Where the coefficients of a cell are, per axis.
struct Indices {
    Indices(const Lattice& lattice, uint32_t axes, const int64_t* cell)
    {
        for (uint32_t a = 0; a < axes; ++a)
            for (uint32_t i = 0; i < 3; ++i) at[a][i] = weft_band_index(cell[a] + i, lattice.shift[a], lattice.size[a]);
    }
    uint32_t at[3][3];
};

void add_coefficients(const Lattice& lattice, float weight, const int64_t* cell, float* c)
{
    const Indices indices(lattice, 2, cell);
    for (uint32_t y = 0; y < 3; ++y) {
        const float* row = lattice.data + indices.at[1][y] * lattice.row;
        for (uint32_t x = 0; x < 3; ++x, ++c) *c = weft_band_add(weight, row[indices.at[0][x]], *c);
    }
}

float spline_three(const weft_quadratic& w, const float* c, uint32_t stride)
{
    return weft_quadratic_sum(w.w0, w.w1, w.w2, c[0], c[stride], c[2 * stride]);
}

/// A spot, and the level of a BANDS layer that it sees.
struct Seen {
    Seen(const Bands& bands, const weft_spot& at)
        : spot(at), between(weft_level(at.level)), level(uint32_t(between.whole))
    {
        if (level > bands.count) level = bands.count;
    }

    void find_cell(uint32_t band, int64_t* cell) const
    {
        for (uint32_t a = 0; a < 3; ++a) cell[a] = weft_band_cell(spot.cell[a], band);
    }
    void find_weights(uint32_t band, uint32_t axes, weft_quadratic* weights) const
    {
        for (uint32_t a = 0; a < axes; ++a)
            weights[a] = weft_quadratic_weights(weft_band_place(spot.cell[a], spot.fraction[a], band));
    }
    float weight(const Lattice& lattice, uint32_t band) const
    {
        return band == level ? weft_band_weight(lattice.weight, between.t) : lattice.weight;
    }

    const weft_spot& spot;
    weft_between between;
    uint32_t level; ///< at most the number of bands
};

void bands_in_plane(const Bands& bands, const Seen& seen, float* f, size_t pitch)
{
    weft_quadratic weights[2] = {};
    if (seen.level < bands.count) seen.find_weights(seen.level, 2, weights);
    for (uint32_t p = 0; p < bands.planes; ++p) {
        float c[9] = {0};
        for (uint32_t b = bands.count; b-- > seen.level;) {
            int64_t cell[3];
            seen.find_cell(b, cell);
            const Lattice& lattice = bands.lattices[size_t(b) * bands.planes + p];
            if (b + 1 < bands.count) refine_all(c, cell);
            if (lattice.data) add_coefficients(lattice, seen.weight(lattice, b), cell, c);
        }
        for (uint32_t y = 0; y < 3; ++y) c[y] = spline_three(weights[0], c + 3 * y, 1);
        f[p * pitch] = spline_three(weights[1], c, 1);
    }
}

/// The sum along z, then along y, of one column of the 27 coefficients of a cell.
float sum_column(const Lattice& lattice, const Indices& indices, uint32_t i, const weft_quadratic* weights)
{
    float u[3];
    for (uint32_t y = 0; y < 3; ++y) {
        const float* from = lattice.data + indices.at[1][y] * lattice.row + indices.at[0][i];
        const float column[3] = {from[indices.at[2][0] * lattice.slice], from[indices.at[2][1] * lattice.slice],
                                 from[indices.at[2][2] * lattice.slice]};
        u[y] = spline_three(weights[2], column, 1);
    }
    return spline_three(weights[1], u, 1);
}

void bands_in_space(const Bands& bands, const Seen& seen, float* f, size_t pitch)
{
    float sums[most_planes][3] = {{0}};
    for (uint32_t b = bands.count; b-- > seen.level;) {
        int64_t cell[3];
        weft_quadratic weights[3];
        seen.find_cell(b, cell);
        seen.find_weights(b, 3, weights);
        const float x[3] = {weights[0].w0, weights[0].w1, weights[0].w2};
        for (uint32_t p = 0; p < bands.planes; ++p) {
            const Lattice& lattice = bands.lattices[size_t(b) * bands.planes + p];
            if (!lattice.data) continue;
            const Indices indices(lattice, 3, cell);
            const float weight = seen.weight(lattice, b);
            for (uint32_t i = 0; i < 3; ++i)
                sums[p][i] = weft_band_add(x[i] * weight, sum_column(lattice, indices, i, weights), sums[p][i]);
        }
    }
    for (uint32_t p = 0; p < bands.planes; ++p) f[p * pitch] = sums[p][0] + (sums[p][1] + sums[p][2]);
}

void bands_spots(const Bands& bands, uint32_t axes, const weft_spot* spots, uint32_t count, float* f, size_t pitch)
{
    for (uint32_t i = 0; i < count; ++i) {
        const Seen seen(bands, spots[i]);
        if (axes == 3)
            bands_in_space(bands, seen, f + i, pitch);
        else
            bands_in_plane(bands, seen, f + i, pitch);
    }
}
