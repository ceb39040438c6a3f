/* Wavelet noise models of the tests, made without photos. */
#ifndef WEFT_TESTS_WAVELETS_H
#define WEFT_TESTS_WAVELETS_H

#include "support.h"

/* Mean 0.5, the axes those of the channels, all weights 0, no tone curves: the least that is a model. */
weft_wavelet plain_wavelet(uint32_t channels, uint32_t bands);

/* Random weights below 0.2, a random frame, and curved tone curves where knots > 0. */
weft_wavelet random_wavelet(uint32_t channels, uint32_t bands, uint32_t knots, uint64_t seed);

/* Its model; a refusal ends the test. */
weft_model *new_wavelet(weft_context *context, const weft_wavelet *wavelet);

#endif
