/// The measures as they act on the channels of a tile, or on their sub-bands.
#include "analysis/stationarity_projection.h"
#include "analysis/compare_pair.h"
#include "analysis/local_curves.h"
#include "analysis/steerable.h"
#include <algorithm>

namespace weft {
namespace {

void read(Core& core, const Lab_picture& tile, Planes& planes)
{
    core.parallel.for_each_index(tile.height, [&](std::uint32_t y) {
        const std::int16_t* row = tile.at(0, y);
        for (std::uint32_t c = 0; c < tile.channels; ++c)
            for (std::uint32_t x = 0; x < tile.width; ++x) planes.row(c, y)[x] = row[x * tile.channels + c];
    });
}

void write(Core& core, const Planes& planes, Lab_picture& tile)
{
    constexpr float bound = lab_bound, upwards = lab_bound + 1.5f;
    core.parallel.for_each_index(tile.height, [&](std::uint32_t y) {
        std::int16_t* row = tile.at(0, y);
        for (std::uint32_t c = 0; c < tile.channels; ++c)
            for (std::uint32_t x = 0; x < tile.width; ++x) {
                const float value = std::min(std::max(planes.row(c, y)[x], -bound), bound);
                row[x * tile.channels + c] =
                    static_cast<std::int16_t>(static_cast<int>(value + upwards) - (lab_bound + 1));
            }
    });
}

/// Each channel is taken apart into its responses and what they leave; both are equalised, and put together again.
/// Without the rest, large stains would stay: no response sees them.
void equalise_orientations(Core& core, Planes& planes, const Neighbourhoods& around, const Progress& progress)
{
    Planes responses(&core.memory, planes.width, planes.height, orientations);
    Planes rest(&core.memory, planes.width, planes.height, 1, Array<float>::unset);
    for (std::uint32_t c = 0; c < planes.count; ++c) {
        const Progress share = progress.part(static_cast<double>(c) / planes.count, (c + 1.0) / planes.count);
        std::copy_n(planes.plane(c), planes.area(), rest.plane(0));
        steerable_responses(core, planes, c, responses, share.part(0, 0.2));
        for (float& value : responses.values) value = -value;
        add_steerable(core, responses, rest, 0, share.part(0.2, 0.4));
        for (float& value : responses.values) value = -value;
        equalise(core, rest, around, 0, share.part(0.4, 0.5));
        equalise(core, responses, around, 0, share.part(0.5, 0.8));
        add_steerable(core, responses, rest, 0, share.part(0.8, 1));
        std::copy_n(rest.plane(0), planes.area(), planes.plane(c));
    }
}

} // namespace

void project(Core& core, const Neighbourhoods& around, weft_stationarity measure, std::uint32_t moments,
             Lab_picture& tile, const Progress& progress)
{
    Planes planes(&core.memory, tile.width, tile.height, tile.channels, Array<float>::unset);
    read(core, tile, planes);
    if (measure == WEFT_STATIONARITY_STEERABLE)
        equalise_orientations(core, planes, around, progress);
    else
        equalise(core, planes, around, measure == WEFT_STATIONARITY_MOMENTS ? moments : 0, progress);
    write(core, planes, tile);
}

} // namespace weft
