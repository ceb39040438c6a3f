/// BANDS, the loops over a row of a window. Included by rows.inl, inside its unnamed namespace.

#if WEFT_LANES == 1

void refine(const Refine& r, float* __restrict row)
{
    size_t k = r.first;
    for (size_t i = 0; i < 2 * size_t(r.pairs); ++i) {
        float c = 0.0f;
        if (r.above) {
            const auto between = [&](size_t m) {
                return r.odd != 0 ? weft_refine_odd(r.above[m], r.below[m]) : weft_refine_even(r.above[m], r.below[m]);
            };
            const float a = between(i / 2), b = between(i / 2 + 1);
            c = i % 2 != 0 ? weft_refine_odd(a, b) : weft_refine_even(a, b);
        }
        if (r.lattice) c = weft_band_add(r.weight, r.lattice[k], c);
        k = k + 1 < r.size ? k + 1 : 0;
        row[i] = c;
    }
}

/// At the centres of pixels, where the spline's weights are these.
void spline_row(const float* c, size_t width, float* __restrict row)
{
    for (size_t x = 0; x < width; ++x) row[x] = weft_quadratic_sum(0.125f, 0.75f, 0.125f, c[x], c[x + 1], c[x + 2]);
}

void spline_rows(const float* upper, const float* middle, const float* lower, size_t width, float* __restrict row)
{
    for (size_t x = 0; x < width; ++x)
        row[x] = weft_quadratic_sum(0.125f, 0.75f, 0.125f, upper[x], middle[x], lower[x]);
}

#else

/// Elements of a and b in turn, from the first to the last.
inline void interleave(Vector& first, Vector& second)
{
    const Vector even = first, odd = second;
#if WEFT_LANES == 4
    first = __builtin_shufflevector(even, odd, 0, 4, 1, 5);
    second = __builtin_shufflevector(even, odd, 2, 6, 3, 7);
#elif WEFT_LANES == 8
    const Vector a = __builtin_shufflevector(even, odd, 0, 8, 1, 9, 4, 12, 5, 13);
    const Vector b = __builtin_shufflevector(even, odd, 2, 10, 3, 11, 6, 14, 7, 15);
    first = __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
    second = __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
#else
    first = __builtin_shufflevector(even, odd, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
    second = __builtin_shufflevector(even, odd, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);
#endif
}

inline Vector between_rows(const Refine& r, size_t i, float near, float far)
{
    return same(near) * load(r.above + i) + same(far) * load(r.below + i);
}

void refine(const Refine& r, float* __restrict row)
{
    const float near = r.odd != 0 ? 0.25f : 0.75f, far = 1.0f - near;
    uint32_t k = r.first;
    Vector next = r.above ? between_rows(r, 0, near, far) : Vector{};
    for (size_t i = 0; i < r.pairs; i += lanes, row += 2 * lanes) {
        Vector first{}, second{};
        if (r.above) {
            const Vector a = next;
            next = between_rows(r, i + lanes, near, far);
            const Vector b = shift(a, next);
            first = same(0.75f) * a + same(0.25f) * b;
            second = same(0.25f) * a + same(0.75f) * b;
            interleave(first, second);
        }
        if (r.lattice) { // a row is longer than its size by two vectors at least
            first = same(r.weight) * load(r.lattice + k) + first;
            second = same(r.weight) * load(r.lattice + k + lanes) + second;
            __builtin_prefetch(r.lattice + k + r.size + overrun); // in the next row
            k += 2 * lanes;
            if (k >= r.size) k = r.size >= 2 * lanes ? k - r.size : k % r.size;
        }
        store(first, row);
        store(second, row + lanes);
    }
}

/// At the centres of pixels, where the spline's weights are these.
inline Vector spline(const Vector& a, const Vector& b, const Vector& c)
{
    return same(0.125f) * a + (same(0.75f) * b + same(0.125f) * c);
}

void spline_row(const float* c, size_t width, float* __restrict row)
{
    for (size_t x = 0; x < width; x += lanes) store(spline(load(c + x), load(c + x + 1), load(c + x + 2)), row + x);
}

void spline_rows(const float* upper, const float* middle, const float* lower, size_t width, float* __restrict row)
{
    for (size_t x = 0; x < width; x += lanes)
        store(spline(load(upper + x), load(middle + x), load(lower + x)), row + x);
}

#endif
