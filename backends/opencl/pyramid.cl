/* BANDS for windows on devices with few wide cores. A work-item makes a tile of pixels of one plane, from the coarsest
 * band's few coefficients to the finest band's many: each is made once, from those of the next coarser band, which the
 * other of two buffers holds. */

#pragma OPENCL FP_CONTRACT OFF

/* The coefficients of one band under a tile, along one axis. They are made in pairs: if `odd` is 1, the first one that
 * is needed is the second of a pair. */
typedef struct Span {
    weft_i64 first_pair;
    weft_u32 odd, pairs;
} Span;

static Span span_of(weft_i64 first, weft_u32 count)
{
    Span span;
    span.first_pair = first >> 1;
    span.odd = (weft_u32)(first & 1);
    span.pairs = (count + span.odd + 1) / 2;
    return span;
}

/* The span of the next coarser band. */
static Span coarser(Span span) { return span_of(span.first_pair, span.pairs + 1); }

/* Floats from one row to the next: pairs are made eight at once, and read a few more. */
#define WEFT_PAIRS_STRIDE(pairs) (((pairs) + 7) / 8 * 16 + 16)
#define WEFT_FINE_PAIRS(pixels) (((pixels) + 2) / 2 + 1)
#define WEFT_COARSE_PAIRS(pixels) ((WEFT_FINE_PAIRS(pixels) + 1) / 2 + 1)

#define WEFT_FINE_FLOATS                                                                                               \
    (WEFT_PAIRS_STRIDE(WEFT_FINE_PAIRS(WEFT_TILE_COLUMNS)) * 2 * WEFT_FINE_PAIRS(WEFT_TILE_ROWS))
#define WEFT_COARSE_FLOATS                                                                                             \
    (WEFT_PAIRS_STRIDE(WEFT_COARSE_PAIRS(WEFT_TILE_COLUMNS)) * 2 * WEFT_COARSE_PAIRS(WEFT_TILE_ROWS))

/* A lattice along a row: 16 coefficients from column k on, again and again. */
static inline weft_u32 lattice_on(weft_u32 k, weft_u32 size)
{
    k += 16;
    if (k < size) return k;
    return size >= 16 ? k - size : k % size;
}

static inline float16 in_turn(float8 even, float8 odd)
{
    return (float16)(even.s0, odd.s0, even.s1, odd.s1, even.s2, odd.s2, even.s3, odd.s3, even.s4, odd.s4, even.s5,
                     odd.s5, even.s6, odd.s6, even.s7, odd.s7);
}

static inline float16 refine_pairs(float8 a, float8 b)
{
    return in_turn(0.75f * a + 0.25f * b, 0.25f * a + 0.75f * b);
}

/* One band under a tile: where its rows are, from the first of a pair on. */
typedef struct Floor {
    Span x, y;
    float* data;
    weft_u32 stride;
} Floor;

static Floor floor_of(Span x, Span y, float* data)
{
    Floor made;
    made.x = x;
    made.y = y;
    made.data = data;
    made.stride = WEFT_PAIRS_STRIDE(x.pairs);
    return made;
}

/* Two rows of a band: what the two rows of the coarser band refine to. */
static inline void refine_rows(const float* above, const float* below, weft_u32 pairs, float* to, weft_u32 stride)
{
    for (weft_u32 i = 0; i < pairs; i += 8) {
        const float8 a0 = vload8(0, above + i), b0 = vload8(0, above + i + 1);
        const float8 a1 = vload8(0, below + i), b1 = vload8(0, below + i + 1);
        vstore16(refine_pairs(0.75f * a0 + 0.25f * a1, 0.75f * b0 + 0.25f * b1), 0, to + 2 * i);
        vstore16(refine_pairs(0.25f * a0 + 0.75f * a1, 0.25f * b0 + 0.75f * b1), 0, to + stride + 2 * i);
    }
}

static inline void add_lattice_row(global const float* from, weft_u32 first, weft_u32 size, float weight,
                                   weft_u32 pairs, float* to)
{
    for (weft_u32 i = 0, k = first; i < pairs; i += 8, k = lattice_on(k, size))
        vstore16(weight * vload16(0, from + k) + vload16(0, to + 2 * i), 0, to + 2 * i);
}

