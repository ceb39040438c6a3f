/* libweft: texture synthesis by example.
 *
 *   photo --weft_analyze_texton--> model --weft_texture_create--> texture --weft_texture_render--> pixels
 *
 * A model holds what was learnt from one photo. A texture is one endless realisation of a model, chosen by a
 * seed: a pure function from positions to colours. The same position of the same texture is always the same
 * pixel: for every window, every number of threads, and every device whose `exact` is 1.
 *
 * Handles    are opaque and owned by the caller: whatever a function writes through its last argument is freed
 *            with the matching weft_*_free, in any order. NULL may be freed.
 * Errors     are return values. WEFT_OK is 0, every error is negative, and outputs are written only on success.
 *            weft_error_message() tells the story of the last error on this thread.
 * Threads    any function may be called from any thread at any time; models and textures are immutable, so one
 *            handle may be used by many threads at once. Nobody may be using what is freed.
 * Structs    that begin with `size` may grow at their end. Start them from their _INIT value; a zero field
 *            always means the default. A shorter struct of an older header is taken as if its tail were zero. A
 *            longer one of a newer header must be zero beyond what this library knows, else WEFT_ERROR_UNSUPPORTED;
 *            of one that is filled in, the unknown tail becomes zero. A field called `zero` counts as such a tail. A
 *            size below 4 or above 4096 (of weft_wavelet 16384) is WEFT_ERROR_ARGUMENT.
 * Values     are used in the encoding they come in: sRGB in, sRGB out; data in, data out. Output is never
 *            normalised per image; integer formats are rounded to nearest and clamped.
 * Positions  are in pixels of the exemplar, x to the right and y down; a pixel (i, j) is the sample at its
 *            centre (i + 0.5, j + 0.5).
 */
#ifndef WEFT_WEFT_H
#define WEFT_WEFT_H

#include <stddef.h>
#include <stdint.h>

#define WEFT_VERSION_MAJOR 0
#define WEFT_VERSION_MINOR 1
#define WEFT_VERSION_PATCH 0

#if defined(_WIN32) && defined(WEFT_BUILD)
#  define WEFT_API __declspec(dllexport)
#elif defined(_WIN32) && !defined(WEFT_STATIC)
#  define WEFT_API __declspec(dllimport)
#elif defined(_WIN32)
#  define WEFT_API
#else
#  define WEFT_API __attribute__((visibility("default")))
#endif

/* From C++17 on, noexcept is part of a function's type: a callback that may throw does not compile. */
#if defined(__cplusplus) && __cplusplus >= 201703L
#  define WEFT_NOEXCEPT noexcept
#else
#  define WEFT_NOEXCEPT
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Version and errors ---------------------------------------------------------------------------------------- */

/* Version of the library that is running: major << 16 | minor << 8 | patch. */
WEFT_API uint32_t weft_version(void) WEFT_NOEXCEPT;

typedef int32_t weft_status;
enum {
  WEFT_OK                =  0,
  WEFT_ERROR_ARGUMENT    = -1, /* an argument breaks its contract */
  WEFT_ERROR_MEMORY      = -2, /* the allocator or the context's memory_limit said no */
  WEFT_ERROR_CANCELLED   = -3, /* the progress function asked to stop */
  WEFT_ERROR_FORMAT      = -4, /* the bytes are not a valid model */
  WEFT_ERROR_UNSUPPORTED = -5, /* made by, or meant for, a newer libweft; or not defined for this model */
  WEFT_ERROR_DEVICE      = -6, /* no such device, or it failed */
  WEFT_ERROR_INTERNAL    = -7  /* a bug in libweft or in a plug-in */
};

/* "WEFT_OK", "WEFT_ERROR_ARGUMENT", ...; never NULL. */
WEFT_API const char *weft_status_name(weft_status status) WEFT_NOEXCEPT;

/* One sentence about the last error on the calling thread, naming the function, the argument and the number;
 * never NULL. Valid until this thread's next failing call. */
WEFT_API const char *weft_error_message(void) WEFT_NOEXCEPT;

/* Devices --------------------------------------------------------------------------------------------------- */

typedef struct weft_device_info {
  uint32_t    size;
  weft_status status;           /* WEFT_OK, or why this device cannot be used here */
  char        name[64];         /* "scalar", "simd:avx512", "opencl:0" */
  char        description[128]; /* of the device when usable, of the refusal when not */
  uint32_t    exact;            /* 1: bit for bit the pixels of "scalar" */
} weft_device_info;
#define WEFT_DEVICE_INFO_INIT { sizeof(weft_device_info), 0, "", "", 0 }

/* Devices of the built-in and of all loaded backends, best first within a backend; refused ones included. */
WEFT_API weft_status weft_device_count(uint32_t *count) WEFT_NOEXCEPT;
WEFT_API weft_status weft_device_get(uint32_t index, weft_device_info *info) WEFT_NOEXCEPT;

/* Loads one more backend plug-in from an absolute path (see backend.h). Those beside libweft need no asking. */
WEFT_API weft_status weft_backend_load(const char *path) WEFT_NOEXCEPT;

