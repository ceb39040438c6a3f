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

/// Each channel moves by what its equalised responses add to it.
void equalise_orientations(Core& core, Planes& planes, const Neighbourhoods& around, const Progress& progress)
{
    Planes responses(&core.memory, planes.width, planes.height, orientations);
    Planes even(&core.memory, planes.width, planes.height, orientations);
    for (std::uint32_t c = 0; c < planes.count; ++c) {
        const Progress share = progress.part(static_cast<double>(c) / planes.count, (c + 1.0) / planes.count);
        steerable_responses(core, planes, c, responses, share.part(0, 0.3));
        std::copy(responses.values.begin(), responses.values.end(), even.values.begin());
        equalise(core, even, around, 0, share.part(0.3, 0.7));
        for (std::size_t i = 0; i < even.values.size(); ++i) even.values[i] -= responses.values[i];
        add_steerable(core, even, planes, c, share.part(0.7, 1));
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