static void make_floor(Floor fine, Floor coarse, global const LatticeLayout* lattice,
                       global const float* coefficients)
{
    const weft_u32 width = lattice->width, height = lattice->height;
    global const float* from = coefficients + (size_t)lattice->offset * 4;
    weft_u32 column = 0, line = 0;
    if (lattice->present) {
        column = lattice_index(2 * fine.x.first_pair, lattice->x, width);
        line = lattice_index(2 * fine.y.first_pair, lattice->y, height);
    }
    const float* above = coarse.data + coarse.y.odd * coarse.stride + coarse.x.odd;
    float* to = fine.data;
    for (weft_u32 pair = 0; pair < fine.y.pairs; ++pair, above += coarse.stride) {
        refine_rows(above, above + coarse.stride, fine.x.pairs, to, fine.stride);
        for (weft_u32 i = 0; i < 2; ++i, to += fine.stride) {
            vstore16(0.0f, 0, to + fine.stride - 16);
            if (!lattice->present) continue;
            add_lattice_row(from + (size_t)line * lattice->row, column, width, lattice->weight, fine.x.pairs, to);
            line = line + 1 < height ? line + 1 : 0;
        }
    }
}

static inline float16 spline16(float16 a, float16 b, float16 c) { return 0.125f * a + (0.75f * b + 0.125f * c); }

static inline float16 spline_row16(const float* c)
{
    return spline16(vload16(0, c), vload16(0, c + 1), vload16(0, c + 2));
}

/* At the centres of pixels, where the spline's weights are 1/8, 3/4, 1/8. */
static void spline_tile(Floor finest, weft_u32 width, weft_u32 height, global float* to, weft_u32 stride)
{
    const float* first = finest.data + finest.y.odd * finest.stride + finest.x.odd;
    for (weft_u32 x = 0; x < width; x += 16) {
        const float* c = first + x;
        float16 upper = spline_row16(c), middle = spline_row16(c + finest.stride);
        c += 2 * finest.stride;
        for (weft_u32 y = 0; y < height; ++y, c += finest.stride) {
            const float16 lower = spline_row16(c);
            vstore16(spline16(upper, middle, lower), 0, to + (size_t)y * stride + x);
            upper = middle;
            middle = lower;
        }
    }
}

/* All coefficients of the finest band, from level samples.level on, under the tile. */
static Floor finest_of(global const LayerLayout* layer, global const LatticeLayout* lattices,
                       global const float* coefficients, weft_u32 level, weft_u32 plane, Span* x, Span* y, float* fine,
                       float* coarse)
{
    const weft_u32 count = layer->levels - level;
    Floor made = floor_of(x[count], y[count], count & 1 ? coarse : fine);
    for (weft_u32 i = 0; i < 2 * made.y.pairs * made.stride; ++i) made.data[i] = 0.0f;
    for (weft_u32 b = count; b-- > 0;) {
        const Floor next = floor_of(x[b], y[b], b & 1 ? coarse : fine);
        make_floor(next, made, lattices + layer->first_level + (level + b) * layer->planes + plane, coefficients);
        made = next;
    }
    return made;
}

kernel __attribute__((reqd_work_group_size(1, 1, 1))) void
lattice_pyramid(global const LayerLayout* layers, global const LatticeLayout* lattices,
                global const float* coefficients, global float* field, SamplesLayout samples, weft_u32 index)
{
    float fine[WEFT_FINE_FLOATS], coarse[WEFT_COARSE_FLOATS];
    Span spans_x[WEFT_MOST_BANDS + 1], spans_y[WEFT_MOST_BANDS + 1];
    global const LayerLayout* layer = layers + index;
    const weft_u32 left = get_global_id(0) * WEFT_TILE_COLUMNS, top = get_global_id(1) * WEFT_TILE_ROWS;
    const weft_u32 plane = get_global_id(2);
    const weft_u32 width = min(samples.width - left, (weft_u32)WEFT_TILE_COLUMNS);
    const weft_u32 height = min(samples.height - top, (weft_u32)WEFT_TILE_ROWS);
    global float* to =
        field + (size_t)(layer->plane_slot + plane) * samples.pitch + (size_t)top * samples.stride + left;
    if (samples.level >= layer->levels) {
        for (weft_u32 y = 0; y < height; ++y)
            for (weft_u32 x = 0; x < width; x += 16) vstore16(0.0f, 0, to + (size_t)y * samples.stride + x);
        return;
    }
    spans_x[0] = span_of(samples.x + left, width + 2);
    spans_y[0] = span_of(samples.y + top, height + 2);
    for (weft_u32 b = 0; b < layer->levels - samples.level; ++b) {
        spans_x[b + 1] = coarser(spans_x[b]);
        spans_y[b + 1] = coarser(spans_y[b]);
    }
    const Floor finest =
        finest_of(layer, lattices, coefficients, samples.level, plane, spans_x, spans_y, fine, coarse);
    spline_tile(finest, width, height, to, samples.stride);
}
