/* BANDS in the plane, sample by sample: the nine coefficients that act on a sample, refined from band to band. A row's
 * three are the first lanes of a float4, whose last has no meaning. */

#pragma OPENCL FP_CONTRACT OFF

/* Sizes are often powers of two, and divisions slow. */
static weft_u32 lattice_index(weft_i64 cell, weft_u32 shift, weft_u32 size)
{
    if ((size & (size - 1)) == 0) return ((weft_u32)cell + shift) & (size - 1);
    return weft_band_index(cell, shift, size);
}

/* Of an axis: the finer coefficients are near * a + far * b, the middle one, near * b + far * c. The middle one is
 * 3/4 b and 1/4 of c where `odd` is -1, else of a: without branches, which no processor could foretell. */
typedef struct Parity {
    float near, far;
    int4 odd;
} Parity;

static inline Parity parity_of(weft_i64 cell)
{
    const weft_i32 bit = (weft_i32)(cell & 1);
    Parity parity;
    parity.near = 0.75f - 0.5f * (float)bit;
    parity.far = 0.25f + 0.5f * (float)bit;
    parity.odd = -bit;
    return parity;
}

typedef struct Nine {
    float4 a, b, c;
} Nine;

/* weft_refine_even and weft_refine_odd of three rows; two terms may be added in either order. */
static inline Nine refine_lines(Nine n, Parity parity)
{
    Nine to;
    to.a = parity.near * n.a + parity.far * n.b;
    to.b = 0.75f * n.b + 0.25f * select(n.a, n.c, parity.odd);
    to.c = parity.near * n.b + parity.far * n.c;
    return to;
}

/* The same within a row. */
static inline float4 refine_lanes(float4 v, Parity parity)
{
    const float4 near = (float4)(parity.near, 0.25f, parity.near, 0.0f);
    const float4 far = (float4)(parity.far, 0.75f, parity.far, 0.0f);
    return near * select(v.xxyw, v.xzyw, parity.odd) + far * v.yyzw;
}

/* The cell of a band that a sample lies in. */
static Position cell_of(Position at, weft_u32 band)
{
    at.x = weft_band_cell(at.x, band);
    at.y = weft_band_cell(at.y, band);
    at.z = weft_band_cell(at.z, band);
    return at;
}

/* The first coefficient of a cell's first slice. */
static global const float* coefficients_of(global const LatticeLayout* lattice, global const float* coefficients,
                                           Position cell)
{
    return coefficients + (size_t)lattice->offset * 4 +
           (size_t)lattice_index(cell.y, lattice->y, lattice->height) * lattice->row +
           lattice_index(cell.x, lattice->x, lattice->width);
}

static float lattice_weight(global const LatticeLayout* lattice, weft_u32 band, weft_between between)
{
    return band == (weft_u32)between.whole ? weft_band_weight(lattice->weight, between.t) : lattice->weight;
}

static weft_quadratic quadratic_at(weft_i64 pixel, weft_i32 fraction, weft_u32 band)
{
    return weft_quadratic_weights(weft_band_place(pixel, (weft_u32)fraction, band));
}

static float sum_lanes(weft_quadratic w, float4 c) { return weft_quadratic_sum(w.w0, w.w1, w.w2, c.x, c.y, c.z); }

/* f of one plane. */
static float bands_at(global const LayerLayout* layer, global const LatticeLayout* lattices,
                      global const float* coefficients, Position at, weft_u32 plane)
{
    const weft_between between = weft_level(at.level);
    const weft_u32 level = (weft_u32)between.whole;
    if (level >= layer->levels) return 0.0f;
    Nine n = {0.0f, 0.0f, 0.0f};
    for (weft_u32 band = layer->levels; band-- > level;) {
        global const LatticeLayout* lattice = lattices + layer->first_level + band * layer->planes + plane;
        const Position cell = cell_of(at, band);
        const Parity x = parity_of(cell.x);
        n = refine_lines(n, parity_of(cell.y));
        n.a = refine_lanes(n.a, x);
        n.b = refine_lanes(n.b, x);
        n.c = refine_lanes(n.c, x);
        if (!lattice->present) continue;
        global const float* from = coefficients_of(lattice, coefficients, cell);
        const float weight = lattice_weight(lattice, band, between);
        n.a = weight * vload4(0, from) + n.a;
        n.b = weight * vload4(0, from + lattice->row) + n.b;
        n.c = weight * vload4(0, from + 2 * lattice->row) + n.c;
    }
    const weft_quadratic x = quadratic_at(at.x, at.fraction_x, level), y = quadratic_at(at.y, at.fraction_y, level);
    return weft_quadratic_sum(y.w0, y.w1, y.w2, sum_lanes(x, n.a), sum_lanes(x, n.b), sum_lanes(x, n.c));
}

kernel __attribute__((reqd_work_group_size(64, 1, 1))) void
lattice_gather(global const LayerLayout* layers, global const LatticeLayout* lattices,
               global const float* coefficients, global const SpotLayout* spots, global float* field,
               SamplesLayout samples, weft_u32 index)
{
    const weft_u32 column = get_global_id(0), row = get_global_id(1), plane = get_global_id(2);
    if (column >= samples.width) return;
    global const LayerLayout* layer = layers + index;
    const Position at = position_of(samples, spots, column, row);
    field[(size_t)(layer->plane_slot + plane) * samples.pitch + (size_t)row * samples.stride + column] =
        bands_at(layer, lattices, coefficients, at, plane);
}
