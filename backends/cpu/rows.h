/// The kernels of one instruction set, as a table, and what they are handed. Plain data: this header is also seen by
/// code that is compiled for instructions which the running CPU may lack.
#pragma once
#include <stddef.h>
#include <stdint.h>
#include <weft/backend.h>

namespace weft {

constexpr uint32_t most_bands = 24, most_spots = 8, most_planes = 40, most_results = 16, most_pieces = 64;

/// One level of textons, laid out for a table's kernels. Texels within `data` but outside width x height are zero.
struct Texels {
    const float* data;           ///< texel (0, 0) of the first plane of the first image
    int64_t row, plane, image;   ///< floats from one to the next
    int32_t width, height, x, y; ///< (x, y): index of the first texel
    int64_t reach;               ///< weft_surface_reach, for surfaces
};

/// A SPLAT layer, ready to be evaluated.
struct Splat {
    uint64_t key; ///< of its cells
    uint32_t period[3];
    uint32_t size[2]; ///< of the textons at level 0
    uint32_t cell_log2, count_limit, signs, taps, planes, levels;
    uint32_t usual_counts; ///< how many thresholds more than one cell in 256 reaches
    const uint32_t* counts;
    const float* offset;
    const Texels* texels;                                         ///< levels
    uint32_t (*choose)(const void* choice, int64_t x, int64_t y); ///< image of an impact at a pixel; null: image 0
    const void* choice;
};

/// A lattice of a BANDS layer. Rows and slices are `row` and `slice` floats apart.
struct Lattice {
    const float* data; ///< null: none
    int64_t row, slice;
    uint32_t size[3], shift[3]; ///< shifts are below the sizes
    float weight;
    bool powers; ///< all sizes are powers of two
};

/// A BANDS layer, ready to be evaluated.
struct Bands {
    uint32_t count, planes;  ///< no band from `count` on has a lattice
    const Lattice* lattices; ///< band b of plane p is lattices[b * planes + p]
};

/// The least and the greatest depth of a content's contour.
struct Contour_range {
    uint8_t least, most;
};

/// A TILE layer that is more than a picture that repeats, ready to be evaluated.
struct Composed {
    const weft_tile* tile;
    uint32_t planes;
    uint32_t cells[2];              ///< to a period; 0: endless
    uint64_t north, west, contents; ///< keys
    const Contour_range* ranges;    ///< of contents
    uint32_t groups;                ///< of eight planes
    const Texels* texels;           ///< levels; only for kernels that want copies
};

/// Where a TILE is looked at, along one axis: cells, texels and fractions, and what moves them, in pixels.
struct Axis_places {
    const int64_t* cell;
    const int32_t* texel;
    const float* fraction;
    uint32_t step;      ///< 1; 0: all in the same place, but for what moves them
    const float* moved; ///< null: nothing
};

/// `pairs` pairs of coefficients of a row of a band: those of the next coarser band's rows `above` and `below`,
/// refined, the first or (odd) second row between them, and a row of the lattice, from `first` on, again and again.
struct Refine {
    const float *above, *below; ///< null: there is no coarser band
    uint32_t odd, pairs;
    const float* lattice; ///< null: none
    uint32_t first, size;
    float weight;
};
constexpr uint32_t overrun = 32;

/// An impact, seen from pixel (0, 0) of a block: the texel under it is `column`, `row`, counted from the level's first.
/// That texel is data[origin]; the weights are for two taps.
struct Impact {
    int64_t origin;
    int32_t column, row;
    float w0, w1, rho;
    uint32_t zero;
};

/// Weights of an impact for 1, 4 or 6 taps; the sign is in x.
struct Spline {
    float x[6], y[6];
};

/// The impacts that reach a block, in canonical order. `splines` is filled unless there are two taps.
struct Impacts {
    Impact* impacts;
    Spline* splines;
    uint32_t count, capacity;
    bool (*grow)(Impacts& impacts); ///< doubles the capacity; false: no memory
};

/// A rectangle of a window's pixels, of level `level`.
struct Block {
    int64_t x, y;
    uint32_t width, height, level;
};

/// Rows first..first + count - 1 of a block of f, one plane after another.
struct Strip {
    float* data;
    uint32_t width, first, count;
    uint32_t stride;   ///< of rows; planes are stride * count apart
    void* scratch;     ///< Rows::scratch bytes, 64-byte aligned
    const float* mask; ///< null: none; where it is 0, f may be any finite number
};

/// Columns begin..end - 1 read the texels `first` on, in steps of one; scattered ones read where the pairs say.
struct Run {
    uint32_t begin, end;
    int32_t first;
    uint32_t scattered;
};

/// Which texels of a row the columns of a block read, and the weight of the second.
struct Columns {
    const int32_t* first;
    const int32_t* second;
    const float* t;
    const Run* runs;
    uint32_t run_count;
};

/// A tone curve as tables. After the last piece x is NaN, which no value reaches, and coefficients are 0.
struct alignas(64) Tone {
    float x[most_pieces], c[4][most_pieces];
    float low, high;
    uint32_t count;
};

/// What a layer adds to the result channels: out = mask * (sum of colour * f + mean) + out, where `fresh` means that
/// out is +0.
struct Mixture {
    bool fresh;
    uint32_t results, channels, width;
    const float* f; ///< channel c at f + c * plane
    size_t plane, result_plane;
    const float *colour, *mean; ///< results * channels; results
    const float* mask;          ///< null: 1
};

struct Rows {
    uint32_t apron; ///< zeros that kernels want right of every row of texels and left of the first; 0: none, no copy
    uint32_t apron_rows;   ///< ... above and below every image
    uint32_t strip_height; ///< rows of a strip, liked best
    uint32_t interleaved;  ///< 1: points want texels of four planes side by side, and lattices are padded

