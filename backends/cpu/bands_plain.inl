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

/// `axes` is 2 or 3; of c, 3 or 9 rows are used.
void refine_all(float* c, uint32_t axes, const int64_t* cell)
{
    const uint32_t rows = axes == 3 ? 9 : 3;
    if (axes == 3)
        for (uint32_t i = 0; i < 9; ++i) refine_three(c + i, 9, (cell[2] & 1) != 0);
    for (uint32_t z = 0; z < rows; z += 3)
        for (uint32_t x = 0; x < 3; ++x) refine_three(c + 3 * z + x, 3, (cell[1] & 1) != 0);
    for (uint32_t y = 0; y < rows; ++y) refine_three(c + 3 * y, 1, (cell[0] & 1) != 0);
}

void add_coefficients(const Lattice& lattice, float weight, uint32_t axes, const int64_t* cell, float* c)
{
    uint32_t at[3][3] = {};
    for (uint32_t a = 0; a < axes; ++a)
        for (uint32_t i = 0; i < 3; ++i) at[a][i] = weft_band_index(cell[a] + i, lattice.shift[a], lattice.size[a]);
    for (uint32_t z = 0; z < (axes == 3 ? 3 : 1); ++z)
        for (uint32_t y = 0; y < 3; ++y) {
            const float* row = lattice.data + at[2][z] * lattice.slice + at[1][y] * lattice.row;
            for (uint32_t x = 0; x < 3; ++x, ++c) *c = weft_band_add(weight, row[at[0][x]], *c);
        }
}

float spline_three(const weft_quadratic& w, const float* c, uint32_t stride)
{
    return weft_quadratic_sum(w.w0, w.w1, w.w2, c[0], c[stride], c[2 * stride]);
}

float spline_all(const weft_quadratic* w, uint32_t axes, float* c)
{
    const uint32_t rows = axes == 3 ? 9 : 3;
    for (uint32_t y = 0; y < rows; ++y) c[y] = spline_three(w[0], c + 3 * y, 1);
    for (uint32_t z = 0; z < rows / 3; ++z) c[z] = spline_three(w[1], c + 3 * z, 1);
    return axes == 3 ? spline_three(w[2], c, 1) : c[0];
}

void bands_spot(const Bands& bands, uint32_t axes, const weft_spot& spot, float* f)
{
    const weft_between between = weft_level(spot.level);
    const uint32_t level = uint32_t(between.whole);
    weft_quadratic weights[3] = {};
    for (uint32_t a = 0; a < axes && level < bands.count; ++a)
        weights[a] = weft_quadratic_weights(weft_band_place(spot.cell[a], spot.fraction[a], level));
    for (uint32_t p = 0; p < bands.planes; ++p) {
        float c[27] = {0};
        for (uint32_t b = bands.count; b-- > level;) {
            const int64_t cell[3] = {weft_band_cell(spot.cell[0], b), weft_band_cell(spot.cell[1], b),
                                     weft_band_cell(spot.cell[2], b)};
            const Lattice& lattice = bands.lattices[size_t(b) * bands.planes + p];
            if (b + 1 < bands.count) refine_all(c, axes, cell);
            if (!lattice.data) continue;
            const float weight = b == level ? weft_band_weight(lattice.weight, between.t) : lattice.weight;
            add_coefficients(lattice, weight, axes, cell, c);
        }
        f[p] = level < bands.count ? spline_all(weights, axes, c) : 0.0f;
    }
}

void bands_spots(const Bands& bands, uint32_t axes, const weft_spot* spots, uint32_t count, float* f, size_t pitch)
{
    for (uint32_t i = 0; i < count; ++i) bands_spot(bands, axes, spots[i], f + i * pitch);
}
