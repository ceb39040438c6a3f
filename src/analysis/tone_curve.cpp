/// Ranks of a sample of pixels, and knots placed greedily where the curve is furthest from them.
#include "analysis/tone_curve.h"
#include "analysis/spectra.h"
#include "analysis/wasserstein.h"
#include "model/tone.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr std::uint64_t most_samples = 1U << 16;
constexpr std::uint32_t most_entries = 1024; ///< of the table of scores
constexpr std::uint32_t hints = 2048;        ///< equal intervals of values, each of which knows where its entries begin
constexpr double farthest_score = 4.5;
constexpr double farthest_knot = 3.5; ///< beyond are 5 of 10000 pixels
constexpr std::uint32_t grid = 256;   ///< intervals between the first and the last knot, at whose ends knots may be

double normal_distribution(double x) noexcept { return 0.5 * std::erfc(-x * 0.7071067811865476); }

double normal_quantile(double probability) noexcept
{
    double low = -farthest_score, high = farthest_score;
    for (int i = 0; i < 32; ++i) {
        const double middle = 0.5 * (low + high);
        (normal_distribution(middle) < probability ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// The knots while they are placed: places on the grid, ascending.
struct Knots {
    std::uint32_t count = 0;
    std::uint32_t place[most_knots];
    double x[most_knots], y[most_knots], slope[most_knots];

    double at(double v) const noexcept
    {
        std::uint32_t k = 0;
        while (k + 2 < count && v >= x[k + 1]) ++k;
        const double width = x[k + 1] - x[k], t = (v - x[k]) / width, s = 1 - t;
        return s * s * ((1 + 2 * t) * y[k] + t * width * slope[k]) +
               t * t * ((1 + 2 * s) * y[k + 1] - s * width * slope[k + 1]);
    }
    void insert(std::uint32_t at_place, double at_x, double at_y) noexcept
    {
        std::uint32_t k = count++;
        for (; k > 0 && place[k - 1] > at_place; --k) place[k] = place[k - 1], x[k] = x[k - 1], y[k] = y[k - 1];
        place[k] = at_place, x[k] = at_x, y[k] = at_y;
        if (count > 1) monotone_slopes(x, y, count, slope);
    }
};

/// The place where one more knot helps most. Errors count by the root of their density, but less steeply: tails are
/// seen.
std::uint32_t worst_place(const Knots& knots, const double* x, const double* y) noexcept
{
    double worst = -1;
    std::uint32_t place = 0;
    for (std::uint32_t i = 0, k = 0; i <= grid; ++i) {
        if (i == knots.place[k]) {
            ++k;
            continue;
        }
        const double error = std::abs(knots.at(x[i]) - y[i]) * std::exp(-x[i] * x[i] / 8);
        const std::uint32_t gap =
            std::min(i - knots.place[k - 1], knots.place[k] - i); // among equals, the middle of the widest gap
        const double worth = error + 1e-12 * gap;
        if (worth > worst) worst = worth, place = i;
    }
    return place;
}

} // namespace

Normal_scores::Normal_scores(Core& core, const float* values, std::size_t count)
{
    const Sample sample(count, most_samples, 0);
    const std::size_t n = sample.size();
    Array<float> sorted(&core.memory, n, Array<float>::unset), scratch(&core.memory, n, Array<float>::unset);
    for (std::size_t i = 0; i < n; ++i) sorted[i] = values[sample[i]];
    sort_floats(sorted.data(), scratch.data(), n);
    values_ = Array<float>(&core.memory, most_entries);
    scores_ = Array<float>(&core.memory, most_entries);
    for (std::uint32_t i = 0; i < most_entries; ++i) {
        const double score = farthest_score * (2.0 * i / (most_entries - 1) - 1);
        const float value =
            sorted[std::min(n - 1, static_cast<std::size_t>(normal_distribution(score) * static_cast<double>(n)))];
        if (size_ > 0 && value <= values_[size_ - 1]) continue;
        const auto equal = std::equal_range(sorted.begin(), sorted.end(), value);
        const double rank = 0.5 * static_cast<double>((equal.first - sorted.begin()) + (equal.second - sorted.begin()));
        values_[size_] = value;
        scores_[size_++] = static_cast<float>(normal_quantile(rank / static_cast<double>(n)));
    }
    hints_ = Array<std::uint32_t>(&core.memory, hints + 1);
    for (std::uint32_t i = 0, entry = 0; i <= hints; ++i) {
        while (entry + 1 < size_ && hint_of(values_[entry + 1]) < i) ++entry;
        hints_[i] = entry;
    }
}

std::uint32_t Normal_scores::hint_of(float value) const noexcept
{
    const float width = values_[size_ - 1] - values_[0], place = (value - values_[0]) / std::max(width, 1e-30f) * hints;
    return static_cast<std::uint32_t>(std::clamp(place, 0.0f, static_cast<float>(hints - 1)));
}

void Normal_scores::apply(Core& core, float* values, std::size_t count, float factor) const
{
    constexpr std::size_t step = 16384;
    for_each_run(core.parallel, static_cast<std::uint32_t>((count + step - 1) / step),
                 [&](std::uint32_t first, std::uint32_t last) {
                     for (std::size_t i = first * step; i < std::min(count, last * step); ++i) {
                         const float value = values[i];
                         const std::uint32_t hint = hint_of(value);
                         std::size_t low = hints_[hint];
                         for (std::size_t length = hints_[hint + 1] - low + 1; length > 1;
                              length -= length / 2) // the last entry not above, or the first
                             low += values_[low + length / 2] <= value ? length / 2 : 0;
                         const std::size_t high = std::min(low + 1, size_ - 1);
                         const float width = values_[high] - values_[low];
                         const float t = width > 0 ? std::clamp((value - values_[low]) / width, 0.0f, 1.0f) : 0.0f;
                         values[i] = factor * (scores_[low] + t * (scores_[high] - scores_[low]));
                     }
                 });
}

float Normal_scores::value_at(float score) const noexcept
{
    const float* begin = scores_.data();
    const std::size_t high = static_cast<std::size_t>(std::upper_bound(begin, begin + size_, score) - begin);
    if (high == 0 || high == size_) return values_[high == 0 ? 0 : size_ - 1];
    const float t = (score - begin[high - 1]) / (begin[high] - begin[high - 1]);
    return values_[high - 1] + t * (values_[high] - values_[high - 1]);
}

void monotone_slopes(const double* x, const double* y, std::uint32_t count, double* slope) noexcept
{
    double secant[most_knots] = {};
    for (std::uint32_t k = 0; k + 1 < count; ++k) secant[k] = (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
    slope[0] = secant[0];
    slope[count - 1] = secant[count - 2];
    for (std::uint32_t k = 1; k + 1 < count; ++k) { // of the parabola through three knots
        const double left = x[k] - x[k - 1], right = x[k + 1] - x[k];
        slope[k] = secant[k - 1] * secant[k] > 0 ? (secant[k - 1] * right + secant[k] * left) / (left + right) : 0;
    }
    for (std::uint32_t k = 0; k + 1 < count; ++k) { // within the circle of radius 3 the piece is monotone
        if (secant[k] == 0) {
            slope[k] = slope[k + 1] = 0;
            continue;
        }
        const double begin = slope[k] / secant[k], end = slope[k + 1] / secant[k],
                     length = std::sqrt(begin * begin + end * end);
        if (length <= 3) continue;
        slope[k] *= 3 / length;
        slope[k + 1] *= 3 / length;
    }
}

void fit_tone_curve(const Normal_scores& scores, double unit, double deviation, double wanted, std::uint32_t axis,
                    Colour_axes& tones) noexcept
{
    const double low = std::max(-farthest_knot, std::min(static_cast<double>(scores.least_score()), -1.0));
    const double high = std::min(farthest_knot, std::max(static_cast<double>(scores.greatest_score()), 1.0));
    double x[grid + 1], y[grid + 1];
    for (std::uint32_t i = 0; i <= grid; ++i) {
        x[i] = low + (high - low) * i / grid;
        y[i] = static_cast<double>(scores.value_at(static_cast<float>(x[i])));
    }
    Knots knots;
    knots.insert(0, x[0], y[0]);
    knots.insert(grid, x[grid], y[grid]);
    while (knots.count < tones.knots) {
        const std::uint32_t place = worst_place(knots, x, y);
        knots.insert(place, x[place], y[place]);
    }
    const auto set = [&](double factor, double shift) {
        for (std::uint32_t k = 0; k < knots.count; ++k) {
            tones.knot_x[k][axis] = static_cast<float>(knots.x[k] * deviation);
            tones.knot_y[k][axis] = static_cast<float>(knots.y[k] * factor + shift);
            tones.knot_slope[k][axis] = static_cast<float>(knots.slope[k] * factor / deviation);
        }
    };
    set(1 / unit, 0);
    const Tone_moments moments = tone_moments(tones, axis, deviation * deviation);
    const double factor = moments.variance > 0 ? wanted / std::sqrt(moments.variance) : 1;
    set(factor / unit, -moments.mean * factor);
}

void set_flat_tone_curve(std::uint32_t axis, Colour_axes& tones) noexcept
{
    for (std::uint32_t k = 0; k < tones.knots; ++k) {
        tones.knot_x[k][axis] = static_cast<float>(k) - static_cast<float>(tones.knots - 1) / 2;
        tones.knot_y[k][axis] = tones.knot_slope[k][axis] = 0;
    }
}

} // namespace weft