    /// Bytes of scratch that splat_strip needs for that many impacts.
    size_t (*scratch)(uint32_t impacts, uint32_t width, uint32_t taps);
    /// Finds all impacts that reach a block; false: no memory.
    bool (*find_impacts)(const Splat& splat, const Block& block, Impacts& found);
    void (*splat_strip)(const Splat& splat, uint32_t level, const Impacts& found, const Strip& strip);
    /// f of all planes at a spot, at a whole level below splat.levels.
    void (*splat_point)(const Splat& splat, uint32_t level, const weft_spot& spot, float* f);

    /// The same on a surface: `frame` is tangent, bitangent and normal.
    void (*splat_surface)(const Splat& splat, uint32_t level, const weft_spot& spot, const float* frame, float* f);

    /// These may read and write up to `overrun` floats more, but no more than a multiple of 16 of a row of pixels.
    void (*refine)(const Refine& refine, float* row);
    void (*spline_row)(const float* coefficients, size_t width, float* row);
    void (*spline_rows)(const float* upper, const float* middle, const float* lower, size_t width, float* row);
    /// f of all planes at spots in the plane (2 axes) or in space (3), those of plane p at f + p * pitch.
    void (*bands_spots)(const Bands& bands, uint32_t axes, const weft_spot* spots, uint32_t count, float* f,
                        size_t pitch);

    /// f of planes first..first + planes - 1 at `count` places of two axes, a plane `pitch` floats after the one
    /// before.
    void (*compose)(const Composed& tile, const Axis_places* places, uint32_t count, float level, uint32_t first,
                    uint32_t planes, float* f, size_t pitch);
    void (*expand)(const float* texels, const Columns& columns, float* row);
    /// row = t (b - a) + a, also where t is 0.
    void (*lerp)(const float* a, const float* b, float t, uint32_t width, float* row);
    void (*tone)(const Tone& tone, uint32_t width, float* row);
    void (*multiply)(const float* a, const float* b, uint32_t width, float* row);
    void (*mix)(const Mixture& mixture, float* out);
};

} // namespace weft