/* Context --------------------------------------------------------------------------------------------------- */

typedef struct weft_context weft_context;

typedef struct weft_allocator {
  void *(*allocate)(void *user, size_t size, size_t alignment) WEFT_NOEXCEPT; /* NULL: no memory */
  void (*deallocate)(void *user, void *memory, size_t size, size_t alignment) WEFT_NOEXCEPT;
  void *user;
} weft_allocator;

/* Calls task(argument, i) once for each i < count, on any threads, and returns when all are done. */
typedef struct weft_executor {
  void (*run)(void *user, uint32_t count, void (*task)(void *argument, uint32_t i), void *argument) WEFT_NOEXCEPT;
  void *user;
} weft_executor;

typedef struct weft_context_options {
  uint32_t size;
  uint32_t threads;                /* of libweft's own pool; 0: one per available CPU; 1: the caller's only */
  const char *device;              /* a device name, or a backend's for its best; NULL: best CPU device */
  uint64_t memory_limit;           /* bytes held at once; 0: 4 GiB */
  const weft_allocator *allocator; /* copied; NULL: malloc */
  const weft_executor *executor;   /* copied; NULL: libweft's own pool */
} weft_context_options;
#define WEFT_CONTEXT_OPTIONS_INIT { sizeof(weft_context_options), 0, NULL, 0, NULL, NULL }

/* The allocator and the executor must outlive every handle made from the context. */
WEFT_API weft_status weft_context_create(const weft_context_options *options, weft_context **context) WEFT_NOEXCEPT;
WEFT_API weft_status weft_context_device(const weft_context *context, weft_device_info *info) WEFT_NOEXCEPT;
WEFT_API void weft_context_free(weft_context *context) WEFT_NOEXCEPT;

/* Called on the thread that called libweft, with `done` growing from 0 to 1. A non-zero answer cancels. */
typedef int32_t (*weft_progress)(void *user, float done) WEFT_NOEXCEPT;

/* Image ----------------------------------------------------------------------------------------------------- */

typedef int32_t weft_format;
enum {
  WEFT_FORMAT_U8  = 1, /* 0..255   stands for 0..1 */
  WEFT_FORMAT_U16 = 2, /* 0..65535 stands for 0..1, native byte order */
  WEFT_FORMAT_F32 = 3  /* taken as it is; must be finite and within 2^64 of 0 */
};

/* A view of the caller's pixels, channels interleaved. Frozen: this struct will never grow. More than 4 channels
 * are further maps of the same surface (height, roughness, ...), analysed and synthesised together. */
typedef struct weft_image {
  void       *data;
  int64_t     stride;   /* bytes from one row to the next; 0: rows are packed; may be negative */
  uint32_t    width;    /* 1..65536 */
  uint32_t    height;   /* 1..65536 */
  uint32_t    channels; /* 1..16 */
  weft_format format;
} weft_image;

/* Analysis: photo -> model ---------------------------------------------------------------------------------- */

typedef struct weft_model weft_model;

typedef int32_t weft_interpolation;
enum {
  WEFT_INTERPOLATION_DEFAULT = 0, /* linear */
  WEFT_INTERPOLATION_NEAREST = 1, /* B-spline of order 0: one coefficient per impact */
  WEFT_INTERPOLATION_LINEAR  = 2, /* order 1: 2 x 2 */
  WEFT_INTERPOLATION_CUBIC   = 4, /* order 3: 4 x 4 */
  WEFT_INTERPOLATION_QUINTIC = 6  /* order 5: 6 x 6 */
};

typedef int32_t weft_projection;
enum {
  WEFT_PROJECTION_DEFAULT  = 0,
  WEFT_PROJECTION_PLAIN    = 1, /* alternating projections as Algorithm 1 of the paper has them */
  WEFT_PROJECTION_MOMENTUM = 2  /* the default: in the model error's own norm, from points beyond the last (Nesterov 1983),
                                  weak frequencies eased in */
};

/* Texton noise: Galerne, Leclaire, Moisan, "Texton Noise", Computer Graphics Forum 2017. */
typedef struct weft_texton_options {
  uint32_t           size;
  uint32_t           support;       /* edge of the texton in coefficients, 1..the photo's shorter side; 0: 64, or that side */
  uint32_t           iterations;    /* of the projections, up to 100000; 0: 100, and 50 for PLAIN as the paper has it */
  weft_interpolation interpolation; /* how the texton's coefficients are interpolated */
  weft_projection    projection;
  uint32_t           zero;
  uint64_t           seed;          /* of the white noise that the projections start from */
} weft_texton_options;
#define WEFT_TEXTON_OPTIONS_INIT { sizeof(weft_texton_options), 0, 0, 0, 0, 0, 0 }

/* Learns a texton from a photo of 8 x 8 to 8192 x 8192 pixels. `options` may be NULL, and so may `progress`. */
WEFT_API weft_status weft_analyze_texton(weft_context *context, const weft_image *photo, const weft_texton_options *options,
                                         weft_progress progress, void *user, weft_model **model) WEFT_NOEXCEPT;

