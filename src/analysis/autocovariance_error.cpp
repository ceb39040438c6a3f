/// Relative difference of the autocovariances at lags up to 32 pixels.
#include "analysis/compare_metrics.h"
#include "analysis/lag_covariance.h"
#include <algorithm>
#include <cmath>

namespace weft {

double autocovariance_error(Core& core, const Pair& pair, std::uint64_t seed, const Progress& progress)
{
    if (!pair.exemplar_varies) return undefined;
    const std::uint32_t side =
        std::min({pair.exemplar.width, pair.exemplar.height, pair.output.width, pair.output.height});
    const std::uint32_t reach = std::min(32u, side / 2);
    const double zero[most_channels] = {}; // the exemplar's mean in a pair
    const LagCovariance a = lag_covariance_of(core, pair.exemplar, zero, reach, seed, progress.part(0, 0.4));
    const LagCovariance b = lag_covariance_of(core, pair.output, pair.output_mean, reach, seed, progress.part(0.4, 1));
    double difference = 0, power = 0;
    const std::int64_t far = reach;
    for (std::uint32_t c = 0; c < pair.channels(); ++c)
        for (std::int64_t y = 0; y <= far; ++y)
            for (std::int64_t x = -far; x <= far; ++x) {
                const double weight = 1 - std::sqrt(static_cast<double>(x * x + y * y)) / (reach + 1.0);
                if (weight <= 0 || (y == 0 && x < 0)) continue; // the other half of the lags is the same
                const double times = x == 0 && y == 0 ? 1 : 2, u = a.values[a.index(c, x, y)],
                             v = b.values[b.index(c, x, y)];
                difference += times * weight * (v - u) * (v - u);
                power += times * weight * u * u;
            }
    return power > 0 ? std::sqrt(difference / power) : undefined;
}

} // namespace weft
