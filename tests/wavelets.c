/* Parameters of wavelet noise, plain and random. */
#include "wavelets.h"
#include <math.h>

weft_wavelet plain_wavelet(uint32_t channels, uint32_t bands)
{
    weft_wavelet wavelet = WEFT_WAVELET_INIT;
    wavelet.channels = channels;
    wavelet.bands = bands;
    for (uint32_t c = 0; c < channels; ++c) {
        wavelet.mean[c] = 0.5f;
        wavelet.axes[c][c] = 1;
    }
    return wavelet;
}

/* The mirror image of the channels' axes in a random plane (Householder 1958): orthonormal. */
static void set_random_axes(weft_wavelet *wavelet, Random *random)
{
    double normal[16], square = 0;
    for (uint32_t c = 0; c < wavelet->channels; ++c) {
        normal[c] = random_unit(random) + 0.1;
        square += normal[c] * normal[c];
    }
    for (uint32_t p = 0; p < wavelet->channels; ++p)
        for (uint32_t o = 0; o < wavelet->channels; ++o)
            wavelet->axes[p][o] = (float)((p == o) - 2 * normal[p] * normal[o] / square);
}

/* Knots from -0.4 to 0.4, rising unevenly; slopes as small as the flatter neighbour's secant, so that the curve rises.
 */
static void set_random_tones(weft_wavelet *wavelet, uint32_t axis, Random *random)
{
    const uint32_t knots = wavelet->knots;
    double x[32], y[32];
    for (uint32_t k = 0; k < knots; ++k) {
        x[k] = -0.4 + 0.8 * k / (knots - 1);
        y[k] = k == 0 ? -0.3 : y[k - 1] + 0.6 * random_unit(random) / (knots - 1);
    }
    for (uint32_t k = 0; k < knots; ++k) {
        const double before = k == 0 ? 1 : (y[k] - y[k - 1]) / (x[k] - x[k - 1]);
        const double after = k + 1 == knots ? before : (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
        wavelet->knot_x[k][axis] = (float)x[k];
        wavelet->knot_y[k][axis] = (float)y[k];
        wavelet->knot_slope[k][axis] = (float)fmin(before, after);
    }
}

weft_wavelet random_wavelet(uint32_t channels, uint32_t bands, uint32_t knots, uint64_t seed)
{
    Random random = {seed};
    weft_wavelet wavelet = plain_wavelet(channels, bands);
    wavelet.knots = knots;
    set_random_axes(&wavelet, &random);
    for (uint32_t p = 0; p < channels; ++p) {
        wavelet.mean[p] = (float)random_unit(&random);
        for (uint32_t b = 0; b < bands; ++b) wavelet.weight[b][p] = (float)(0.2 * random_unit(&random));
        if (knots > 0) set_random_tones(&wavelet, p, &random);
    }
    return wavelet;
}

weft_model *new_wavelet(weft_context *context, const weft_wavelet *wavelet)
{
    weft_model *model = NULL;
    assert_ok(weft_model_from_wavelet(context, wavelet, &model));
    assert_non_null(model);
    return model;
}