/* Multiresolution wavelet noise: Lagae, Vangorp, Lenaerts, Dutre, "Procedural Isotropic Stochastic Textures by Example",
 * Computers & Graphics 2010. */
typedef struct weft_wavelet_options {
  uint32_t size;
  uint32_t bands;      /* octaves, from the pixel's own (1/4..1/2 cycles per pixel) downwards, 1..16; 0: all that the photo holds */
  uint32_t tone_knots; /* of each principal channel's tone curve, 2..32; 0: 10 */
  uint32_t gaussian;   /* 1: no tone curve, the output is Gaussian */
} weft_wavelet_options;
#define WEFT_WAVELET_OPTIONS_INIT { sizeof(weft_wavelet_options), 0, 0, 0 }

/* Learns the weights of octaves of wavelet noise from a photo of 8 x 8 to 8192 x 8192 pixels. */
WEFT_API weft_status weft_analyze_wavelet(weft_context *context, const weft_image *photo, const weft_wavelet_options *options,
                                          weft_progress progress, void *user, weft_model **model) WEFT_NOEXCEPT;

typedef int32_t weft_masks;
enum {
  WEFT_MASKS_DEFAULT     = 0, /* BINARY */
  WEFT_MASKS_BINARY      = 1, /* each pixel has the noise whose spectrum is nearest to its own */
  WEFT_MASKS_BARYCENTRIC = 2  /* convex weights after the distances to all of them */
};

/* How the structure layer is put together anew. */
typedef int32_t weft_structure;
enum {
  WEFT_STRUCTURE_AUTO     = 0, /* decided by what the exemplar bears */
  WEFT_STRUCTURE_WANG     = 1, /* Wang tiles of diamonds and minimal cuts */
  WEFT_STRUCTURE_EXCHANGE = 2, /* the exemplar as a torus, the contents of its patches exchanged */
  WEFT_STRUCTURE_BOTH     = 3, /* contents exchanged within Wang tiles */
  WEFT_STRUCTURE_NONE     = 4  /* no structure: noise whose spectrum varies in space, or is stationary with one noise */
};

/* Bi-layer textures: Guingo, Sauvage, Dischler, Cani, "Bi-Layer Textures: a Model for Synthesis and Deformation of Composite
 * Textures", Computer Graphics Forum 2017. */
typedef struct weft_bilayer_options {
  uint32_t       size;
  uint32_t       noises;      /* K: noises of different spectra, 1..6; 0: as many as the local spectra tell apart */
  uint32_t       window;      /* T_loc of the filter that finds the structure: 2, 4, 8 or 16 pixels; 0: 4 */
  uint32_t       mask_window; /* T_loc of the masks; 0: 8 */
  uint32_t       support;     /* T, side of the noises' spectra and textons: 8..256; 0: 64, or what the photo has room for */
  weft_masks     masks;
  weft_structure structure;
  uint32_t       colours;     /* of the edges of Wang tiles, 2..16; 0: 4 */
  uint32_t       border;      /* pixels on both sides of the masks' borders that belong to the structure alone, up to 64; 0: none */
  uint32_t       equalize;    /* 1: each noise is given the histograms it had */
  uint32_t       depth;       /* passes of the filter, each over the noise that the last one left, 1..4; 0: 1 */
  uint32_t       filter_width;      /* of the filter's neighbourhood in pixels, 2..64; 0: 16 */
  uint32_t       filter_iterations; /* 1..32; 0: 5 */
  float          filter_sigma;      /* distance of local spectra that the filter joins, of values in 0..1; 0: 0.01 */
  uint64_t       seed;
} weft_bilayer_options;
#define WEFT_BILAYER_OPTIONS_INIT { sizeof(weft_bilayer_options), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }

/* Splits a photo of 32 x 32 to 8192 x 8192 pixels into structure and noises. `options` and `progress` may be NULL. */
WEFT_API weft_status weft_analyze_bilayer(weft_context *context, const weft_image *photo, const weft_bilayer_options *options,
                                          weft_progress progress, void *user, weft_model **model) WEFT_NOEXCEPT;

/* How alike the neighbourhoods of all pixels are, in CIE L*a*b*, channel by channel (Moritz, James, Haines, Ritschel,
 * Weyrich, "Texture Stationarization: Turning Photos into Tileable Textures", Computer Graphics Forum 2017, section 3). */
typedef int32_t weft_stationarity;
enum {
  WEFT_STATIONARITY_DEFAULT   = 0, /* HISTOGRAM */
  WEFT_STATIONARITY_HISTOGRAM = 1, /* local histograms */
  WEFT_STATIONARITY_MOMENTS   = 2, /* local moments; evener results, and plainer */
  WEFT_STATIONARITY_STEERABLE = 3, /* local histograms of steerable filters in 4 orientations */
  WEFT_STATIONARITY_NONE      = 4  /* nothing: a tile without seams, whose features repeat */
};

