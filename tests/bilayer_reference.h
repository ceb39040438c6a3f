/* The bi-layer analysis in plain loops, as the paper has it, and photos of which the answer is known (Guingo et al.
 * 2017).
 */
#ifndef WEFT_TESTS_BILAYER_REFERENCE_H
#define WEFT_TESTS_BILAYER_REFERENCE_H

#include "support.h"

/* Local spectra: `size` = window^2 magnitudes per pixel, one pixel after another. Freed by the caller. */
double *local_spectra(const weft_image *photo, uint32_t window);
double distance_of(const double *a, const double *b, uint32_t size);

/* N = I - P by the joint bilateral filter, freed by the caller. */
weft_image filtered_noise(const weft_image *photo, uint32_t window, uint32_t width, uint32_t iterations, double sigma);

/* A Gaussian noise of known spectrum: waves of equal amplitude, whose frequencies lie around a few, from those on that
 * the window of local spectra holds a whole wave of: of slower ones it sees the local mean, and clusters follow that.
 */
#define WAVES 256
typedef struct Waves {
    double x[WAVES], y[WAVES], phase[WAVES]; /* cycles per pixel */
    uint32_t peaks;
    double peak_x[3], peak_y[3], width[3], weight[3];
} Waves;
void draw_waves(Waves *waves, Random *random);
double covariance_of_waves(const Waves *waves, int dx, int dy); /* 1 at lag 0 */
double overlap_of(const Waves *a, const Waves *b);              /* Bhattacharyya coefficient of their spectra */

/* 0.5 + 0.15 * one noise where `regions` is 1, another where it is 0; regions of about 70 pixels with borders that
 * wind. */
weft_image new_composite(const Waves *a, const Waves *b, const unsigned char *regions, uint32_t side);
void draw_regions(unsigned char *regions, uint32_t side, Random *random);

#endif
