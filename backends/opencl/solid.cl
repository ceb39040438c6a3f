/* BANDS in space, sample by sample: each band's 27 coefficients by themselves, the three columns in a float4 from the
 * first sum to the last. */

#pragma OPENCL FP_CONTRACT OFF

static float4 sum_lines(weft_quadratic w, float4 a, float4 b, float4 c) { return w.w0 * a + (w.w1 * b + w.w2 * c); }

/* The sum along z, then along y, of each column. */
static float4 sum_columns(global const LatticeLayout* lattice, global const float* from, weft_quadratic y,
                          weft_quadratic z)
{
    const size_t slice = lattice->slice;
    global const float* second = from + lattice->row;
    global const float* third = second + lattice->row;
    return sum_lines(y, sum_lines(z, vload4(0, from), vload4(0, from + slice), vload4(0, from + 2 * slice)),
                     sum_lines(z, vload4(0, second), vload4(0, second + slice), vload4(0, second + 2 * slice)),
                     sum_lines(z, vload4(0, third), vload4(0, third + slice), vload4(0, third + 2 * slice)));
}

/* f of one plane. */
static float solid_at(global const LayerLayout* layer, global const LatticeLayout* lattices,
                      global const float* coefficients, Position at, weft_u32 plane)
{
    const weft_between between = weft_level(at.level);
    float4 sum = 0.0f;
    for (weft_u32 band = layer->levels; band-- > (weft_u32)between.whole;) {
        global const LatticeLayout* lattice = lattices + layer->first_level + band * layer->planes + plane;
        if (!lattice->present) continue;
        const Position cell = cell_of(at, band);
        const weft_quadratic x = quadratic_at(at.x, at.fraction_x, band);
        const float4 v = sum_columns(lattice,
                                     coefficients_of(lattice, coefficients, cell) +
                                         lattice_index(cell.z, lattice->z, lattice->depth) * lattice->slice,
                                     quadratic_at(at.y, at.fraction_y, band), quadratic_at(at.z, at.fraction_z, band));
        sum = ((float4)(x.w0, x.w1, x.w2, 0.0f) * lattice_weight(lattice, band, between)) * v + sum;
    }
    return sum.x + (sum.y + sum.z);
}

kernel __attribute__((reqd_work_group_size(64, 1, 1))) void
lattice_solid(global const LayerLayout* layers, global const LatticeLayout* lattices,
              global const float* coefficients, global const SpotLayout* spots, global float* field,
              SamplesLayout samples, weft_u32 index)
{
    const weft_u32 column = get_global_id(0), row = get_global_id(1), plane = get_global_id(2);
    if (column >= samples.width) return;
    global const LayerLayout* layer = layers + index;
    const Position at = position_of(samples, spots, column, row);
    field[(size_t)(layer->plane_slot + plane) * samples.pitch + (size_t)row * samples.stride + column] =
        solid_at(layer, lattices, coefficients, at, plane);
}
