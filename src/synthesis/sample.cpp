/// Points: turned into batches of spots, and the spots' results into colours.
#include "base/error.h"
#include "synthesis/footprint.h"
#include "synthesis/texture.h"
#include <algorithm>
#include <cmath>

namespace weft {

namespace {

constexpr char function[] = "weft_texture_sample";

[[noreturn]] void refuse(std::size_t i, const weft_point& point)
{
    const bool x = std::abs(point.x) < most_coordinate, y = std::abs(point.y) < most_coordinate;
    if (!x || !y)
        throw Error(WEFT_ERROR_ARGUMENT, function, ": points[", i, "].", x ? "y is " : "x is ", x ? point.y : point.x,
                    ", not within 2^52");
    throw Error(WEFT_ERROR_ARGUMENT, function, ": points[", i, "].dx or .dy is not finite");
}

/// Fills one batch after another from a row of points.
class Batches {
public:
    Batches(const Opened& opened, const Scratch& scratch, std::uint32_t channels) noexcept
        : opened_(opened), scratch_(scratch), channels_(channels)
    {
    }

    /// Samples as many of the points as one batch takes, and returns how many.
    std::size_t run(std::size_t count, const weft_point* points, float* out)
    {
        std::size_t taken = 0;
        std::uint32_t spots = 0;
        while (taken < count && taken < scratch_.capacity && spots + most_probes <= scratch_.capacity) {
            const std::uint32_t probes = make_spots(points[taken], scratch_.spots + spots);
            scratch_.probes[taken++] = static_cast<std::uint8_t>(probes);
            spots += probes;
        }
        const bool direct = spots == taken;
        const weft_batch batch{sizeof(weft_batch), spots, scratch_.spots, nullptr, direct ? out : scratch_.results};
        opened_.sample(batch, function);
        if (!direct) average(taken, out);
        return taken;
    }

private:
    void average(std::size_t count, float* out) const noexcept
    {
        const float* result = scratch_.results;
        for (std::size_t i = 0; i < count; ++i, out += channels_) {
            const std::uint32_t probes = scratch_.probes[i];
            std::copy_n(result, channels_, out);
            for (std::uint32_t k = 1; k < probes; ++k)
                for (std::uint32_t c = 0; c < channels_; ++c) out[c] += result[std::size_t{k} * channels_ + c];
            result += std::size_t{probes} * channels_;
            if (probes > 1)
                for (std::uint32_t c = 0; c < channels_; ++c) out[c] *= 1.0F / static_cast<float>(probes);
        }
    }

    const Opened& opened_;
    const Scratch scratch_;
    const std::uint32_t channels_;
};

} // namespace

void Texture::sample(std::size_t count, const weft_point* points, float* out) const
{
    require(count == 0 || points, function, ": points is NULL");
    require(count == 0 || out, function, ": out is NULL");
    for (std::size_t i = 0; i < count; ++i)
        if (!is_good(points[i])) refuse(i, points[i]);
    Room room(scratch_, count + most_probes); // a point may make so many
    Batches batches(points_, room.scratch(), channels());
    while (count > 0) {
        const std::size_t done = batches.run(count, points, out);
        count -= done;
        points += done;
        out += done * channels();
    }
}

} // namespace weft
