/* Sums over all pairs of coefficients, in double, as the formula has them. */
#include "covariance.h"

double spline_autocorrelation(weft_interpolation interpolation, int k)
{
    static const double cubic[] = {2416, 1191, 120, 1}, quintic[] = {15724248, 9738114, 2203488, 152637, 2036, 1};
    const int lag = k < 0 ? -k : k;
    switch (interpolation) {
    case WEFT_INTERPOLATION_NEAREST: return lag == 0;
    case WEFT_INTERPOLATION_CUBIC: return lag < 4 ? cubic[lag] / 5040 : 0;
    case WEFT_INTERPOLATION_QUINTIC: return lag < 6 ? quintic[lag] / 39916800 : 0;
    default: return lag == 0 ? 2.0 / 3 : lag == 1 ? 1.0 / 6 : 0;
    }
}

static double coefficient_correlation(const weft_image *texton, uint32_t a, uint32_t b, int dx, int dy)
{
    const int width = (int)texton->width, height = (int)texton->height;
    double sum = 0;
    for (int y = dy < 0 ? -dy : 0; y < height && y + dy < height; ++y)
        for (int x = dx < 0 ? -dx : 0; x < width && x + dx < width; ++x)
            sum += (double)value_at(texton, (uint32_t)x, (uint32_t)y, a) *
                   (double)value_at(texton, (uint32_t)(x + dx), (uint32_t)(y + dy), b);
    return sum;
}

double noise_covariance(const weft_image *texton, weft_interpolation interpolation, uint32_t a, uint32_t b, int dx,
                        int dy)
{
    double sum = 0;
    for (int j = -5; j <= 5; ++j)
        for (int i = -5; i <= 5; ++i) {
            const double weight = spline_autocorrelation(interpolation, i) * spline_autocorrelation(interpolation, j);
            if (weight != 0) sum += weight * coefficient_correlation(texton, a, b, dx - i, dy - j);
        }
    return sum;
}
