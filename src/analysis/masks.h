/// Which noise is where: masks, the cluster of every pixel, and how near it is.
#pragma once
#include "analysis/clusters.h"

namespace weft {

constexpr std::uint8_t no_cluster = 255;

struct Regions {
    Planes masks;                ///< one per cluster, convex; 0 in the band along borders
    Array<std::uint8_t> nearest; ///< of each pixel: the cluster, or no_cluster in that band
    Array<float> distance;       ///< to its centre
};

/// Masks are 1 for the nearest centre, else 0; or in the ratio of the inverse distances to all centres, so that on the
/// line between two of them the weights are those that make up the point.
Regions regions_of(Core& core, const Local_spectra& spectra, const Clusters& clusters, bool barycentric,
                   const Progress& progress);

/// Takes the pixels within `border` pixels of another cluster's out of all clusters.
void clear_borders(Core& core, std::uint32_t border, Regions& regions, const Progress& progress);

/// `region` <- 1 for the `share` of cluster k's pixels that are nearest to its centre.
void nearest_share(Core& core, const Regions& regions, std::uint32_t k, double share, Array<float>& region);

} // namespace weft
