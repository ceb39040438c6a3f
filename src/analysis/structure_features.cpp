/// Colours along their own principal axes, then with the masks along common ones, of which the four longest are kept.
#include "analysis/structure_features.h"
#include "analysis/principal_axes.h"
#include "analysis/spectra.h"
#include "analysis/statistics.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr std::uint32_t kept = 4, most_colours = 9;
constexpr double mask_weight = 0.25;    ///< of the masks' total deviation, against that of the colours
constexpr double least_variance = 1e-9; ///< of values whose deviation was brought to about 1: rounding

/// Planes [first, first + count) along at most `most` of their principal axes, their variances adding up to `total`.
Planes along_axes(Core& core, const Planes& planes, std::uint32_t first, std::uint32_t count, std::uint32_t most,
                  double total)
{
    Planes own(&core.memory, planes.width, planes.height, count, Array<float>::unset);
    std::copy_n(planes.plane(first), own.values.size(), own.values.data());
    centre(core, own);
    const Principal_axes axes = principal_axes_of(core, own);
    double variance = 0;
    for (std::uint32_t p = 0; p < count; ++p) variance += axes.variance[p];
    if (variance < least_variance) return Planes();
    Planes result(&core.memory, planes.width, planes.height, std::min(count, most), Array<float>::unset);
    const auto factor = static_cast<float>(std::sqrt(total / variance));
    for (std::uint32_t p = 0; p < result.count; ++p) {
        project_on_axis(core, own, axes.axes, p, result.plane(p));
        float* plane = result.plane(p);
        for (std::size_t i = 0; i < result.area(); ++i) plane[i] *= factor;
    }
    return result;
}

} // namespace

Features features_of(Core& core, std::uint32_t channels, const Planes& structure)
{
    const std::uint32_t masks = structure.count - channels;
    Planes parts[2];
    if (channels) parts[0] = along_axes(core, structure, 0, channels, most_colours, 1);
    if (masks) parts[1] = along_axes(core, structure, channels, masks, masks, mask_weight * mask_weight);
    Planes joined(&core.memory, structure.width, structure.height, parts[0].count + parts[1].count,
                  Array<float>::unset);
    if (joined.count == 0) return Features();
    std::copy(parts[0].values.begin(), parts[0].values.end(), joined.values.begin());
    std::copy(parts[1].values.begin(), parts[1].values.end(), joined.plane(parts[0].count));
    const Planes axes = along_axes(core, joined, 0, joined.count, kept, 0.5); // of two random pixels: twice that
    Features features(&core.memory, structure.width, structure.height);
    for (std::uint32_t c = 0; c < axes.count; ++c)
        for (std::size_t i = 0; i < axes.area(); ++i) features.pixels[i].value[c] = axes.plane(c)[i];
    return features;
}

Features halved(Core& core, const Features& features)
{
    Features half(&core.memory, features.width / 2, features.height / 2);
    for_each_run(core.parallel, half.height, [&](std::uint32_t first, std::uint32_t last) {
        for (std::size_t y = first; y < last; ++y)
            for (std::size_t x = 0; x < half.width; ++x)
                half.at(x, y) =
                    lerp(lerp(features.at(2 * x, 2 * y), features.at(2 * x + 1, 2 * y), 0.5f),
                         lerp(features.at(2 * x, 2 * y + 1), features.at(2 * x + 1, 2 * y + 1), 0.5f), 0.5f);
    });
    return half;
}

Features blurred(Core& core, const Features& features, float amount)
{
    Features across(&core.memory, features.width, features.height),
        result(&core.memory, features.width, features.height);
    const auto tent = [amount](const Feature& before, const Feature& here, const Feature& after) {
        return lerp(here, lerp(before, after, 0.5f), amount);
    };
    for_each_run(core.parallel, features.height, [&](std::uint32_t first, std::uint32_t last) {
        for (std::size_t y = first; y < last; ++y)
            for (std::size_t x = 0; x < features.width; ++x)
                across.at(x, y) = tent(features.at(x > 0 ? x - 1 : x, y), features.at(x, y),
                                       features.at(std::min<std::size_t>(x + 1, features.width - 1), y));
    });
    for_each_run(core.parallel, features.height, [&](std::uint32_t first, std::uint32_t last) {
        for (std::size_t y = first; y < last; ++y)
            for (std::size_t x = 0; x < features.width; ++x)
                result.at(x, y) = tent(across.at(x, y > 0 ? y - 1 : y), across.at(x, y),
                                       across.at(x, std::min<std::size_t>(y + 1, features.height - 1)));
    });
    return result;
}

} // namespace weft
