/// Tone curves and sums of layers in plain loops: the reference. Included by rows.inl, inside its unnamed namespace.

constexpr uint32_t step = 64; ///< columns at once

/// Pieces are counted for all columns before they are looked up: that compilers can turn into vectors.
void tone(const Tone& curve, uint32_t width, float* row)
{
    for (uint32_t begin = 0; begin < width; begin += step) {
        const uint32_t count = width - begin < step ? width - begin : step;
        float* values = row + begin;
        uint32_t pieces[step] = {0};
        for (uint32_t x = 0; x < count; ++x) values[x] = weft_clamp(values[x], curve.low, curve.high);
        for (uint32_t i = 1; i < curve.count; ++i)
            for (uint32_t x = 0; x < count; ++x) pieces[x] += values[x] >= curve.x[i] ? 1u : 0u;
        for (uint32_t x = 0; x < count; ++x) {
            const uint32_t k = pieces[x];
            values[x] =
                weft_piece_at(values[x] - curve.x[k], curve.c[0][k], curve.c[1][k], curve.c[2][k], curve.c[3][k]);
        }
    }
}

/// One result channel of up to `step` columns from `begin` on.
void mix_columns(const Mixture& m, uint32_t result, uint32_t begin, uint32_t width, float* __restrict out)
{
    const float* colour = m.colour + size_t(result) * m.channels;
    float sum[step];
    for (uint32_t x = 0; x < width; ++x) sum[x] = m.mean[result];
    for (uint32_t c = 0; c < m.channels; ++c) {
        const float* f = m.f + c * m.plane + begin;
        for (uint32_t x = 0; x < width; ++x) sum[x] = weft_madd(colour[c], f[x], sum[x]);
    }
    for (uint32_t x = 0; x < width; ++x)
        out[x] = weft_madd(m.mask ? m.mask[begin + x] : 1.0f, sum[x], m.fresh ? 0.0f : out[x]);
}

void mix(const Mixture& m, float* out)
{
    for (uint32_t begin = 0; begin < m.width; begin += step)
        for (uint32_t o = 0; o < m.results; ++o)
            mix_columns(m, o, begin, m.width - begin < step ? m.width - begin : step, out + o * m.result_plane + begin);
}
