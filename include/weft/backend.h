/* The plug-in ABI of libweft.
 *
 * A backend is a shared object, weft_backend_<name>.so, that exports one constant,
 *
 *     WEFT_BACKEND_EXPORT const weft_backend weft_backend_v0 = { WEFT_BACKEND_HEAD("opencl"), device_count, ... };
 *
 * Data, not a function: libweft reads and judges it before any code of the plug-in is called (but a shared object's
 * constructors run when it is loaded: loading a plug-in is trusting it). A plug-in does not link to libweft.
 *
 * A backend evaluates programs: models reduced to a few kinds of layers. It knows nothing of photos, analysis, files,
 * threads, progress, cancellation, pixel formats or footprints. libweft cuts an image into windows and calls
 * texture_render for each; it turns shading points into spots (a position and a level) and calls texture_sample.
 *
 * To write one
 *   1. device_count, device_info: what is there. Never fail.
 *   2. texture_open: `if (!weft_understands_program(program)) return WEFT_ERROR_UNSUPPORTED;`, refuse whatever else the
 *      device lacks in the same way, then prepare (copy, pad, upload). libweft falls back to "scalar": same pixels.
 *   3. texture_render or texture_sample: evaluate the layers in order, by the formulas of PROGRAMS.md. Start from the
 *      gathering form, which is one function per layer kind; field.h has every formula in the common subset of C99,
 *      C++17 and OpenCL C.
 *   4. Say `exact` only if every bit equals "scalar"; the test `exact` checks it with random programs.
 *
 * Compatibility  The number in the symbol is the major version; a break makes a weft_backend_v1. Within a major version
 *                the table and every struct that begins with `size` grow only at their end, and absent means zero.
 *                Structs marked frozen, which are elements of arrays, never change. A plug-in meets
 *                  - longer structs from a newer libweft: it refuses them unless the tail is zero (weft_understands);
 *                  - shorter structs from an older libweft: it reads a field of a later minor version only if
 *                    WEFT_HAS says so, and calls a host function of minor version m only if host->minor >= m.
 *                A layer kind, address or use that it does not know is answered WEFT_ERROR_UNSUPPORTED by texture_open.
 * Contract       Nothing throws, nothing aborts. texture_render and texture_sample may be called from `concurrency`
 *                threads at once on one texture; everything else comes one call at a time per device. The float
 *                environment of the caller is round-to-nearest without flush-to-zero. Pointers handed in are borrowed
 *                for the call, except `weft_host`, which lives as long as the device, and the program with all that it
 *                points to, which is constant and lives as long as the texture. Plug-ins are never unloaded.
 *                libweft has checked every program: indices, counts and sizes keep the bounds given here, every float
 *                is finite. Outputs are unspecified after an error.
 */
#ifndef WEFT_BACKEND_H
#define WEFT_BACKEND_H

#include <weft/weft.h>

