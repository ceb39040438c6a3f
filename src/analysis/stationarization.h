/// Texture stationarization (Moritz et al. 2017): a photo becomes a tile that repeats without a seam, and without a
/// part that differs from the rest.
#pragma once
#include "base/array.h"
#include "base/core.h"
#include "base/progress.h"

namespace weft {

enum class Stationarity_measure { histogram, moments, steerable, none };
enum class Start_scale { fine, coarse }; ///< synthesis starts at 1/4 or at 1/8 of the tile

/// Where synthesis stands, for whoever wants to watch.
struct Stationarization_state {
    std::uint32_t level, levels, iteration, iterations; ///< counted from 0
    std::uint32_t width, height;                        ///< of the tile at this level
    double texture_cost;                                ///< squared Lab distance to the photo, mean of a patch's pixels
};

struct Stationarization_options {
    std::uint32_t width = 256, height = 256; ///< 64..2048
    Stationarity_measure measure = Stationarity_measure::histogram;
    std::uint32_t moments = 2;             ///< 1..4: the highest that `moments` equalises
    float sigma = 0;                       ///< of the neighbourhood, of the tile's shorter side; 0: 0.1
    const weft_image* sigma_map = nullptr; ///< in place of `sigma`: F32, one channel, any size, stretched over the tile
    Start_scale start = Start_scale::fine;
    std::uint32_t patch_side = 0; ///< odd, 3..31; 0: 11
    std::uint64_t seed = 0;
    void (*observe)(void* user, const Stationarization_state&) = nullptr; ///< on the calling thread, every iteration
    void* observer = nullptr;
};

/// For one pixel of the tile, the centre of the photo's patch that it was matched to, and the weight of its vote.
struct Match {
    std::uint16_t x, y;
    std::uint16_t weight; ///< 1..16
};

/// The correspondence between a tile and its photo: each pixel of the tile is the mean, by the votes' weights, of what
/// the patches around it propose.
struct Correspondence {
    std::uint32_t width = 0, height = 0;             ///< of the tile
    std::uint32_t photo_width = 0, photo_height = 0; ///< every patch lies within
    std::uint32_t patch_side = 0;
    Array<Match> matches; ///< row by row
};

struct Stationary_tile {
    Planes tile;           ///< all of the photo's channels, in its own encoding
    Correspondence origin; ///< reassemble() of the photo by it is the tile, bit for bit
    double texture_cost = 0;
};

/// The photo has 1..16 channels and 1 x 1 to 8192 x 8192 pixels, at least a patch: its first three channels are
/// compared as sRGB (the first alone if there are fewer), the others follow. Errors name `function`.
Stationary_tile stationarize(Core& core, const weft_image& photo, const Stationarization_options& options,
                             const char* function, const Progress& progress);

/// The tile that the correspondence makes of `map`, which is as large as the photo was: any channels, any format.
/// Throws if a value is not finite. Errors name `function` and the argument `map`.
Planes reassemble(Core& core, const Correspondence& origin, const weft_image& map, const char* function,
                  const Progress& progress);

} // namespace weft
