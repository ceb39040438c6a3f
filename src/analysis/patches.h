/// Samples of a picture's 7 x 7 patches, and the directions along which the exemplar's patches are white.
#pragma once
#include "analysis/compare_pair.h"
#include "analysis/wasserstein.h"

namespace weft {

constexpr std::size_t patch_side = 7, patch_size = patch_side * patch_side;

/// Patches of one channel at one level, their own mean taken off: 49 rows, one column a patch. A patch of level l is
/// made of 7 x 7 means of 2^l x 2^l pixels and begins at any pixel.
struct Patches {
    std::size_t count = 0;
    Array<float> values;

    const float* row(std::size_t component) const noexcept { return values.data() + component * count; }
};

/// How many patches of that level lie in the picture.
std::uint64_t patches_in(const Planes& planes, std::uint32_t level) noexcept;

Patches sample_patches(Core& core, const Planes& planes, std::uint32_t channel, std::uint32_t level, std::uint64_t seed,
                       const Progress& progress);

/// Row d: what each of the 49 components counts along direction d. Directions are uniform on the sphere after whitening
/// by the patches' principal components; those below 1e-4 of the greatest are left out. Empty if nothing is left.
Array<float> white_directions(Core& core, const Patches& patches, std::uint32_t directions, std::uint64_t seed,
                              const Progress& progress);

} // namespace weft
