/* What the tests share: the headers in cmocka's order, checks of statuses, random numbers, images, handles, devices. */
#ifndef WEFT_TESTS_SUPPORT_H
#define WEFT_TESTS_SUPPORT_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h> /* needs those above before it */
#include <weft/weft.h>

/* Asserts that a call succeeds; prints its sentence when it does not. */
#define assert_ok(call) check_ok((call), #call, __FILE__, __LINE__)

/* Asserts that a call is refused with `status` and that the sentence begins with the function's name and has `word`. */
#define assert_refused(call, status, function, word)                                                                   \
    check_refused((call), #call, (status), (function), (word), __FILE__, __LINE__)

void check_ok(weft_status status, const char *call, const char *file, int line);
void check_refused(weft_status status, const char *call, weft_status expected, const char *function, const char *word,
                   const char *file, int line);

/* Sanitizers make everything slow: `full` normally, `quick` when compiled for them or when WEFT_TEST_QUICK is set. */
uint32_t scaled(uint32_t full, uint32_t quick);

/* Random numbers (splitmix64), the same on every machine. */
typedef struct Random {
    uint64_t state;
} Random;
uint64_t random_bits(Random *random);
uint32_t random_below(Random *random, uint32_t bound);
double random_unit(Random *random);   /* [0, 1) */
double random_normal(Random *random); /* sum of twelve: no C library function, the same everywhere */

/* Images that own their pixels: packed, zeroed. */
weft_image new_image(uint32_t width, uint32_t height, uint32_t channels, weft_format format);
void free_image(weft_image *image);
size_t image_bytes(const weft_image *image);
float *values(const weft_image *image); /* of an F32 image */
float value_at(const weft_image *image, uint32_t x, uint32_t y, uint32_t channel);
void fill_bytes(const weft_image *image, int byte);
int all_bytes(const weft_image *image, int byte);
int same_pixels(const weft_image *a, const weft_image *b); /* every bit, packed images */
void assert_same_pixels_at(const weft_image *a, const weft_image *b, const char *what, const char *file, int line);
#define assert_same_pixels(a, b, what) assert_same_pixels_at((a), (b), (what), __FILE__, __LINE__)

/* Synthetic exemplars, F32, mean 0.5 and deviation about 0.1 in every channel. */
typedef enum Grain { GRAIN_WHITE, GRAIN_SOFT, GRAIN_STREAKS, GRAIN_BAND } Grain;
weft_image new_grain(Grain grain, uint32_t width, uint32_t height, uint32_t channels, uint64_t seed);

/* Handles; every failure ends the test. */
weft_context *new_context(const char *device, uint32_t threads);
weft_model *new_texton(weft_context *context, uint32_t side, uint32_t channels, uint32_t support,
                       weft_interpolation interpolation, uint64_t seed);
weft_model *new_picture(weft_context *context, uint32_t width, uint32_t height, uint32_t channels, uint64_t seed);
weft_texture *new_texture(weft_context *context, const weft_model *model, float impacts, uint64_t seed,
                          uint32_t period);
weft_image rendered(const weft_texture *texture, int64_t x, int64_t y, uint32_t level, uint32_t width, uint32_t height,
                    uint32_t channels);
void *saved(const weft_model *model, size_t *size);
weft_image part_of(const weft_model *model, uint32_t index);

/* Names of the devices that can be used here; `exact_only` leaves out those that are not exact. Returns their number.
 */
#define MOST_DEVICES 32
uint32_t usable_devices(char names[MOST_DEVICES][64], int exact_only);

/* FNV-1a of bytes. */
uint64_t checksum(const void *bytes, size_t size);

/* A whole file; NULL if there is none. */
void *read_file(const char *path, size_t *size);

#endif
