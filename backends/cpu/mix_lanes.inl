/// Tone curves and sums of layers in vectors. Included by rows.inl, inside its unnamed namespace.

/// Some tables of a tone curve are looked up within registers.
#if WEFT_LANES == 8
inline Vector look_up(const Vector& table, const Mask& k)
{
    return _mm256_permutevar8x32_ps(table, reinterpret_cast<__m256i>(k));
}
#elif WEFT_LANES == 16
inline Vector look_up(const Vector& table, const Mask& k)
{
    return _mm512_maskz_permutexvar_ps(0xffff, reinterpret_cast<__m512i>(k), table);
}
#endif

/// A tone curve of up to `most` pieces; a piece is found, and then its coefficients are, for all lanes at once.
template <uint32_t most> struct Curve {
    explicit Curve(const Tone& t) : tone(t) {}

    Vector operator()(const Vector& v) const
    {
        Mask k{};
        for (uint32_t i = 1; i < tone.count; ++i) k -= v >= same(tone.x[i]);
        const auto of = [&](const float* table) {
            Vector value;
            for (uint32_t i = 0; i < lanes; ++i) value[i] = table[k[i]];
            return value;
        };
        return polynomial(v - of(tone.x), of(tone.c[0]), of(tone.c[1]), of(tone.c[2]), of(tone.c[3]));
    }

    static Vector polynomial(const Vector& d, const Vector& c0, const Vector& c1, const Vector& c2, const Vector& c3)
    {
        return ((c3 * d + c2) * d + c1) * d + c0;
    }

    const Tone& tone;
};

#if WEFT_LANES == 16
template <> inline Vector Curve<16>::operator()(const Vector& v) const
{
    Mask k{};
    for (uint32_t i = 1; i < tone.count; ++i) k -= v >= same(tone.x[i]);
    const auto of = [&](const float* table) { return look_up(load(table), k); };
    return polynomial(v - of(tone.x), of(tone.c[0]), of(tone.c[1]), of(tone.c[2]), of(tone.c[3]));
}
#endif

#if WEFT_LANES == 8
/// Eight pieces fill a register, and are halved three times: NaN is never reached. Ten knots, which is usual, make a
/// ninth.
struct Curve_of_few {
    explicit Curve_of_few(const Tone& tone)
        : second(same(tone.x[2])), fourth(same(tone.x[4])), sixth(same(tone.x[6])), eighth(same(tone.x[8])),
          next(load(tone.x + 1)), x(load(tone.x)), last_x(same(tone.x[8]))
    {
        for (uint32_t i = 0; i < 4; ++i) {
            c[i] = load(tone.c[i]);
            last_c[i] = same(tone.c[i][8]);
        }
    }

    template <bool ninth> Vector at(const Vector& v) const
    {
        const Mask high = v >= fourth, even = (high & 4) | ((v >= either(high, sixth, second)) & 2);
        const Mask k = even - (v >= look_up(next, even)), last = v >= eighth;
        const auto of = [&](const Vector& table, const Vector& behind) {
            const Vector found = look_up(table, k);
            return ninth ? either(last, behind, found) : found;
        };
        const Vector d = v - of(x, last_x);
        Vector value = of(c[3], last_c[3]);
        for (uint32_t i = 3; i-- > 0;) value = value * d + of(c[i], last_c[i]);
        return value;
    }

    Vector second, fourth, sixth, eighth, next, x, last_x, c[4], last_c[4];
};

template <> struct Curve<8> : Curve_of_few {
    using Curve_of_few::Curve_of_few;
    Vector operator()(const Vector& v) const { return at<false>(v); }
};

template <> struct Curve<9> : Curve_of_few {
    using Curve_of_few::Curve_of_few;
    Vector operator()(const Vector& v) const { return at<true>(v); }
};
#endif

template <uint32_t most> void tone_row(const Tone& tone, uint32_t width, float* row)
{
    const Curve<most> curve(tone);
    const Vector low = same(tone.low), high = same(tone.high);
    const auto toned = [&](const float* from) {
        Vector v = load(from);
        v = v < low ? low : v;
        return curve(v > high ? high : v);
    };
    uint32_t x = 0;
    for (; x + lanes <= width; x += lanes) store(toned(row + x), row + x);
    if (x == width) return;
    float rest[lanes] = {0};
    for (uint32_t i = 0; i < width - x; ++i) rest[i] = row[x + i];
    store(toned(rest), rest);
    for (uint32_t i = 0; i < width - x; ++i) row[x + i] = rest[i];
}

void tone(const Tone& tone, uint32_t width, float* row)
{
#if WEFT_LANES == 16
    if (tone.count <= 16) return tone_row<16>(tone, width, row);
#elif WEFT_LANES == 8
    if (tone.count <= 8) return tone_row<8>(tone, width, row);
    if (tone.count == 9) return tone_row<9>(tone, width, row);
#endif
    tone_row<most_pieces>(tone, width, row);
}

template <class Value> inline Value read(const float* from)
{
    Value v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}

/// As many columns as a Value has, a vector or a float: what `channels` values f make of one result.
template <class Value>
inline void mix_one(const Mixture& m, const float* colour, float mean, uint32_t channels, const Value* f,
                    const float* mask, float* out)
{
    Value sum = mean - Value{};
    for (uint32_t c = 0; c < channels; ++c) sum = colour[c] * f[c] + sum;
    const Value before = m.fresh ? Value{} : read<Value>(out);
    put(m.mask ? read<Value>(mask) * sum + before : sum + before, out);
}

/// As many results as channels; matrix and mean stay in registers.
template <uint32_t channels> struct Square {
    explicit Square(const Mixture& mixture) : m(mixture)
    {
        for (uint32_t i = 0; i < channels * channels; ++i) colour[i] = m.colour[i];
        for (uint32_t i = 0; i < channels; ++i) mean[i] = m.mean[i];
    }

    template <class Value> void at(uint32_t x, float* out) const
    {
        Value f[channels];
        for (uint32_t c = 0; c < channels; ++c) f[c] = read<Value>(m.f + c * m.plane + x);
        for (uint32_t o = 0; o < channels; ++o)
            mix_one(m, colour + o * channels, mean[o], channels, f, m.mask ? m.mask + x : nullptr,
                    out + o * m.result_plane + x);
    }

    void run(float* out) const
    {
        uint32_t x = 0;
        for (; x + lanes <= m.width; x += lanes) at<Vector>(x, out);
        for (; x < m.width; ++x) at<float>(x, out);
    }

    const Mixture m;
    float colour[channels * channels], mean[channels];
};

template <class Value> inline void mix_at(const Mixture& m, uint32_t x, float* out)
{
    Value f[most_planes];
    for (uint32_t c = 0; c < m.channels; ++c) f[c] = read<Value>(m.f + c * m.plane + x);
    for (uint32_t o = 0; o < m.results; ++o)
        mix_one(m, m.colour + size_t(o) * m.channels, m.mean[o], m.channels, f, m.mask ? m.mask + x : nullptr,
                out + o * m.result_plane + x);
}

void mix(const Mixture& m, float* out)
{
    if (m.channels == 3 && m.results == 3) return Square<3>(m).run(out);
    if (m.channels == 1 && m.results == 1) return Square<1>(m).run(out);
    uint32_t x = 0;
    for (; x + lanes <= m.width; x += lanes) mix_at<Vector>(m, x, out);
    for (; x < m.width; ++x) mix_at<float>(m, x, out);
}
