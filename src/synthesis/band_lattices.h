/// The lattices of a wavelet noise model for one seed, and the sizes that a period asks for.
#pragma once
#include "model/wavelet.h"
#include "synthesis/lattice.h"
#include <vector>
#include <weft/backend.h>

namespace weft {

/// Every axis of the model has a lattice of its own, which its bands share at hashed shifts: 256 x 256 coefficients in
/// the plane, 64 x 64 x 64 in space. With a period P a band's lattice is as large as a divisor of P / 2^b; where that
/// is odd, the band's lattice holds all coarser bands too. A band that a period is too short for is left out.
class Band_lattices {
public:
    Band_lattices(Core& core, const Wavelet& wavelet, std::uint32_t axes, std::uint64_t seed, std::uint32_t period_x,
                  std::uint32_t period_y);

    /// In space, without periods.
    Band_lattices(Core& core, const Wavelet& wavelet, std::uint32_t axes, std::uint64_t seed);

    const weft_bands& bands() const noexcept { return bands_; }

private:
    struct Plan;
    /// The last lattice that bands share, and its power in the middles of 2^parts_log2 parts of a cell.
    struct Shared {
        const Torus* lattice = nullptr;
        double power = 0;
        std::uint32_t parts_log2 = 0;
    };
    void share(Core& core, Shared& shared, const Sides& sides, std::uint64_t key, std::uint32_t parts_log2);
    void make(Core& core, const Wavelet& wavelet, std::uint32_t axis, std::uint64_t key, const Plan& plan);
    void make_all(Core& core, const Wavelet& wavelet, std::uint32_t axes, std::uint64_t seed, const Plan& plan);

    Wavelet_filters filters_;
    Array<weft_band> table_;
    std::pmr::vector<Torus> lattices_;
    weft_bands bands_{};
};

} // namespace weft