/* Where an analysis is after an iteration. */
typedef struct weft_stationary_step {
  uint32_t size;
  uint32_t level, levels;         /* of the pyramid, from 0, the coarsest, on */
  uint32_t iteration, iterations; /* at this level, from 0 on */
  uint32_t width, height;         /* of the tile at this level */
  float    texture_cost;          /* as weft_texture_cost has it, of the patches as they were found; -1: unknown */
  float    stationarity_cost;     /* as weft_stationarity_cost has it, roughly; -1: unknown */
} weft_stationary_step;

/* Called on the thread that called libweft. */
typedef void (*weft_stationary_report)(void *user, const weft_stationary_step *step) WEFT_NOEXCEPT;

/* Texture stationarization. */
typedef struct weft_stationary_options {
  uint32_t           size;
  uint32_t           width, height; /* of the tile in pixels, 64..2048; 0: 256 */
  weft_stationarity  stationarity;
  uint32_t           moments;       /* order of the moments, 1..4; 0: 2 */
  float              sigma;         /* deviation of the Gaussian neighbourhoods over the tile's shorter side, 0.02..1: the smaller,
                                       the evener; 0: 0.1 */
  uint32_t           patch;         /* side of the patches in pixels, odd, 3..31; 0: 11. The last vote is of their middle 7 x 7 */
  uint32_t           start;         /* the coarsest level is 1 / start of the tile, 2..16: the more, the larger the features that
                                       stay; 0: 4 */
  uint64_t           seed;
  const weft_image  *sigma_map;     /* 1 channel in 0..1, stretched over the tile: factor of sigma from place to place; NULL: 1 */
  weft_stationary_report report;    /* told after each iteration; NULL: nobody is */
  void              *report_user;
} weft_stationary_options;
#define WEFT_STATIONARY_OPTIONS_INIT { sizeof(weft_stationary_options), 0, 0, 0, 0, 0, 0, 0, 0, NULL, NULL, NULL }

/* Makes a tile of a photo of `patch` x `patch` to 8192 x 8192 pixels that repeats without a seam and without a feature that
 * sticks out. Of 3 channels or more the first 3 are taken as sRGB, of fewer the first as grey; the others follow them.
 * Every value of the tile is a weighted mean of values of the photo. A seed gives the same tile on every machine.
 * WEFT_ERROR_ARGUMENT: the photo is smaller than a patch, or one colour. */
WEFT_API weft_status weft_analyze_stationary(weft_context *context, const weft_image *photo, const weft_stationary_options *options,
                                             weft_progress progress, void *user, weft_model **model) WEFT_NOEXCEPT;

/* A picture as it is, repeated in both directions: the simplest texture. 1 x 1 to 16384 x 16384 pixels. */
WEFT_API weft_status weft_analyze_picture(weft_context *context, const weft_image *picture, weft_model **model) WEFT_NOEXCEPT;

/* Model ----------------------------------------------------------------------------------------------------- */

typedef int32_t weft_method;
enum {
  WEFT_METHOD_TEXTON     = 1, /* texton noise */
  WEFT_METHOD_WAVELET    = 2, /* multiresolution wavelet noise */
  WEFT_METHOD_BILAYER    = 3, /* structure and noises */
  WEFT_METHOD_STATIONARY = 4, /* a tile made of a photo's patches, repeated */
  WEFT_METHOD_PICTURE    = 5  /* a picture, repeated */
};

typedef struct weft_model_info {
  uint32_t    size;
  weft_method method;
  uint32_t    channels;
  uint32_t    parts;         /* images that weft_model_part hands out */
  uint64_t    bytes;         /* of weft_model_save */
  uint32_t    width, height; /* of the texton, structure, tile or picture, in pixels of the exemplar */
  float       model_error;   /* relative model error against the periodogram of the photo (Xia et al. 2014): 0 best; -1: unknown */
  weft_interpolation interpolation; /* of the texton; 0 for other methods */
  float       mean[16];      /* of the texture, per channel: exact; of a mixed model, here and below: of its first step */
  float       deviation[16]; /* standard deviation of the texture at pixel centres, level 0, per channel */
  uint32_t    photo_width, photo_height; /* that a tile's correspondence points into; 0 for other methods */
} weft_model_info;
#define WEFT_MODEL_INFO_INIT { sizeof(weft_model_info), 0, 0, 0, 0, 0, 0, 0, 0, { 0 }, { 0 }, 0, 0 }

/* Untrusted bytes are welcome: every field is checked before it is used. */
WEFT_API weft_status weft_model_load(weft_context *context, const void *bytes, size_t size, weft_model **model) WEFT_NOEXCEPT;

/* Writes exactly weft_model_info.bytes; the same model always gives the same bytes. `size` must be that number. */
WEFT_API weft_status weft_model_save(const weft_model *model, void *bytes, size_t size) WEFT_NOEXCEPT;

/* The `.texton` text of the authors of texton noise: one texton of 3 channels, its values in 0..1 as a model's are. Its
 * frame of zeros is taken off if it is whole. The text need not end with a NUL. */
