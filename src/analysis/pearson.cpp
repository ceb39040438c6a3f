/// Pearson's differential equation, log p' = -(x + c1) / (c0 + c1 x + c2 x^2), integrated from the mode to both sides
/// (Johnson and Kotz 1970, chapter 12).
#include "analysis/pearson.h"
#include "base/elementary.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr std::uint32_t substeps = 4; ///< of a bin

struct Pearson {
    double c0, c1, c2; ///< in standard deviations from the mean

    double root(double x) const noexcept { return c0 + x * (c1 + x * c2); }
    double slope(double x) const noexcept { return -(x + c1) / root(x); }
};

Pearson pearson_of(const Moments& moments, std::uint32_t order) noexcept
{
    const double most_skewness = 2;
    const double skewness = std::min(std::max(moments.skewness, -most_skewness), most_skewness);
    const double beta1 = skewness * skewness;
    // Below the first bound the mode is no maximum; beyond the second a fourth moment would not exist.
    const double least = 1.8 + 1.5 * beta1, most = 9 + 3 * beta1;
    const double beta2 = order == 3 ? 3 + 1.5 * beta1 : std::min(std::max(moments.kurtosis, least + 0.1), most);
    const double scale = 10 * beta2 - 12 * beta1 - 18;
    return {(4 * beta2 - 3 * beta1) / scale, skewness * (beta2 + 3) / scale, (2 * beta2 - 3 * beta1 - 6) / scale};
}

/// Adds the density on one side of the mode, up to where the distribution or the histogram ends.
void integrate(const Pearson& pearson, const Moments& moments, double direction, std::uint32_t count,
               float* bins) noexcept
{
    const double step = direction / (substeps * moments.deviation), mode = -pearson.c1;
    double at = moments.mean + mode * moments.deviation, fall = 0; // -log of the density
    for (double x = mode;; x += step, at += direction / substeps) {
        const double middle = x + step / 2, end = x + step;
        if (pearson.root(end) <= 1e-3 * pearson.c0 || fall > 40) return;
        const double drop = -step / 6 * (pearson.slope(x) + 4 * pearson.slope(middle) + pearson.slope(end));
        const double place = at + direction / (2 * substeps);
        if (direction > 0 ? place >= count : place < 0) return;
        if (place >= 0 && place < count)
            bins[static_cast<std::uint32_t>(place)] +=
                static_cast<float>(exponential_of_minus(std::min(std::max(fall + drop / 2, 0.0), 60.0)));
        fall += drop;
    }
}

} // namespace

Moments moments_of(const float* bins, std::uint32_t count) noexcept
{
    double mass = 0, mean = 0, power2 = 0, power3 = 0, power4 = 0;
    for (std::uint32_t b = 0; b < count; ++b) {
        mass += static_cast<double>(bins[b]);
        mean += static_cast<double>(bins[b]) * (b + 0.5);
    }
    mean /= mass;
    for (std::uint32_t b = 0; b < count; ++b) {
        const double d = b + 0.5 - mean, weight = static_cast<double>(bins[b]) / mass;
        power2 += weight * d * d;
        power3 += weight * d * d * d;
        power4 += weight * d * d * d * d;
    }
    const double deviation = std::sqrt(power2);
    if (power2 < 1e-9) return {mean, 0, 0, 3};
    return {mean, deviation, power3 / (power2 * deviation), power4 / (power2 * power2)};
}

void fit_pearson(const Moments& moments, std::uint32_t order, std::uint32_t count, float* bins) noexcept
{
    constexpr double least_deviation = 0.25; // of a bin: less than that cannot be told in bins
    std::fill_n(bins, count, 0.0f);
    const Moments wide{moments.mean, std::max(moments.deviation, least_deviation), moments.skewness, moments.kurtosis};
    const Pearson pearson = pearson_of(wide, order);
    integrate(pearson, wide, 1, count, bins);
    integrate(pearson, wide, -1, count, bins);
    float sum = 0;
    for (std::uint32_t b = 0; b < count; ++b) sum += bins[b];
    if (sum <= 0) { // all of it beyond the histogram's end, or narrower than a step
        bins[std::min(static_cast<std::uint32_t>(std::max(wide.mean, 0.0)), count - 1)] = 1;
        return;
    }
    for (std::uint32_t b = 0; b < count; ++b) bins[b] /= sum;
}

} // namespace weft
