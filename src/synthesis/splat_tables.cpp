/// Kernels, cells and offsets of SPLAT layers.
#include "synthesis/splat_tables.h"
#include "synthesis/grid.h"
#include "synthesis/poisson.h"
#include <algorithm>
#include <cmath>

namespace weft {

std::uint32_t Splat_tables::make(Core& core, const Splat_source& source, const Splat_kernels& kernels,
                                 std::uint32_t period_x, std::uint32_t period_y)
{
    const Planes& alpha = source.coefficients;
    const double shares = std::max(1.0, std::ceil(kernels.rate / most_mean)), share = kernels.rate / shares;
    make_texton_mips(mips_, source, kernels.scale, kernels.rate, kernels.levels, &core.memory, core.parallel);

    splat.size = sizeof splat;
    splat.taps = source.taps;
    const double width = alpha.width + source.taps, height = alpha.height + source.taps;
    splat.cell_log2 = kernels.axes == 2 ? choose_cell_log2(share, width, height, period_x, period_y)
                                        : choose_cell_log2_in_space(share, std::max(width, height));
    const double edge = static_cast<double>(1U << splat.cell_log2), area = edge * edge;
    counts_ = poisson_thresholds(&core.memory, share * (kernels.axes == 2 ? area : area * edge));
    splat.counts = counts_.data();
    splat.count_limit = static_cast<std::uint32_t>(counts_.size());
    splat.signs = kernels.signs ? 1 : 0;
    splat.choice = nobody;
    splat.textons = &mips_.mips;
    splat.offset = offset_;
    for (std::uint32_t c = 0; c < alpha.count / source.stored; ++c) {
        double sum = 0;
        for (std::size_t i = 0; i < alpha.area(); ++i) sum += static_cast<double>(mips_.own[0].plane(c)[i]);
        offset_[c] = kernels.signs ? 0.0F : static_cast<float>(-(share * kernels.mean * sum)) + 0.0F; // never -0
    }
    return static_cast<std::uint32_t>(shares);
}

} // namespace weft