WEFT_API weft_status weft_model_load_texton(weft_context *context, const char *text, size_t size, weft_model **model) WEFT_NOEXCEPT;

/* Writes the text, without a NUL, and its length to `*length`. With text NULL and size 0 only the length. Every float
 * comes back from the text as it was; one channel is written three times over, as the text knows only colours.
 * WEFT_ERROR_UNSUPPORTED: the model is no texton of 1 or 3 channels. */
WEFT_API weft_status weft_model_save_texton(const weft_model *model, char *text, size_t size, size_t *length) WEFT_NOEXCEPT;

WEFT_API weft_status weft_model_get(const weft_model *model, weft_model_info *info) WEFT_NOEXCEPT;

/* All parameters of a wavelet noise model, to read, edit and make one without a photo. Colour of channel o at x:
 *   mean[o] + sum over p of axes[p][o] * tone_p( sum over b of weight[b][p] * N_bp(x) )
 * N is wavelet noise of unit variance over the centres of pixels at level 0 (in space over all positions), band b holding
 * 2^-(b+2)..2^-(b+1) cycles per pixel; a period too short for a band leaves it out; tone_p is the monotone cubic
 * Hermite spline through its knots, constant beyond them (Fritsch and Carlson 1980); none: tone_p(v) = v. */
typedef struct weft_wavelet {
  uint32_t size;
  uint32_t channels; /* 1..16 */
  uint32_t bands;    /* 1..16 */
  uint32_t knots;    /* 0: no tone curves; else 2..32 */
  float    mean[16];
  float    axes[16][16];      /* row p: principal axis p, of unit length, orthogonal to the others */
  float    weight[16][16];    /* [band][axis], 0 or more */
  float    knot_x[32][16];    /* [knot][axis], ascending */
  float    knot_y[32][16];    /* not descending */
  float    knot_slope[32][16];
} weft_wavelet;
#define WEFT_WAVELET_INIT { sizeof(weft_wavelet), 0, 0, 0, { 0 }, { { 0 } }, { { 0 } }, { { 0 } }, { { 0 } }, { { 0 } } }

/* Sets `wavelet` (whose `size` is set) to the parameters of a wavelet noise model. UNSUPPORTED: the model is no such. */
WEFT_API weft_status weft_model_get_wavelet(const weft_model *model, weft_wavelet *wavelet) WEFT_NOEXCEPT;
WEFT_API weft_status weft_model_from_wavelet(weft_context *context, const weft_wavelet *wavelet, weft_model **model) WEFT_NOEXCEPT;

/* Between two models of one method and as many channels.
 * Textons: `steps` (2..255) textons on the transport path from a to b (Galerne et al. 2017, section 7; Xia et al. 2014), of
 *   which weft_texture_options.mix says where each applies; t is ignored.
 * Wavelets: the model at t (0: a, 1: b), every parameter linear, the colour frame by the shortest rotation; steps is ignored. */
WEFT_API weft_status weft_model_mix(weft_context *context, const weft_model *a, const weft_model *b, float t, uint32_t steps,
                                    weft_model **model) WEFT_NOEXCEPT;

/* What a model holds, as images for people and for other programs. */
typedef struct weft_part_info {
  uint32_t size;
  char     name[32]; /* "texton", "picture"; of a mixed model "texton 0", "texton 1", ...; of a stationary one "tile" and
                        "correspondence": x and y of the pixel of the photo that is the middle of each pixel's patch; of a bi-layer
                        one "structure", "mask 0", ..., "texton 0", ... along principal axes, "noise": what the photo
                        has beyond its structure, "patches": their numbers, "contents": a row of patch, x, y, degrees,
                        scale for each */
  uint32_t width, height, channels;
  float    low, high; /* least and greatest value in it */
} weft_part_info;
#define WEFT_PART_INFO_INIT { sizeof(weft_part_info), "", 0, 0, 0, 0, 0 }

/* Part `index`, below weft_model_info.parts. */
WEFT_API weft_status weft_model_part(const weft_model *model, uint32_t index, weft_part_info *info) WEFT_NOEXCEPT;

/* Fills `image`, whose size, channels and format (F32) must be the part's, with the part's values as they are. */
WEFT_API weft_status weft_model_part_read(const weft_model *model, uint32_t index, const weft_image *image) WEFT_NOEXCEPT;

/* Puts another map of the same surface together as the tile of a stationary model was put together of its photo. `map` has
 * the photo's width and height, `tile` the tile's width and height and the map's channels; any formats. The photo gives the
 * tile, bit for bit in F32. WEFT_ERROR_UNSUPPORTED: the model is not stationary. */
WEFT_API weft_status weft_model_apply(const weft_model *model, const weft_image *map, const weft_image *tile) WEFT_NOEXCEPT;

WEFT_API void weft_model_free(weft_model *model) WEFT_NOEXCEPT;

/* Synthesis: model -> pixels -------------------------------------------------------------------------------- */

typedef struct weft_texture weft_texture;

