/// The row kernels, compiled once per instruction set. WEFT_ISA names the set and the namespace, WEFT_LANES the floats
/// of its vectors; 1 selects the plain loops of the reference. Each object has one symbol, the table: everything else
/// lies in an unnamed namespace, so that no function compiled for this set can be merged with that of another.
#include "../common/field.h"
#include "rows.h"
#include <float.h>

static_assert(FLT_EVAL_METHOD == 0, "floats must be evaluated as floats");

namespace weft {
namespace WEFT_ISA {
namespace {

#include "compose_look.inl"
#include "impacts.inl"
#if WEFT_LANES == 1
#include "bands_plain.inl"
#include "bands_rows.inl"
#include "compose_plain.inl"
#include "splat_plain.inl"
#include "surface_plain.inl"
#else
#include "splat_block.inl"

#include "bands_gather.inl"
#include "bands_rows.inl"
#include "bands_solid.inl"
#include "splat_gather.inl"
#include "surface_gather.inl"

#include "compose_gather.inl"
#endif

void expand(const float* texels, const Columns& columns, float* row)
{
    for (uint32_t r = 0; r < columns.run_count; ++r) {
        const Run run = columns.runs[r];
        if (run.scattered != 0) {
            for (uint32_t x = run.begin; x < run.end; ++x)
                row[x] = weft_lerp(texels[columns.first[x]], texels[columns.second[x]], columns.t[x]);
            continue;
        }
        const float* from = texels + run.first;
        for (uint32_t x = run.begin; x < run.end; ++x)
            row[x] = weft_lerp(from[x - run.begin], from[x - run.begin + 1], columns.t[x]);
    }
}

void lerp(const float* a, const float* b, float t, uint32_t width, float* row)
{
    for (uint32_t x = 0; x < width; ++x) row[x] = weft_lerp(a[x], b[x], t);
}

void tone(const weft_tone& curve, uint32_t width, float* row)
{
    for (uint32_t x = 0; x < width; ++x) {
        const float v = weft_clamp(row[x], curve.low, curve.high);
        uint32_t k = 0;
        for (uint32_t i = 1; i < curve.count; ++i) k += v >= curve.pieces[i].x ? 1u : 0u;
        const weft_piece& piece = curve.pieces[k];
        row[x] = weft_piece_at(v - piece.x, piece.c0, piece.c1, piece.c2, piece.c3);
    }
}

void multiply(const float* a, const float* b, uint32_t width, float* row)
{
    for (uint32_t x = 0; x < width; ++x) row[x] = a[x] * b[x];
}

template <uint32_t channels, bool fresh> void mix_few(const Mixture& m, float* out)
{
    for (uint32_t x = 0; x < m.width; ++x) {
        float sum = m.mean;
        for (uint32_t c = 0; c < channels; ++c) sum = weft_madd(m.colour[c], m.f[size_t(c) * m.plane + x], sum);
        out[x] = weft_madd(m.mask ? m.mask[x] : 1.0f, sum, fresh ? 0.0f : out[x]);
    }
}

template <bool fresh> void mix_many(const Mixture& m, float* out)
{
    constexpr uint32_t step = 64;
    for (uint32_t begin = 0; begin < m.width; begin += step) {
        const uint32_t width = m.width - begin < step ? m.width - begin : step;
        float sum[step];
        for (uint32_t x = 0; x < width; ++x) sum[x] = m.mean;
        for (uint32_t c = 0; c < m.channels; ++c) {
            const float* f = m.f + size_t(c) * m.plane + begin;
            const float colour = m.colour[c];
            for (uint32_t x = 0; x < width; ++x) sum[x] = weft_madd(colour, f[x], sum[x]);
        }
        for (uint32_t x = begin; x < begin + width; ++x)
            out[x] = weft_madd(m.mask ? m.mask[x] : 1.0f, sum[x - begin], fresh ? 0.0f : out[x]);
    }
}

template <bool fresh> void mix_any(const Mixture& m, float* out)
{
    if (m.channels == 1)
        mix_few<1, fresh>(m, out);
    else if (m.channels == 3)
        mix_few<3, fresh>(m, out);
    else if (m.channels == 4)
        mix_few<4, fresh>(m, out);
    else
        mix_many<fresh>(m, out);
}

void mix(const Mixture& m, float* out)
{
    if (m.fresh)
        mix_any<true>(m, out);
    else
        mix_any<false>(m, out);
}

} // namespace

extern const Rows rows;
#if WEFT_LANES == 1
const Rows rows = {0,
                   0,
                   24,
                   0,
                   1,
                   scratch,
                   find_impacts,
                   splat_strip,
                   splat_point,
                   splat_surface,
                   refine,
                   spline_row,
                   spline_rows,
                   bands_spots,
                   compose,
                   expand,
                   lerp,
                   tone,
                   multiply,
                   mix};
#else
const Rows rows = {lanes - 1,   band_apron,  strip_height,  1,      spots,      scratch,     find_impacts,
                   splat_strip, splat_point, splat_surface, refine, spline_row, spline_rows, bands_spots,
                   compose,     expand,      lerp,          tone,   multiply,   mix};
#endif

} // namespace WEFT_ISA
} // namespace weft
