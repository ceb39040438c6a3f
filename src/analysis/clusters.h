/// K-means of local spectra (Guingo et al. 2017, section 3.3): the same on every machine and with every number of
/// threads.
#pragma once
#include "analysis/local_spectrum.h"

namespace weft {

constexpr std::uint32_t most_clusters = 6;

struct Clusters {
    std::uint32_t count = 0, size = 0;
    Array<float> centres; ///< count * size, that of the cluster with most pixels first

    const float* centre(std::size_t k) const noexcept { return centres.data() + k * size; }
};

/// At most `count` clusters, fewer if there are not as many different spectra. 0: as many as are told apart.
Clusters find_clusters(Core& core, const Local_spectra& spectra, std::uint32_t count, std::uint64_t seed,
                       const Progress& progress);

} // namespace weft