/* What of a bi-layer model's exchanged contents may be turned. */
typedef int32_t weft_rotation;
enum {
  WEFT_ROTATION_DEFAULT = 0, /* what the exemplar bears, as the analysis measured it */
  WEFT_ROTATION_NONE    = 1,
  WEFT_ROTATION_ALL     = 2  /* by 45, 90, 135 and 180 degrees */
};

/* How a bi-layer model's noises are made. */
typedef int32_t weft_noise;
enum {
  WEFT_NOISE_DEFAULT = 0, /* TEXTON */
  WEFT_NOISE_TEXTON  = 1, /* texton noise: never repeats */
  WEFT_NOISE_TILE    = 2  /* large random-phase tiles that repeat: faster */
};

typedef struct weft_texture_options {
  uint32_t size;
  uint32_t period_x, period_y; /* pixels after which the texture repeats exactly, up to 2^24; 0: a noise never, others after themselves */
  float    impacts;            /* mean number of impacts of a noise, 1..1000; 0: 30 */
  uint64_t seed;
  const weft_image *mix;       /* 1 channel in 0..1, repeated: which step of a mixed model where, 0 the first, 1 the last; NULL: 0 */
  float    mix_scale;          /* pixels of the texture per pixel of `mix`, 1..65536, whole; 0: 1 */
  weft_rotation rotation;      /* here and below: of bi-layer models */
  float    scale_min;          /* least scale of exchanged contents, 0.5..1; 0: what the exemplar bears */
  float    turbulence;         /* smooth distortion of the structure in pixels, up to 64; 0: what the exemplar bears; below 0: none */
  weft_noise noise;
  uint32_t zero;
} weft_texture_options;
#define WEFT_TEXTURE_OPTIONS_INIT { sizeof(weft_texture_options), 0, 0, 0, 0, NULL, 0, 0, 0, 0, 0, 0 }

/* `options` may be NULL. A picture or tile takes only periods that are multiples of its size; else WEFT_ERROR_ARGUMENT. */
WEFT_API weft_status weft_texture_create(weft_context *context, const weft_model *model, const weft_texture_options *options,
                                         weft_texture **texture) WEFT_NOEXCEPT;

/* Fills `image` with the texture's pixels from (x, y) on, at mip level `level`, 0..30: one pixel covers 2^level pixels a
 * side, prefiltered, and x and y count such pixels. Two renderings that overlap agree exactly, everywhere within 2^60
 * pixels (of level 0) of the origin. */
WEFT_API weft_status weft_texture_render(const weft_texture *texture, int64_t x, int64_t y, uint32_t level,
                                         weft_progress progress, void *user, const weft_image *image) WEFT_NOEXCEPT;

/* What a renderer's shading point knows. Zero derivatives: no filtering. Everything finite, |x| and |y| below 2^52. */
typedef struct weft_point {
  double x, y;
  float  dx[2], dy[2]; /* change of x, and of y, from one screen pixel to the next: [0] to the right, [1] down */
} weft_point;

/* `out` receives `count` * channels floats. Runs on the calling thread; safe from any number of threads at once;
 * allocates nothing. */
WEFT_API weft_status weft_texture_sample(const weft_texture *texture, size_t count, const weft_point *points,
                                         float *out) WEFT_NOEXCEPT;

/* A position in space and an orthonormal tangent frame (normal = tangent x bitangent), in pixels of the exemplar: noise on a
 * surface without texture coordinates (Galerne et al. 2017, section 6). Textures of texton models only, without periods
 * and mix (ARGUMENT, else UNSUPPORTED); the default mean number of impacts is 60 here. The first call for a texture prepares,
 * and allocates; otherwise as weft_texture_sample. */
typedef struct weft_surface_point {
  double position[3];
  float  tangent[3];
  float  bitangent[3];
} weft_surface_point;
WEFT_API weft_status weft_texture_sample_surface(const weft_texture *texture, size_t count, const weft_surface_point *points,
                                                 float *out) WEFT_NOEXCEPT;

/* A position in space and the width of its footprint in pixels: solid textures. Wavelet models only, without periods.
 * Otherwise as weft_texture_sample_surface. */
typedef struct weft_solid_point {
  double position[3];
  float  footprint;
  float  zero;
} weft_solid_point;
WEFT_API weft_status weft_texture_sample_solid(const weft_texture *texture, size_t count, const weft_solid_point *points,
                                               float *out) WEFT_NOEXCEPT;

WEFT_API void weft_texture_free(weft_texture *texture) WEFT_NOEXCEPT;

/* Texture analysis ------------------------------------------------------------------------------------------- */

/* Power spectrum, channel by channel: the mean squared modulus of the DFT of Hann-windowed segments of spectrum's width
 * and height at half overlap or a little more (Welch 1967), mean removed, scaled so that its sum over all frequencies is the variance.
 * `spectrum` is F32, has the image's channels, and is not larger than it; frequency 0 is at (width / 2, height / 2). */
WEFT_API weft_status weft_power_spectrum(weft_context *context, const weft_image *image, const weft_image *spectrum) WEFT_NOEXCEPT;

