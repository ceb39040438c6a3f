/* What a texton's coefficients promise: the covariance of the noise at integer lags (Galerne et al. 2017, section 4.1).
 */
#ifndef WEFT_TESTS_COVARIANCE_H
#define WEFT_TESTS_COVARIANCE_H

#include "support.h"

/* psi * psi at lag k, psi the B-spline of the interpolation. */
double spline_autocorrelation(weft_interpolation interpolation, int k);

/* E[(g_a(x) - mean_a) (g_b(x + (dx, dy)) - mean_b)], `texton` being the model's part. */
double noise_covariance(const weft_image *texton, weft_interpolation interpolation, uint32_t a, uint32_t b, int dx,
                        int dy);

#endif
