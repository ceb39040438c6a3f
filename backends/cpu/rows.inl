/// The row kernels, compiled once per instruction set. WEFT_ISA names the set and the namespace, WEFT_LANES the floats
/// of its vectors; 1 selects the plain loops of the reference. Each object has one symbol, the table: everything else
/// lies in an unnamed namespace, so that no function compiled for this set can be merged with that of another.
#include "../common/field.h"
#include "rows.h"
#include <float.h>
#if WEFT_LANES > 1 && defined(__x86_64__)
#include <immintrin.h>
#endif

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
#include "mix_plain.inl"
#include "splat_plain.inl"
#include "surface_plain.inl"
#else
#include "splat_block.inl"

#include "bands_gather.inl"
#include "bands_rows.inl"
#include "bands_solid.inl"
#include "splat_gather.inl"

#include "mix_lanes.inl"
#include "surface_gather.inl"

#include "compose_lanes.inl"

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

void multiply(const float* a, const float* b, uint32_t width, float* row)
{
    for (uint32_t x = 0; x < width; ++x) row[x] = a[x] * b[x];
}

} // namespace

extern const Rows rows;
#if WEFT_LANES == 1
const Rows rows = {
    0,      0,          24,          0,           scratch, find_impacts, splat_strip, splat_point, splat_surface,
    refine, spline_row, spline_rows, bands_spots, compose, expand,       lerp,        tone,        multiply,
    mix};
#else
const Rows rows = {lanes - 1,   band_apron,    strip_height, 1,          scratch,     find_impacts, splat_strip,
                   splat_point, splat_surface, refine,       spline_row, spline_rows, bands_spots,  compose,
                   expand,      lerp,          tone,         multiply,   mix};
#endif

} // namespace WEFT_ISA
} // namespace weft
