/* What the host hands to the kernels, in the common subset of C++17 and OpenCL C 1.2: structs of naturally aligned
 * words. */
#ifndef WEFT_OPENCL_LAYOUT_H
#define WEFT_OPENCL_LAYOUT_H

#include "common/field.h"

#define WEFT_NONE 0xffffffffu

/* A block of splat_bands: as many columns as a vector holds, and as many rows as let the sums of a number of taps stay
 * in 16 registers, beside weights and texels. */
#define WEFT_BLOCK_COLUMNS 8
#define WEFT_BLOCK_ROWS(taps) ((taps) == 1 ? 8 : (taps) == 2 ? 4 : (taps) == 4 ? 2 : 1)

/* Words of an impact in a band's list: the texel column under the window's first pixel; where the framed row of its
 * image's texels under the band's first row begins; then floats: of two taps w0, w1, rho, else x's weights times the
 * sign, y's weights. */
#define WEFT_IMPACT_WORDS(taps) ((taps) == 2 ? 5 : 2 + 2 * (taps))

#define WEFT_SAMPLES 16 /* that layer_sum finishes at once: the field's stride is a multiple of it */

/* How a layer's plane is computed. */
#define WEFT_SPLAT_GATHER 1 /* sample by sample */
#define WEFT_SPLAT_BANDS 2  /* windows only: block by block, from lists of impacts that the host made */
#define WEFT_TILE_GATHER 3
#define WEFT_SURFACE_GATHER 4
#define WEFT_LATTICE_GATHER 5  /* sample by sample, in the plane */
#define WEFT_LATTICE_SOLID 6   /* sample by sample, in space */
#define WEFT_LATTICE_PYRAMID 7 /* windows only: tile by tile */
#define WEFT_TILE_COMPOSED 8   /* Wang tiles, exchange or displacement */

/* A tile of lattice_pyramid, in pixels: what it computes stays in the first cache. */
#define WEFT_TILE_COLUMNS 128
#define WEFT_TILE_ROWS 30
#define WEFT_MOST_BANDS 24

/* One level of a mip chain. Gathered texels are float4: (image, group of four planes, row, column), framed by taps - 1
 * zeros if splatted; those of splat_bands are float: (plane, row, column), with a block's width of zeros between rows
 * and what a block and its taps may reach above and below. */
typedef struct LevelLayout {
    weft_i64 reach;      /* SURFACE: impacts this many pixels away on any axis reach a sample */
    weft_u32 offset;     /* of the first texel in the texels' buffer, in units of 4 floats */
    weft_u32 stride;     /* texels from one row to the next */
    weft_u32 plane_step; /* from one group (bands: plane) to the next */
    weft_u32 image_step;
    weft_u32 width, height;     /* without the frame */
    weft_u32 frame_x, frame_y;  /* texels before the first */
    weft_i32 x, y;              /* SPLAT: index of the first texel without the frame */
    weft_i32 before_x, after_x; /* SPLAT: impacts this many pixels before or after a sample reach it */
    weft_i32 before_y, after_y;
    float scale_x, scale_y; /* TILE */
} LevelLayout;

/* The lattice of one band and plane of BANDS: floats, framed behind by the first coefficients again, as many as are
 * read at once. */
typedef struct LatticeLayout {
    weft_u64 slice;   /* coefficients from one slice to the next */
    weft_u32 offset;  /* of the first coefficient in the texels' buffer, in units of 4 floats */
    weft_u32 present; /* 0: none */
    weft_u32 row;     /* from one row to the next */
    weft_u32 width, height, depth;
    weft_u32 x, y, z; /* shifts, below the sizes */
    float weight;
} LatticeLayout;

/* One axis of a TILE. */
typedef struct GridLayout {
    weft_u32 span, cells, size;
    float inverse, step;
} GridLayout;

#define WEFT_PATCH_WORDS 4   /* anchor x, y, first content, count */
#define WEFT_CONTENT_WORDS 8 /* until, x, y; then floats: turn's four, level */

