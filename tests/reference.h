/* Algorithm 1 of Galerne et al. 2017 once more, in plain loops and double, to judge the analysis by. */
#ifndef WEFT_TESTS_REFERENCE_H
#define WEFT_TESTS_REFERENCE_H

#include "support.h"

#define REFERENCE_CHANNELS 4

typedef struct Complex {
    double re, im;
} Complex;

/* What is known of an exemplar: the DFT of its normalised periodic component, and that of the sampled B-spline. */
typedef struct Reference {
    uint32_t width, height, channels;
    Complex *spectrum[REFERENCE_CHANNELS]; /* t^ */
    double *spline;                        /* b^ */
    double mean[REFERENCE_CHANNELS];
    double covariance[REFERENCE_CHANNELS][REFERENCE_CHANNELS]; /* sum over x of t(x) t(x)^T */
} Reference;

void reference_open(Reference *reference, const weft_image *photo, weft_interpolation interpolation);
void reference_close(Reference *reference);

/* Relative model error of coefficients (a model's part) against the exemplar. */
double reference_error(const Reference *reference, const weft_image *coefficients);

/* Coefficients by `iterations` of the plain projections from the reference's own white noise, with colour correction
 * for one channel (a scaling); for more channels, without. */
weft_image reference_projections(const Reference *reference, uint32_t support, uint32_t iterations, uint64_t seed);

#endif
