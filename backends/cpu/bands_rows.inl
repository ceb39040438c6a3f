/// BANDS, the loops over a row of a window. Included by rows.inl, inside its unnamed namespace.

void refine(const float* above, const float* below, uint32_t odd, uint32_t pairs, float* __restrict row)
{
    constexpr uint32_t step = 128;
    float v[step + 1]; // between the two rows
    for (uint32_t begin = 0; begin < pairs; begin += step, above += step, below += step, row += 2 * step) {
        const uint32_t count = pairs - begin < step ? pairs - begin : step;
        if (odd != 0)
            for (uint32_t i = 0; i <= count; ++i) v[i] = weft_refine_odd(above[i], below[i]);
        else
            for (uint32_t i = 0; i <= count; ++i) v[i] = weft_refine_even(above[i], below[i]);
        for (uint32_t i = 0; i < count; ++i) {
            row[2 * i] = weft_refine_even(v[i], v[i + 1]);
            row[2 * i + 1] = weft_refine_odd(v[i], v[i + 1]);
        }
    }
}

void add_lattice(const float* refined, const float* lattice, uint32_t first, uint32_t size, float weight,
                 uint32_t count, float* __restrict row)
{
    for (uint32_t x = 0; x < count; first = 0) {
        const uint32_t rest = size - first, end = count - x < rest ? count : x + rest;
        for (const float* from = lattice + first; x < end; ++x, ++from)
            row[x] = weft_band_add(weight, *from, refined[x]);
    }
}

// At the centres of pixels, where the spline's weights are these.
void spline_row(const float* c, uint32_t width, float* __restrict row)
{
    for (uint32_t x = 0; x < width; ++x) row[x] = weft_quadratic_sum(0.125f, 0.75f, 0.125f, c[x], c[x + 1], c[x + 2]);
}

void spline_rows(const float* upper, const float* middle, const float* lower, uint32_t width, float* __restrict row)
{
    for (uint32_t x = 0; x < width; ++x)
        row[x] = weft_quadratic_sum(0.125f, 0.75f, 0.125f, upper[x], middle[x], lower[x]);
}