/* Autocovariance, channel by channel, unbiased: the mean over all pairs of pixels at that lag. `autocovariance` is F32,
 * has the image's channels, and is not larger than it; lag 0 is at (width / 2, height / 2). */
WEFT_API weft_status weft_autocovariance(weft_context *context, const weft_image *image, const weft_image *autocovariance) WEFT_NOEXCEPT;

/* How many values of each channel lie in each of `bins` equal intervals of [low, high]; values outside are counted in the
 * nearest. `counts` receives channels * bins numbers, channel by channel. bins: 1..65536. */
WEFT_API weft_status weft_histogram(weft_context *context, const weft_image *image, float low, float high, uint32_t bins,
                                    uint64_t *counts) WEFT_NOEXCEPT;

typedef struct weft_compare_options {
  uint32_t size;
  uint32_t zero;
  uint64_t seed; /* of random directions, windows and null realisations */
} weft_compare_options;
#define WEFT_COMPARE_OPTIONS_INIT { sizeof(weft_compare_options), 0, 0 }

/* How close an output v is to its exemplar u. 0 is best but where said otherwise; -1: not defined for images this
 * small or this constant. Both are turned into the principal channels c of the exemplar, with variances s_c^2 and
 * total s^2.
 *
 * What is good depends on the exemplar: the floor is what the same metric gives for a second sample of the same
 * texture (two halves of the photo; for a Gaussian model two realisations), and 1.25 times that is as good as can be
 * told. The figures below are for a 256 x 256 exemplar and a 512 x 512 output; bad is what linear blending of
 * shifted copies, a blur of one pixel and white noise of the same histogram gave on photographs. */
typedef struct weft_comparison {
  uint32_t size;
  /* Distance of the Gaussian textures of both spectra (Xia, Ferradans, Peyre, Aujol 2014):
   *   d^2 = |m_u - m_v|^2 + sum_k tr(A_k + B_k - 2 (A_k^1/2 B_k A_k^1/2)^1/2), divided by sum_k tr A_k, rooted;
   * A, B: channels' covariance at frequency k, Welch's mean over Hann windows of 64 x 64 (less where images are
   * smaller) at half overlap, at most 4096 windows. Good below 0.15; bad from 0.22. Promised by every model. */
  float    model_error;
  /* Sliced Wasserstein distance of the colours (Bonneel, Rabin, Peyre, Pfister 2015): sum of W1(<d, u>, <d, v>) over
   * 64 random directions d over the sum of the deviations of <d, u>; W1 = integral of |quantile_u - quantile_v|. At
   * most 2^17 pixels of each, evenly spread. Good below 0.15; bad from 0.19. Gaussian models promise mean and
   * variance only. */
  float    histogram_distance;
  /* sum_c sum_t w_t (C_v(t) - C_u(t))^2 / sum_c sum_t w_t C_u(t)^2, rooted: C unbiased autocovariance, |t| <= 32 (or
   * half the shortest side), w_t = 1 - |t| / 33; from 256 blocks of a large image. Good up to 1.25 times the floor,
   * which is 0.1 to 0.7: autocovariances of small pictures are far from their mean; bad from 0.5, but blind to blur. */
  float    autocovariance_error;
  /* Sliced Wasserstein distance of whitened patches: 7 x 7, own mean off, principal components of u's patches scaled
   * to variance 1 (those below 1e-4 of the greatest left out), mean of W1 over 128 random directions; channels weigh
   * s_c, those below 1e-4 of the first variance nothing. 2^14 patches of each, so that 0.012 is as good as 0.
   * Levels: means of 1, 2 x 2, 4 x 4 pixels; patch_distance is the mean of those that are defined. Good below 0.1;
   * bad from 0.12. A Gaussian texture of a structured photo is at 0.02 to 0.21: so small a patch sees little of it. */
  float    patch_distance;
  float    patch_distance_level[3];
  /* Highest peak of v's circular autocovariance, sum_c C_v(t) / C_v(0), at lags beyond 48 pixels (or half u's
   * shorter side) along either axis, over the highest peak of 8 Gaussian textures with u's periodogram (asymptotic
   * discrete spot noise: Galerne, Gousseau, Morel 2011) at v's size. Needs v of 4 times u's area; of larger outputs
   * the middle, twice as large as u each way or 1024, is looked at. 1 is what chance gives, good below 1.6; plain
   * repeats 3 to 23. */
  float    repetition;
  /* Share of random 9 x 9 windows of v (first channel, 500; fewer, from 64, for u beyond 0.5 megapixels) whose
   * nearest window in u, by exhaustive search, has as right neighbour the nearest window of their right neighbour:
   * coherence as Ashikhmin 2001 has it. Chance gives 0.15 to 0.35, good below 0.5; copies and plain repeats from 0.88
   * to 1. */
  float    verbatim_copy;
  /* Of v alone, as a tile: with g_i the mean modulus of the first differences between lines i and i + 1, how many
   * standard deviations of the inner g_i the border's g is from their mean; the same for second differences, which
   * see kinks and blurred seams; the greatest modulus over both axes. Good below 2; crops that do not tile 3 to 130. */
  float    seam_score;
} weft_comparison;
#define WEFT_COMPARISON_INIT { sizeof(weft_comparison), 0, 0, 0, 0, { 0 }, 0, 0, 0 }