/* A TILE that is more than a picture that repeats. Its bytes lie in words. */
typedef struct ComposedLayout {
    weft_u64 north, west, contents_key;
    weft_u32 cells_x, cells_y;         /* to a period; 0: endless */
    weft_u32 moved_layer, moved_plane; /* displacement; layer WEFT_NONE: none */
    weft_u32 colours;                  /* 0: no Wang tiles */
    weft_u32 knots;
    float unit_x, unit_y;
    weft_u32 diamonds;               /* where in words: x, y of each */
    weft_u32 contours;               /* where in words: signed bytes */
    weft_u32 sharp;                  /* where in numbers */
    weft_u32 exchange;               /* 0: none */
    weft_u32 map, patches, contents; /* where in words */
    weft_u32 content_contours;       /* where in words: bytes */
    weft_u32 feather;                /* where in numbers */
    weft_u32 zero;
} ComposedLayout;

typedef struct LayerLayout {
    weft_u64 key;  /* SPLAT: weft_key(seed, stream, WEFT_TAG_IMPACTS) */
    weft_u32 form; /* WEFT_SPLAT_GATHER, ... */
    weft_u32 planes, channels;
    weft_u32 colours;             /* channels of the program */
    weft_u32 first_level, levels; /* BANDS: first lattice, which has `planes` for each band; bands */
    weft_u32 period_x, period_y, period_z;
    weft_u32 taps, cell_log2, count_limit, signs, images;
    weft_u32 counts;                      /* where in words */
    weft_u32 offset;                      /* where in numbers, four by four */
    weft_u32 choice_layer, choice_plane;  /* layer WEFT_NONE: none */
    weft_u32 texton_width, texton_height; /* SPLAT, level 0 */
    GridLayout grid_x, grid_y;
    float level;                     /* TILE: added */
    weft_u32 mask_layer, mask_plane; /* layer WEFT_NONE: none */
    weft_u32 mask_slot;    /* plane of the field where later layers find this layer's mask; WEFT_NONE: nobody asks */
    weft_u32 plane_slot;   /* first plane of the field that is this layer's */
    weft_u32 kept;         /* 1: later layers ask for its planes */
    weft_u32 tones;        /* where in words: pieces' count and where in numbers, per channel; WEFT_NONE: none */
    weft_u32 colour, mean; /* where in numbers */
    weft_u32 zero;
    ComposedLayout composed;
} LayerLayout;

/* Where samples are: spots, or the pixels of a window. */
typedef struct SamplesLayout {
    weft_i64 x, y;
    weft_u32 level;
    weft_u32 spots; /* 1: of the buffer of spots, with frames on surfaces */
    weft_u32 width; /* samples of a row, of which there are height */
    weft_u32 height;
    weft_u32 stride; /* of the field, a multiple of WEFT_SAMPLES */
    weft_u32 pitch;  /* of the field: from one plane to the next */
    weft_u32 span;   /* samples that a work-item of layer_sum finishes, a multiple of WEFT_SAMPLES */
} SamplesLayout;

/* Where the result goes: floats from one sample, row, channel to the next. */
typedef struct ResultLayout {
    weft_u32 sample, row;
    weft_u64 channel;
} ResultLayout;

/* weft_spot. */
typedef struct SpotLayout {
    weft_i64 cell[3];
    weft_u32 fraction[3];
    float level;
} SpotLayout;

/* The sums that splat_bands leaves: (plane, accumulator, row, column). */
typedef struct SumsLayout {
    weft_u32 stride;
    weft_u32 step;    /* from one accumulator to the next */
    weft_u32 blocks;  /* of a row */
    weft_u32 segment; /* blocks of one work-item */
    weft_u32 level;   /* of the window */
    weft_u32 index;   /* of that level in the list of levels */
    weft_i32 jitter;  /* by how many columns the order of impacts may deviate from that of their columns */
} SumsLayout;

#endif
