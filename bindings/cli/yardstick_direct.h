/* Windows of wavelet noise without refinement from octave to octave: the yardstick for faster forms. */
#ifndef WEFT_CLI_YARDSTICK_DIRECT_H
#define WEFT_CLI_YARDSTICK_DIRECT_H

#include <stdint.h>

enum { DIRECT_SIDE = 256, DIRECT_BANDS = 16 };

/* Octaves of random coefficients: what they are makes no difference to speed. */
typedef struct direct_noise {
    float* tile; /* rows of DIRECT_SIDE coefficients, and the first two again */
    uint32_t bands;
} direct_noise;

/* 0 on success. Free with direct_free. */
int direct_open(direct_noise* noise, uint32_t bands);
void direct_free(direct_noise* noise);

/* Rows first..end - 1 of one channel, of `width` floats each, to `out`; 0, or -1 without memory. */
int direct_rows(const direct_noise* noise, uint32_t width, uint32_t first, uint32_t end, float* out);

#endif