#if defined(_WIN32)
#  define WEFT_BACKEND_VISIBLE __declspec(dllexport)
#else
#  define WEFT_BACKEND_VISIBLE __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
#  define WEFT_BACKEND_EXPORT extern "C" WEFT_BACKEND_VISIBLE
extern "C" {
#else
#  define WEFT_BACKEND_EXPORT WEFT_BACKEND_VISIBLE
#endif

#define WEFT_BACKEND_MAGIC UINT32_C(0x54464557) /* "WEFT", read as little-endian */
#define WEFT_BACKEND_MAJOR 0 /* 0: no promise yet; 1 is declared once all four methods run on all backends */
#define WEFT_BACKEND_MINOR 1

/* What a plug-in may ask of libweft. */
typedef struct weft_host {
  uint32_t size;
  uint32_t minor; /* WEFT_BACKEND_MINOR of the running libweft */
  void *self;
  void *(*allocate)(void *self, size_t size, size_t alignment) WEFT_NOEXCEPT; /* NULL: answer WEFT_ERROR_MEMORY */
  void (*deallocate)(void *self, void *memory, size_t size, size_t alignment) WEFT_NOEXCEPT;
  void (*error)(void *self, const char *sentence) WEFT_NOEXCEPT; /* explains the status about to be returned */
} weft_host;

/* Programs ----------------------------------------------------------------------------------------------------
 *
 *     out(x) = sum over layers of  mask(x) * ( colour * tone(f(x)) + mean )
 *
 * f is what the layer's kind computes: `planes` numbers. The first `channels` of them go through tone curve and colour
 * matrix into the result; all of them may be referred to by later layers, as mask, as displacement, as choice.
 */

/* Plane `plane` of layer `layer`, after its tone curve, at the same x; always of an earlier layer. Frozen. */
typedef struct weft_ref {
  int32_t  layer; /* -1: none */
  uint32_t plane;
} weft_ref;

/* One level of a mip chain. Frozen. */
typedef struct weft_mip {
  const float *data;      /* images * planes * height * width */
  uint32_t width, height;
  int32_t  x, y;          /* SPLAT: index of the first texel, -4..4; TILE: 0 */
  float    scale_x, scale_y; /* TILE: width and height over those of level 0 */
} weft_mip;

/* `images` pictures of `planes` planes each, with their mip chain: level l is for pixels of 2^l texels a side. */
typedef struct weft_mips {
  uint32_t size;
  uint32_t width, height;  /* of level 0: 1..16384 */
  uint32_t planes, images; /* 1..64, 1..255; TILE: 1 image */
  uint32_t levels;         /* 1..15 */
  const weft_mip *level;
} weft_mips;

/* SPLAT: sparse convolution. At each point of a Poisson process a texton is added, interpolated by B-splines. */
typedef struct weft_splat {
  uint32_t size;
  uint32_t taps;          /* of the interpolation per axis: 1 nearest, 2 linear, 4 cubic, 6 quintic */
  uint32_t cell_log2;     /* a Poisson cell has 2^cell_log2 pixels a side: 0..15 */
  uint32_t count_limit;   /* most impacts in one cell: 1..255 */
  const uint32_t *counts; /* count_limit thresholds, ascending: a cell has as many impacts as its hash reaches of them */
  uint32_t signs;         /* 1: each impact has a random sign */
  weft_ref choice;        /* TILE without displacement: image floor(value * images) for an impact, at its texton's middle */
  uint32_t zero;
  const weft_mips *textons; /* 0 outside */
  const float *offset;    /* planes: added to the sum, never -0; beyond the last level f is 0 */
} weft_splat;

/* One band of one plane: a toroidal lattice of quadratic B-spline coefficients, 2^b pixels apart. Frozen. */
typedef struct weft_band {
  const float *lattice;          /* depth * height * width; NULL if weight is 0 */
  uint32_t width, height, depth; /* depth is 1 but for WEFT_USE_SOLID */
  uint32_t x, y, z;              /* added to the lattice index before it is reduced; below 2^31 */
  float    weight;
  uint32_t zero;
} weft_band;

/* BANDS: octaves of noise. Each band's coefficients are refined to the next finer lattice and added to its own. */
typedef struct weft_bands {
  uint32_t size;
  uint32_t count;         /* 1..24; band b has cells of 2^b pixels, knots at multiples of 2^b */
  const weft_band *bands; /* count * planes: band b of plane p is bands[b * planes + p] */
} weft_bands;

/* How an axis is cut into cells: `cells` of them on `span` pixels. With a period, span is the period and cell numbers
 * are reduced modulo `cells`; without, cells is 1. A cell has the same texels whatever its size in pixels. Frozen. */
typedef struct weft_grid {
  uint32_t span, cells;
  float inverse; /* 1 / span */
  float step;    /* texels per pixel: cells * size of the cell in texels / span; exactly 1 when they are equal */
} weft_grid;

/* How a TILE finds the part of its source that belongs to a position. Every way yields one view or two blended ones. */
typedef int32_t weft_address;
enum {
  WEFT_ADDRESS_CELLS = 0, /* a cell is the whole source, again and again: one view */
  WEFT_ADDRESS_WANG  = 1  /* a cell is composed of the diamonds of its four edges; later: triangles, hexagons, oblique lattices */
};

/* Where a view lies in the source: the texel at the upper left corner of its rectangle. Frozen. */
typedef struct weft_diamond {
  int32_t x, y; /* 0..size of the source - 1 */
} weft_diamond;

/* WEFT_ADDRESS_WANG. Each edge of a cell has a hashed colour, and each colour of north and of west edges a view of the
 * source, as large as a cell and centred on the edge. A quarter of a cell shows two of them, that of its north or south
 * edge on one side of a contour from the cell's corner to its centre, that of its west or east edge on the other side.
 * The contour is a depth across the straight line from corner to centre, at knots along it. */
typedef struct weft_wang {
  uint32_t size;
  uint32_t colours;             /* n, of either direction: 2..16 */
  uint32_t knots;               /* intervals from corner to centre: 2..254 */
  float    unit_x, unit_y;      /* knots / width, knots / height of the cell */
  uint32_t zero;
  const weft_diamond *diamonds; /* 2n: those of north edges, then those of west edges */
  const int8_t *contours;       /* (((2 * south + east) * n + north's colour) * n + west's colour) * (knots + 1): depths, */
                                /* in intervals; |depth| < distance to the nearer end, and 0 there */
  const float  *sharp;          /* levels of the source * (knots + 1): 1 / width of the feather; above 0, at most 16 */
} weft_wang;

/* A region of a view whose content is exchanged as a whole. Frozen. */
typedef struct weft_patch {
  int32_t  x, y;         /* its anchor, a texel corner, in the cell's texels */
  uint32_t first, count; /* of its contents: 1..64 */
} weft_patch;

/* What a patch may show: the source at (x, y) + turn * (position - anchor). Frozen. */
typedef struct weft_content {
  uint32_t until;   /* taken if the patch's hash is below; ascending; the last content of a patch takes the rest */
  int32_t  x, y;    /* texel corner of the source under the anchor: 0..size - 1 */
  float    turn[4]; /* rows of a 2x2 matrix: rotation / scale */
  float    level;   /* added to the level: log2(1 / scale), 0..1 */
} weft_content;

/* An entry of weft_exchange.map: number of the patch, depth, two bits. */
#define WEFT_MAP_PATCH UINT32_C(0x003fffff)
#define WEFT_MAP_DEPTH 22                   /* shift: distance to the patch's border, 0..191 eighths of a texel; 0 on every */
                                            /* texel that touches another patch or, in diamonds, the view's border */
#define WEFT_MAP_LEFT  UINT32_C(0x40000000) /* the patch began in the cell to the left; not in diamonds */
#define WEFT_MAP_ABOVE UINT32_C(0x80000000) /* ... above */

#define WEFT_CONTOUR 96 /* depths of a content's contour, 24 on each side of a square around the anchor, from (1, -1) by (1, 1) */

/* Content exchange, over any address. */
typedef struct weft_exchange {
  uint32_t size;
  uint32_t patch_count;         /* 1..2^22 - 1 */
  const uint32_t *map;          /* views * height * width of the cell; CELLS has one view, WANG 2n */
  const weft_patch *patches;
  const weft_content *contents;
  const uint8_t *contours;      /* WEFT_CONTOUR per content: eighths of a texel; shown where deeper */
  const float   *feather;       /* levels of the source: 1 / width of the feather, in eighths of a texel; above 0, at most 1 */
} weft_exchange;

/* TILE: look-up in a picture. */
typedef struct weft_tile {
  uint32_t size;
  weft_address address;
  uint32_t width, height;        /* of a cell, in texels. CELLS: the source's. WANG: even, 4 or more, not above the source's */
  weft_grid x, y;
  weft_ref displacement;         /* planes `plane` and `plane` + 1: pixels added to x and y before the look-up */
  float    level;                /* added to the level: log2 of texels per pixel */
  uint32_t zero;
  const weft_mips *source;       /* read as a torus; 1 image, the layer's planes */
  const weft_wang *wang;         /* WANG; else NULL */
  const weft_exchange *exchange; /* NULL: none */
} weft_tile;

/* One piece of a tone curve: c0 + d*(c1 + d*(c2 + d*c3)), d = v - x, for v >= x up to the next piece. Frozen. */
typedef struct weft_piece {
  float x, c0, c1, c2, c3;
} weft_piece;

/* A channel's tone curve: v is clamped to [low, high] first. Frozen. */
typedef struct weft_tone {
  float    low, high;
  uint32_t count; /* 1..64 */
  uint32_t zero;
  const weft_piece *pieces; /* x ascending, pieces[0].x <= low */
} weft_tone;

typedef int32_t weft_layer_kind;
enum { WEFT_LAYER_SPLAT = 1, WEFT_LAYER_BANDS = 2, WEFT_LAYER_TILE = 3 };

typedef struct weft_layer {
  uint32_t        size;
  weft_layer_kind kind;
  uint32_t        stream;   /* SPLATs with equal streams have equal cells and counts, and thus the same impacts */
  uint32_t        planes;   /* 1..40 */
  uint32_t        channels; /* 0..planes, 0..16: of the planes, those that are coloured; 0: only referred to */
  weft_ref        mask;     /* multiplies this layer, together with the mask of the layer it belongs to */
  uint32_t        zero;
  const weft_tone *tones;   /* channels, or NULL */
  const float    *colour;   /* program's channels * channels, row by row */
  const float    *mean;     /* program's channels */
  const weft_splat *splat;  /* one of these, after the kind; the others are NULL */
  const weft_bands *bands;
  const weft_tile  *tile;
} weft_layer;

/* A texture is opened for one use, so that a backend prepares what that use needs, and can refuse it beforehand. */
typedef int32_t weft_use;
enum {
  WEFT_USE_WINDOW  = 1, /* texture_render */
  WEFT_USE_POINTS  = 2, /* texture_sample, spots in the plane; bit for bit the window's pixels at their centres */
  WEFT_USE_SURFACE = 3, /* texture_sample, spots in space with frames; SPLAT only */
  WEFT_USE_SOLID   = 4  /* texture_sample, spots in space; BANDS only */
};

typedef struct weft_program {
  uint32_t size;
  weft_use use;
  uint32_t channels;    /* of the result: 1..16 */
  uint32_t layer_count; /* 1..32 */
  uint64_t seed;
  uint32_t period[3];   /* pixels, 0: endless */
  uint32_t zero;
  const weft_layer *const *layers;
} weft_program;

/* Evaluation -------------------------------------------------------------------------------------------------- */

/* A window of the result: planar float, one plane after another. Pixel (i, j) is the sample at level `level` and
 * position ((x + i + 0.5) * 2^level, (y + j + 0.5) * 2^level), which is less than 2^61 away from 0. */
typedef struct weft_window {
  uint32_t size;
  uint32_t width, height;
  uint32_t stride; /* floats from one row to the next; at least width, a multiple of 16 */
  int64_t  x, y;
  uint32_t level;  /* 0..30 */
  uint32_t zero;
  float   *data;   /* channels * height * stride, 64-byte aligned */
} weft_window;

/* A position and a level: the texture prefiltered for pixels of 2^level. Frozen. */
typedef struct weft_spot {
  int64_t  cell[3];     /* pixel; [2] is 0 in the plane */
  uint32_t fraction[3]; /* position in it: 0..2^24 - 1 of 2^24 */
  float    level;       /* 0..30; whole numbers are the windows' levels */
} weft_spot;

typedef struct weft_batch {
  uint32_t size;
  uint32_t count;
  const weft_spot *spots;
  const float *frames; /* WEFT_USE_SURFACE: count * 9, tangent, bitangent and normal; else NULL */
  float *out;          /* count * channels */
} weft_batch;

/* The table --------------------------------------------------------------------------------------------------- */

typedef struct weft_backend_device  weft_backend_device;
typedef struct weft_backend_texture weft_backend_texture;

typedef struct weft_device_limits {
  uint32_t size;
  uint32_t concurrency;                 /* calls at once; 0: any number */
  uint32_t window_width, window_height; /* liked best; 0: no wish. Also the step of cancellation: at most some 20 ms */
  uint32_t batch;                       /* spots liked best; 0: no wish */
} weft_device_limits;

typedef struct weft_backend {
  uint32_t    magic; /* WEFT_BACKEND_MAGIC */
  uint32_t    size;  /* of this struct when the plug-in was compiled */
  uint32_t    major, minor;
  const char *name;  /* [a-z0-9]{1,31}, as in the file name */

  /* Never fails: a machine without devices has none. */
  uint32_t    (*device_count)(void) WEFT_NOEXCEPT;
  /* Fills status, description, exact, and the part of name after the colon. */
  void        (*device_info)(uint32_t index, weft_device_info *info) WEFT_NOEXCEPT;
  weft_status (*device_open)(const weft_host *host, uint32_t index, weft_device_limits *limits, weft_backend_device **device) WEFT_NOEXCEPT;
  void        (*device_close)(weft_backend_device *device) WEFT_NOEXCEPT;
  /* WEFT_ERROR_UNSUPPORTED: libweft opens this program on "scalar" instead. Any other error is the caller's. */
  weft_status (*texture_open)(weft_backend_device *device, const weft_program *program, weft_backend_texture **texture) WEFT_NOEXCEPT;
  weft_status (*texture_render)(weft_backend_texture *texture, const weft_window *window) WEFT_NOEXCEPT;
  weft_status (*texture_sample)(weft_backend_texture *texture, const weft_batch *batch) WEFT_NOEXCEPT;
  void        (*texture_close)(weft_backend_texture *texture) WEFT_NOEXCEPT;
  /* minor 1 and later: append here */
} weft_backend;

#define WEFT_BACKEND_HEAD(name) WEFT_BACKEND_MAGIC, sizeof(weft_backend), WEFT_BACKEND_MAJOR, WEFT_BACKEND_MINOR, name

/* Is `field` present in the struct that `object` points to, which may be of an older libweft? */
#define WEFT_HAS(object, type, field) ((object)->size >= offsetof(type, field) + sizeof((object)->field))

/* 1 if everything of a struct beyond what this plug-in was compiled with is zero: new meaning is never ignored. */
static inline int32_t weft_understands(const void *object, uint32_t size, uint32_t known)
{
  const unsigned char *byte = (const unsigned char *)object;
  uint32_t i;
  for (i = known; i < size; ++i)
    if (byte[i] != 0) return 0;
  return 1;
}

#define WEFT_UNDERSTANDS(object, type) ((object) == NULL || weft_understands((object), (object)->size, (uint32_t)sizeof(type)))

/* 1 if a program, with everything below it, holds nothing newer than this header. */
static inline int32_t weft_understands_program(const weft_program *program)
{
  uint32_t i;
  if (!WEFT_UNDERSTANDS(program, weft_program) || program->use < WEFT_USE_WINDOW || program->use > WEFT_USE_SOLID) return 0;
  for (i = 0; i < program->layer_count; ++i) {
    const weft_layer *layer = program->layers[i];
    if (!WEFT_UNDERSTANDS(layer, weft_layer) || layer->kind < WEFT_LAYER_SPLAT || layer->kind > WEFT_LAYER_TILE) return 0;
    if (!WEFT_UNDERSTANDS(layer->splat, weft_splat) || !WEFT_UNDERSTANDS(layer->bands, weft_bands) ||
        !WEFT_UNDERSTANDS(layer->tile, weft_tile)) return 0;
    if (layer->splat && !WEFT_UNDERSTANDS(layer->splat->textons, weft_mips)) return 0;
    if (layer->tile && (layer->tile->address < WEFT_ADDRESS_CELLS || layer->tile->address > WEFT_ADDRESS_WANG ||
                        !WEFT_UNDERSTANDS(layer->tile->source, weft_mips) || !WEFT_UNDERSTANDS(layer->tile->wang, weft_wang) ||
                        !WEFT_UNDERSTANDS(layer->tile->exchange, weft_exchange))) return 0;
  }
  return 1;
}

/* The one symbol a plug-in exports; the declaration gives it C linkage and external linkage. */
WEFT_BACKEND_VISIBLE extern const weft_backend weft_backend_v0;

#ifdef __cplusplus
}
#endif
#endif
