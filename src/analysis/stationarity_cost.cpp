/// All pairs without looking at pairs: sums of |a - b| come from sorted values, sums of (a - b)^2 from two moments.
#include "analysis/stationarity_cost.h"
#include "analysis/lab_planes.h"
#include "analysis/local_sums.h"
#include "analysis/steerable.h"
#include "base/image.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace weft {
namespace {

constexpr const char* function = "weft_stationarity_cost";
constexpr std::uint32_t values = 64;       ///< of a histogram
constexpr std::uint32_t usual_places = 32; ///< of the grid, along the shorter side

Local_grid usual_grid(std::uint32_t width, std::uint32_t height) noexcept
{
    const std::uint32_t shorter = std::min(width, height), least = std::min(shorter, usual_places);
    const auto places = [&](std::uint32_t side) {
        return static_cast<std::uint32_t>((std::uint64_t{side} * least + shorter / 2) / shorter);
    };
    return {places(width), places(height)};
}

/// Adds to each place's `cost` the mean of |own value - value there| over all places, times `scale`.
void add_mean_differences(const Array<double>& descriptors, std::uint32_t size, std::uint32_t component, double scale,
                          Array<std::uint32_t>& order, Array<double>& cost)
{
    const auto value = [&](std::uint32_t place) { return descriptors[std::size_t{place} * size + component]; };
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return value(a) < value(b) || (!(value(b) < value(a)) && a < b);
    });
    double total = 0, below = 0;
    for (const std::uint32_t place : order) total += value(place);
    const auto count = static_cast<double>(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const double own = value(order[i]), lower = static_cast<double>(i);
        cost[order[i]] += scale * ((own * lower - below) + (total - below - own * (count - lower))) / count;
        below += own;
    }
}

/// Everything that a measurement of one image shares.
struct Measurement {
    Core& core;
    const weft_stationarity_options& options;
    Local_grid grid;
    double sigma; ///< in pixels
    Array<double> cost;
    Array<std::uint32_t> order;

    void add_histograms(const float* plane, std::uint32_t width, std::uint32_t height, const Progress& progress)
    {
        const auto [least, most] = std::minmax_element(plane, plane + std::size_t{width} * height);
        const double low = static_cast<double>(*least), step = (static_cast<double>(*most) - low) / (values - 1);
        if (!(step > 0)) return;
        const auto share_of = [&](float value) {
            const double place = (static_cast<double>(value) - low) / step;
            const std::uint32_t i = std::min(static_cast<std::uint32_t>(place), values - 2);
            return Share{2, {i, i + 1}, {i + 1 - place, place - i}};
        };
        Array<double> local = local_sums(core, plane, width, height, grid, sigma, values, share_of, progress);
        for (std::size_t place = 0; place < grid.count(); ++place) // the earth mover's distance is that of the sums
            for (std::uint32_t i = 1; i < values; ++i) local[place * values + i] += local[place * values + i - 1];
        for (std::uint32_t i = 0; i < values - 1; ++i) add_mean_differences(local, values, i, step, order, cost);
    }

    void add_moments(const float* plane, std::uint32_t width, std::uint32_t height, const Progress& progress)
    {
        double mean = 0;
        for (std::size_t i = 0; i < std::size_t{width} * height; ++i) mean += static_cast<double>(plane[i]);
        mean /= static_cast<double>(width) * height;
        const auto share_of = [&](float value) {
            const double d = static_cast<double>(value) - mean;
            return Share{options.moments, {0, 1, 2, 3}, {d, d * d, d * d * d, d * d * d * d}};
        };
        Array<double> local = local_sums(core, plane, width, height, grid, sigma, options.moments, share_of, progress);
        for (std::size_t place = 0; place < grid.count(); ++place) central_roots(&local[place * options.moments]);
        for (std::uint32_t k = 0; k < options.moments; ++k) add_mean_squares(local, k);
    }

private:
    /// Moments about a common mean become the mean, and roots of those about the own one.
    void central_roots(double* m) const noexcept
    {
        const double mean = m[0], square = mean * mean;
        if (options.moments >= 4)
            m[3] =
                std::sqrt(std::sqrt(std::max(m[3] - 4 * mean * m[2] + 6 * square * m[1] - 3 * square * square, 0.0)));
        if (options.moments >= 3) m[2] = std::cbrt(m[2] - 3 * mean * m[1] + 2 * mean * square);
        if (options.moments >= 2) m[1] = std::sqrt(std::max(m[1] - square, 0.0));
    }

    void add_mean_squares(const Array<double>& descriptors, std::uint32_t component)
    {
        const std::size_t size = options.moments;
        const auto count = static_cast<double>(grid.count());
        double mean = 0, variance = 0;
        for (std::size_t i = 0; i < grid.count(); ++i) mean += descriptors[i * size + component] / count;
        for (std::size_t i = 0; i < grid.count(); ++i) {
            const double d = descriptors[i * size + component] - mean;
            variance += d * d / count;
            cost[i] += d * d;
        }
        for (double& each : cost) each += variance;
    }
};

} // namespace

float stationarity_cost(Core& core, const weft_image& image, const weft_stationarity_options& options,
                        const Progress& progress, const weft_image* map)
{
    progress.at(0);
    const Planes lab = lab_planes(core, image, function, "image");
    const std::uint32_t width = lab.width, height = lab.height;
    const Local_grid grid = map ? Local_grid{map->width, map->height} : usual_grid(width, height);
    const double sigma = static_cast<double>(options.sigma) * std::min(width, height);
    Measurement measurement{core,
                            options,
                            grid,
                            sigma,
                            Array<double>(&core.memory, grid.count()),
                            Array<std::uint32_t>(&core.memory, grid.count(), Array<std::uint32_t>::unset)};
    for (std::uint32_t c = 0; c < lab.count; ++c) {
        const Progress part = progress.part(static_cast<double>(c) / lab.count, (c + 1.0) / lab.count);
        if (options.stationarity == WEFT_STATIONARITY_HISTOGRAM) {
            measurement.add_histograms(lab.plane(c), width, height, part);
        } else if (options.stationarity == WEFT_STATIONARITY_MOMENTS) {
            measurement.add_moments(lab.plane(c), width, height, part);
        } else {
            Planes bands(&core.memory, width, height, orientations, Array<float>::unset);
            steerable_responses(core, lab, c, bands, part.part(0, 0.5));
            for (std::uint32_t o = 0; o < bands.count; ++o)
                measurement.add_histograms(bands.plane(o), width, height,
                                           part.part(0.5 + 0.5 * o / bands.count, 0.5 + 0.5 * (o + 1) / bands.count));
        }
    }
    double sum = 0;
    Planes result(&core.memory, grid.columns, grid.rows, 1, Array<float>::unset);
    for (std::size_t i = 0; i < grid.count(); ++i) {
        sum += measurement.cost[i];
        result.values[i] = static_cast<float>(measurement.cost[i]);
    }
    progress.at(1);
    if (map) write_window(*map, 0, 0, grid.columns, grid.rows, result.plane(0), grid.columns, grid.rows);
    return static_cast<float>(sum / static_cast<double>(grid.count()));
}

} // namespace weft
