/// weft_histogram.
#include "analysis/measures.h"
#include "base/image.h"
#include <algorithm>

namespace weft {

void histogram(Core& core, const weft_image& image, float low, float high, std::uint32_t bins, std::uint64_t* counts)
{
    const Planes planes = read_image(image, &core.memory, core.parallel, "weft_histogram", "image");
    const double origin = static_cast<double>(low), bins_per_unit = bins / (static_cast<double>(high) - origin);
    core.parallel.for_each_index(planes.count, [&](std::uint32_t c) {
        std::uint64_t* channel = counts + std::size_t{c} * bins;
        std::fill_n(channel, bins, std::uint64_t{0});
        for (std::size_t i = 0; i < planes.area(); ++i) {
            const double bin = (static_cast<double>(planes.plane(c)[i]) - origin) * bins_per_unit;
            ++channel[bin <= 0 ? 0 : bin >= bins ? bins - 1 : static_cast<std::uint32_t>(bin)];
        }
    });
}

} // namespace weft
