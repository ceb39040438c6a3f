/* BANDS, sample by sample: the coefficients that act on a sample, refined from band to band. A row's three are the
 * first lanes of a float4, whose last has no meaning. */

#pragma OPENCL FP_CONTRACT OFF

/* Sizes are often powers of two, and divisions slow. */
static weft_u32 lattice_index(weft_i64 cell, weft_u32 shift, weft_u32 size)
{
    if ((size & (size - 1)) == 0) return ((weft_u32)cell + shift) & (size - 1);
    return weft_band_index(cell, shift, size);
}

/* Of an axis: the finer coefficients are near * a + far * b, the middle one, near * b + far * c. */
typedef struct Parity {
    float near, far;
    weft_u32 odd;
} Parity;

static Parity parity_of(weft_i64 cell)
{
    Parity parity;
    parity.odd = (weft_u32)(cell & 1);
    parity.near = parity.odd ? 0.25f : 0.75f;
    parity.far = parity.odd ? 0.75f : 0.25f;
    return parity;
}

/* weft_refine_even and weft_refine_odd of three lines, `step` apart; two terms may be added in either order. */
static void refine_lines(float4* c, weft_u32 step, Parity parity)
{
    const float4 middle = 0.75f * c[step] + 0.25f * (parity.odd ? c[2 * step] : c[0]);
    c[0] = parity.near * c[0] + parity.far * c[step];
    c[2 * step] = parity.near * c[step] + parity.far * c[2 * step];
    c[step] = middle;
}

/* The same within a line. */
static float4 refine_lanes(float4 v, Parity parity)
{
    const float4 near = (float4)(parity.near, 0.25f, parity.near, 0.0f);
    const float4 far = (float4)(parity.far, 0.75f, parity.far, 0.0f);
    return near * (parity.odd ? v.xzyw : v.xxyw) + far * v.yyzw;
}

/* c = weight * lattice + c, of `slices` times three lines. */
static inline void add_lattice(global const LatticeLayout* lattice, global const float* coefficients, float weight,
                               Position cell, weft_u32 slices, float4* c)
{
    global const float* from = coefficients + (size_t)lattice->offset * 4 +
                               (size_t)lattice_index(cell.y, lattice->y, lattice->height) * lattice->row +
                               lattice_index(cell.x, lattice->x, lattice->width);
    if (slices > 1) from += (size_t)lattice_index(cell.z, lattice->z, lattice->depth) * lattice->slice;
#pragma unroll
    for (weft_u32 z = 0; z < slices; ++z)
#pragma unroll
        for (weft_u32 y = 0; y < 3; ++y)
            c[z * 3 + y] = weight * vload4(0, from + (size_t)z * lattice->slice + y * lattice->row) + c[z * 3 + y];
}

static inline void refine_all(Position cell, weft_u32 slices, float4* c)
{
    const Parity x = parity_of(cell.x), y = parity_of(cell.y), z = parity_of(cell.z);
    if (slices > 1)
#pragma unroll
        for (weft_u32 i = 0; i < 3; ++i) refine_lines(c + i, 3, z);
#pragma unroll
    for (weft_u32 i = 0; i < slices; ++i) refine_lines(c + i * 3, 1, y);
#pragma unroll
    for (weft_u32 i = 0; i < slices * 3; ++i) c[i] = refine_lanes(c[i], x);
}

static weft_quadratic spline_weights(weft_i64 pixel, weft_i32 fraction, weft_u32 level)
{
    return weft_quadratic_weights(weft_band_place(pixel, (weft_u32)fraction, level));
}

static float spline_lanes(weft_quadratic w, float4 c)
{
    return weft_quadratic_sum(w.w0, w.w1, w.w2, c.x, c.y, c.z);
}

/* f of one plane. `slices` is a constant: 1 in the plane, 3 in space. */
static inline float bands_at(global const LayerLayout* layer, global const LatticeLayout* lattices,
                             global const float* coefficients, Position at, weft_u32 plane, weft_u32 slices)
{
    const weft_between between = weft_level(at.level);
    const weft_u32 level = (weft_u32)between.whole;
    if (level >= layer->levels) return 0.0f;
    float4 c[9];
#pragma unroll
    for (weft_u32 i = 0; i < slices * 3; ++i) c[i] = 0.0f;
    for (weft_u32 band = layer->levels; band-- > level;) {
        global const LatticeLayout* lattice = lattices + layer->first_level + band * layer->planes + plane;
        Position cell = at;
        cell.x = weft_band_cell(at.x, band);
        cell.y = weft_band_cell(at.y, band);
        cell.z = weft_band_cell(at.z, band);
        if (band + 1 < layer->levels) refine_all(cell, slices, c);
        if (!lattice->present) continue;
        const float weight = band == level ? weft_band_weight(lattice->weight, between.t) : lattice->weight;
        add_lattice(lattice, coefficients, weight, cell, slices, c);
    }
    const weft_quadratic x = spline_weights(at.x, at.fraction_x, level), y = spline_weights(at.y, at.fraction_y, level);
    float line[3];
#pragma unroll
    for (weft_u32 i = 0; i < slices; ++i)
        line[i] = weft_quadratic_sum(y.w0, y.w1, y.w2, spline_lanes(x, c[3 * i]), spline_lanes(x, c[3 * i + 1]),
                                     spline_lanes(x, c[3 * i + 2]));
    if (slices == 1) return line[0];
    const weft_quadratic z = spline_weights(at.z, at.fraction_z, level);
    return weft_quadratic_sum(z.w0, z.w1, z.w2, line[0], line[1], line[2]);
}

#define LATTICE_GATHER(name, slices)                                                                                   \
    kernel __attribute__((reqd_work_group_size(64, 1, 1))) void name(                                                  \
        global const LayerLayout* layers, global const LatticeLayout* lattices, global const float* coefficients,      \
        global const SpotLayout* spots, global float* field, SamplesLayout samples, weft_u32 index)                    \
    {                                                                                                                  \
        const weft_u32 column = get_global_id(0), row = get_global_id(1), plane = get_global_id(2);                    \
        if (column >= samples.width) return;                                                                           \
        global const LayerLayout* layer = layers + index;                                                              \
        field[(size_t)(layer->plane_slot + plane) * samples.pitch + (size_t)row * samples.stride + column] =           \
            bands_at(layer, lattices, coefficients, position_of(samples, spots, column, row), plane, slices);          \
    }

LATTICE_GATHER(lattice_gather, 1)
LATTICE_GATHER(lattice_solid, 3)
