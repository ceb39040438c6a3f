/* Wavelet noise in space as it is commonly evaluated, point by point: the yardstick for faster forms. */
#ifndef WEFT_CLI_YARDSTICK_SOLID_H
#define WEFT_CLI_YARDSTICK_SOLID_H

#include <stdint.h>

typedef struct solid_noise {
    float* tile; /* cube of random coefficients: what they are makes no difference to speed */
} solid_noise;

/* 0 on success. Free with solid_free. */
int solid_open(solid_noise* noise);
void solid_free(solid_noise* noise);

/* Sum of octaves at one position: octave b has cells of 2^b. */
float solid_value(const solid_noise* noise, uint32_t bands, const double* position);

#endif
