/// The dual of the refinable quadratic B-spline, solved for numerically, from + - * / alone.
#include "synthesis/wavelet_filters.h"

namespace weft {

namespace {

constexpr int circle = 64; ///< coarse coefficients: the dual has faded to 1e-11 at half of them
constexpr double mask[4] = {0.25, 0.75, 0.75, 0.25};                                      ///< at offsets -2..1 of 2k
constexpr double product[5] = {1.0 / 120, 26.0 / 120, 66.0 / 120, 26.0 / 120, 1.0 / 120}; ///< of splines at lags -2..2

/// The inverse of the products of coarse splines, which are twice those of fine ones: x with sum_l 2 product(k - l)
/// x(l) = [k = 0]. Jacobi's iteration: the middle is 66, the others sum up to 54.
struct Inverse {
    Inverse() noexcept
    {
        double next[circle];
        for (double& value : x) value = 0;
        for (int iteration = 0; iteration < 250; ++iteration) {
            for (int k = 0; k < circle; ++k) {
                double rest = k == 0 ? 0.5 : 0.0;
                for (int lag = 1; lag <= 2; ++lag) rest -= product[2 + lag] * (at(k - lag) + at(k + lag));
                next[k] = rest / product[2];
            }
            for (int k = 0; k < circle; ++k) x[k] = next[k];
        }
    }
    double at(int k) const noexcept { return x[(k + circle) % circle]; }
    double x[circle];
};

/// The product of the coarse spline at 0 with the fine one at i.
double coarse_with_fine(int i) noexcept
{
    double sum = 0;
    for (int d = -2; d <= 1; ++d)
        if (i - d >= -2 && i - d <= 2) sum += mask[d + 2] * product[i - d + 2];
    return sum;
}

} // namespace

Wavelet_filters::Wavelet_filters() noexcept : analysis{-16, 32, {}}, refinement{-1, 4, {}}, low_pass{-17, 35, {}}
{
    const Inverse inverse;
    double dual[32], sum = 0, both[35] = {};
    for (int j = 0; j < 32; ++j) {
        dual[j] = 0;
        for (int l = -16; l <= 16; ++l) dual[j] += inverse.at(l) * coarse_with_fine(j - 16 - 2 * l);
        sum += dual[j];
    }
    for (int j = 0; j < 32; ++j) {
        dual[j] /= sum; // constants stay exactly what they are, though the tails are cut off
        analysis.value[j] = static_cast<float>(dual[j]);
        for (int d = -2; d <= 1; ++d) both[(j - 16) - d + 17] += 0.5 * mask[d + 2] * dual[j];
    }
    for (int j = 0; j < 4; ++j) refinement.value[j] = static_cast<float>(mask[j]);
    for (int j = 0; j < 35; ++j) low_pass.value[j] = static_cast<float>(both[j]);
}

Taps spline_overlap(std::uint32_t log2) noexcept
{
    double overlap[3] = {product[2], product[3], product[4]};
    if (log2 <= most_parts_log2) {
        const int parts = 1 << log2;
        overlap[0] = overlap[1] = overlap[2] = 0;
        for (int i = 0; i < parts; ++i) {
            const double t = (i + 0.5) / parts, s = 1 - t, a = 0.5 * s * s, c = 0.5 * t * t, b = 1 - (a + c);
            overlap[0] += (a * a + b * b + c * c) / parts;
            overlap[1] += (a * b + b * c) / parts;
            overlap[2] += a * c / parts;
        }
    }
    Taps taps{-2, 5, {}};
    for (int k = -2; k <= 2; ++k) taps.value[k + 2] = static_cast<float>(overlap[k < 0 ? -k : k]);
    return taps;
}

} // namespace weft