/* `options` may be NULL. Both images have the same channels and at least 16 x 16 pixels. */
WEFT_API weft_status weft_compare(weft_context *context, const weft_image *exemplar, const weft_image *output,
                                  const weft_compare_options *options, weft_progress progress, void *user,
                                  weft_comparison *comparison) WEFT_NOEXCEPT;

typedef struct weft_stationarity_options {
  uint32_t          size;
  weft_stationarity stationarity; /* not NONE */
  float             sigma;        /* as in weft_stationary_options */
  uint32_t          moments;      /* the same */
} weft_stationarity_options;
#define WEFT_STATIONARITY_OPTIONS_INIT { sizeof(weft_stationarity_options), 0, 0, 0 }

/* Stationarity cost c_stat of an image that repeats (equation 1 of the paper): the mean distance of the neighbourhoods of
 * two positions, over all pairs of a grid, summed over L*, a* and b* (one channel or two: L* of the first). 0: the same
 * everywhere. A neighbourhood has Gaussian weights of deviation sigma times the shorter side s, around the torus, and is
 * described by
 * HISTOGRAM  its histogram; distance: the earth mover's, in Lab units. 64 values from the image's least to its greatest,
 *            each pixel shared by the two nearest to it.
 * MOMENTS    its mean, deviation, and the cube and fourth root of its third and fourth central moment, as far as `moments`
 *            says; distance: squared difference, in squared Lab units.
 * STEERABLE  the histograms of third derivatives of a Gaussian in 4 orientations (Freeman, Adelson 1991), as in HISTOGRAM;
 *            distance: the sum of all 4.
 * The grid has 32 positions along the shorter side (or one a pixel) and as many along the other as its length wants, in the
 * middles of equal parts. `map` may be NULL; else it is F32 of 1 channel and its width and height are those of the grid
 * instead: each pixel receives the mean distance from there to everywhere. `options` may be NULL. 8 x 8 pixels at least. */
WEFT_API weft_status weft_stationarity_cost(weft_context *context, const weft_image *image, const weft_stationarity_options *options,
                                            weft_progress progress, void *user, const weft_image *map, float *cost) WEFT_NOEXCEPT;

typedef struct weft_texture_cost_options {
  uint32_t size;
  uint32_t patch;   /* side of the patches in pixels, 1..31; 0: 11 */
  uint32_t samples; /* patches that are looked for, 1..2^20; 0: 256 */
  uint32_t zero;
  uint64_t seed;    /* of their positions */
} weft_texture_cost_options;
#define WEFT_TEXTURE_COST_OPTIONS_INIT { sizeof(weft_texture_cost_options), 0, 0, 0, 0 }

/* Texture cost c_text of an output that repeats (equation 5 of the paper): the mean over random patches, around the torus, of
 * the squared distance to the nearest patch of the exemplar, over the number of pixels in a patch: squared Lab units per
 * pixel. Found by exhaustive search. 0: every patch is a copy. `options` may be NULL. Both images have the same channels and
 * no side is shorter than a patch. */
WEFT_API weft_status weft_texture_cost(weft_context *context, const weft_image *exemplar, const weft_image *output,
                                       const weft_texture_cost_options *options, weft_progress progress, void *user,
                                       float *cost) WEFT_NOEXCEPT;

/* Which method suits a photo. Measured on the most varied principal channel, the middle 512 x 512 pixels at most. Only
 * methods that this libweft has are recommended. */
typedef struct weft_description {
  uint32_t    size;
  weft_method method;
  /* How far from Gaussian: root mean square difference between the correlations of the moduli of 4 x 4 oriented bands
   * (octaves by directions: Portilla, Simoncelli 2000) and those of textures with the same spectrum and random phases,
   * less what chance gives. 0: Gaussian; texton noise 0.02 to 0.04, grass 0.1, gravel 0.15, tiles 0.4. */
  float       structure;
  float       structure_toned; /* the same after the values were made normal by a tone curve */
  float       histogram;  /* W1 distance of the values from normal ones, in standard deviations */
  float       anisotropy; /* of the spectrum: second and fourth harmonic of power by direction; 0: isotropic, 1: one direction */
  float       unevenness; /* of 8 x 8 blocks: standard deviation of their log deviations, and of their means over the whole's,
                             beyond that of Gaussian textures; 0: stationary */
  uint32_t    period_x, period_y; /* lag of the highest peak of the autocovariance along each axis, in pixels; 0: none */
  char        reasons[256]; /* a sentence for people */
} weft_description;
#define WEFT_DESCRIPTION_INIT { sizeof(weft_description), 0, 0, 0, 0, 0, 0, 0, 0, "" }

/* 16 x 16 pixels at least. */
WEFT_API weft_status weft_describe(weft_context *context, const weft_image *photo, weft_progress progress, void *user,
                                   weft_description *description) WEFT_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif
