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

/// The pieces that values lie in, and how their coefficients are found. `most` is how many pieces there may be.
template <uint32_t most> struct Pieces {
    Pieces(const Tone& tone, const Vector& v) : k{}
    {
        for (uint32_t i = 1; i < tone.count; ++i) k -= v >= same(tone.x[i]);
    }

    Vector of(const float* table) const
    {
        Vector value;
        for (uint32_t i = 0; i < lanes; ++i) value[i] = table[k[i]];
        return value;
    }

    Mask k;
};

#if WEFT_LANES == 16
template <> inline Vector Pieces<16>::of(const float* table) const { return look_up(load(table), k); }
#endif

#if WEFT_LANES == 8
/// Halved three times; what is left of NaN compares as out of reach.
template <> struct Pieces<8> {
    Pieces(const Tone& tone, const Vector& v)
    {
        const Mask four = v >= same(tone.x[4]);
        const Mask two = v >= either(four, same(tone.x[6]), same(tone.x[2]));
        const Mask even = (four & 4) | (two & 2);
        k = even - (v >= look_up(load(tone.x + 1), even));
    }

    Vector of(const float* table) const { return look_up(load(table), k); }

    Mask k;
};

/// Ten knots, which is usual, make one piece more than a register holds.
template <> struct Pieces<9> {
    Pieces(const Tone& tone, const Vector& v) : first(tone, v), last(v >= same(tone.x[8])) {}

    Vector of(const float* table) const { return either(last, same(table[8]), first.of(table)); }

    Pieces<8> first;
    Mask last;
};
#endif

template <uint32_t most> inline Vector toned(const Tone& tone, const Vector& from)
{
    const Vector low = same(tone.low), high = same(tone.high);
    Vector v = either(from < low, low, from);
    v = either(v > high, high, v);
    const Pieces<most> pieces(tone, v);
    const Vector d = v - pieces.of(tone.x);
    return ((pieces.of(tone.c[3]) * d + pieces.of(tone.c[2])) * d + pieces.of(tone.c[1])) * d + pieces.of(tone.c[0]);
}

template <uint32_t most> void tone_row(const Tone& tone, uint32_t width, float* row)
{
    uint32_t x = 0;
    for (; x + lanes <= width; x += lanes) store(toned<most>(tone, load(row + x)), row + x);
    if (x == width) return;
    float rest[lanes] = {0};
    for (uint32_t i = 0; i < width - x; ++i) rest[i] = row[x + i];
    store(toned<most>(tone, load(rest)), rest);
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

/// As many columns as a Value has, a vector or a float; the result of `channels` values f.
template <class Value>
inline void mix_one(const Mixture& m, uint32_t result, uint32_t channels, const Value* f, uint32_t x, float* out)
{
    const float* colour = m.colour + size_t(result) * channels;
    Value sum = m.mean[result] - Value{};
    for (uint32_t c = 0; c < channels; ++c) sum = colour[c] * f[c] + sum;
    float* to = out + result * m.result_plane + x;
    const Value before = m.fresh ? Value{} : read<Value>(to);
    put(m.mask ? read<Value>(m.mask + x) * sum + before : sum + before, to);
}

template <class Value, uint32_t channels> inline void mix_at(const Mixture& m, uint32_t x, float* out)
{
    Value f[channels];
    for (uint32_t c = 0; c < channels; ++c) f[c] = read<Value>(m.f + c * m.plane + x);
    for (uint32_t o = 0; o < channels; ++o) mix_one(m, o, channels, f, x, out);
}

template <uint32_t channels> void mix_same(const Mixture& m, float* out)
{
    uint32_t x = 0;
    for (; x + lanes <= m.width; x += lanes) mix_at<Vector, channels>(m, x, out);
    for (; x < m.width; ++x) mix_at<float, channels>(m, x, out);
}

template <class Value> inline void mix_any_at(const Mixture& m, uint32_t x, float* out)
{
    Value f[most_planes];
    for (uint32_t c = 0; c < m.channels; ++c) f[c] = read<Value>(m.f + c * m.plane + x);
    for (uint32_t o = 0; o < m.results; ++o) mix_one(m, o, m.channels, f, x, out);
}

void mix(const Mixture& m, float* out)
{
    if (m.channels == 3 && m.results == 3) return mix_same<3>(m, out);
    if (m.channels == 1 && m.results == 1) return mix_same<1>(m, out);
    uint32_t x = 0;
    for (; x + lanes <= m.width; x += lanes) mix_any_at<Vector>(m, x, out);
    for (; x < m.width; ++x) mix_any_at<float>(m, x, out);
}
