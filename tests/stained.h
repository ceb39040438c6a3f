/* Synthetic photographs that are not stationary, and plain measures of colours, for the tests of stationary tiles. */
#ifndef WEFT_TESTS_STAINED_H
#define WEFT_TESTS_STAINED_H

#include "support.h"

/* RGB, F32, within 0..1: grain of its own kind under a stain, under light that falls off, beside another material, and
 * with blotches of many sizes. */
typedef enum Stain { STAIN_BLOB, STAIN_LIGHT, STAIN_HALF, STAIN_BLOTCHES, STAINS } Stain;
weft_image new_stained(Stain stain, uint32_t width, uint32_t height, uint64_t seed);

/* 1 to 16 channels, F32, within 0..1: the first three as STAIN_BLOB, the others are functions of them and of the place.
 */
weft_image new_stained_maps(uint32_t width, uint32_t height, uint32_t channels, uint64_t seed);

/* A tile made of a small photo of `channels` channels. */
weft_model *new_tile(weft_context *context, uint32_t width, uint32_t height, uint32_t channels, uint64_t seed);

/* CIE L*a*b* by the formulas: 3 channels of 3 or more that are sRGB, 1 of 1 or 2. */
weft_image new_lab(const weft_image *image);

/* Mean modulus of the Laplacian of the first channel, without the border. */
double sharpness(const weft_image *lab);

/* Earth mover's distance of the values of both, summed over channels. */
double histogram_difference(const weft_image *lab, const weft_image *other);

#endif
