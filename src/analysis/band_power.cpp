/// The power of a picture in octaves of max(|fx|, |fy|).
#include "analysis/band_power.h"
#include "analysis/periodic.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

/// How a frequency of the DFT, which stands for half a step to both sides, falls into octaves: first, first + 1, first
/// + 2.
struct Shares {
    std::uint32_t first;
    double share[3];
};

/// Of the frequencies 0 .. length / 2 of an axis; 0 is not used.
Array<Shares> shares_along(std::pmr::memory_resource* memory, std::uint32_t length, std::uint32_t octaves)
{
    Array<Shares> result(memory, length / 2 + 1);
    for (std::uint32_t k = 1; k < result.size(); ++k) {
        const double low = (k - 0.5) / length, high = std::min((k + 0.5) / length, 0.5);
        Shares& shares = result[k];
        while (std::ldexp(1.0, -2 - static_cast<int>(shares.first)) >= high) ++shares.first;
        for (std::uint32_t i = 0; i < 3; ++i) {
            const double top = std::ldexp(1.0, -1 - static_cast<int>(shares.first + i)), bottom = i < 2 ? top / 2 : 0;
            shares.share[i] = std::max(0.0, std::min(high, top) - std::max(low, bottom)) / (high - low);
        }
        if (shares.first + 2 < octaves) continue;
        for (std::uint32_t i = 2; i > 0; --i) // what lies below the last octave is the last one's
            if (shares.first + i >= octaves) {
                shares.share[i - 1] += shares.share[i];
                shares.share[i] = 0;
            }
        shares.first = std::min(shares.first, octaves - 1);
    }
    return result;
}

void add(Octaves& octaves, const Shares& shares, double power) noexcept
{
    for (std::uint32_t i = 0; i < 3; ++i)
        if (shares.share[i] != 0) octaves.power[shares.first + i] += shares.share[i] * power;
}

/// One block's share: each frequency belongs to the axis along which it is greater.
Octaves block_octaves(const Spectra& spectra, std::uint32_t b, const Array<Shares>& along_x,
                      const Array<Shares>& along_y)
{
    Octaves octaves;
    double columns[fft_lanes] = {};
    float weights[fft_lanes];
    for (std::uint32_t i = 0; i < fft_lanes; ++i) weights[i] = spectra.weight(b * fft_lanes + i);
    const float* values = reinterpret_cast<const float*>(spectra.block(b, 0));
    for (std::uint32_t y = 0; y < spectra.height; ++y, values += 2 * fft_lanes) {
        float power[fft_lanes];
        for (std::uint32_t i = 0; i < fft_lanes; ++i)
            power[i] = weights[i] * (values[2 * i] * values[2 * i] + values[2 * i + 1] * values[2 * i + 1]);
        const std::uint32_t k = std::min(y, spectra.height - y);
        const std::uint64_t of_axis =
            (std::uint64_t{k} * spectra.width + spectra.height - 1) / spectra.height; // columns with |fx| < |fy|
        const auto of_row = static_cast<std::uint32_t>(
            std::min<std::uint64_t>(fft_lanes, of_axis - std::min<std::uint64_t>(of_axis, b * fft_lanes)));
        double row = 0;
        for (std::uint32_t i = 0; i < of_row; ++i) row += static_cast<double>(power[i]);
        if (of_row > 0) add(octaves, along_y[k], row);
        for (std::uint32_t i = of_row; i < fft_lanes; ++i) columns[i] += static_cast<double>(power[i]);
    }
    for (std::uint32_t i = 0; i < fft_lanes; ++i)
        if (b * fft_lanes + i > 0 && b * fft_lanes + i < spectra.columns())
            add(octaves, along_x[b * fft_lanes + i], columns[i]);
    return octaves;
}

} // namespace

std::uint32_t octaves_in(std::uint32_t width, std::uint32_t height) noexcept
{
    const std::uint32_t side = std::max(width, height);
    std::uint32_t count = 1;
    while (count < most_bands && 4ULL << count <= side) ++count; // the next one's lower bound is 1 / side or more
    return count;
}

Octaves octaves_of(Core& core, const Planes& plane, std::uint32_t count)
{
    Spectra spectra(&core.memory, plane.width, plane.height, 1);
    PlaneTransform(core, plane.width, plane.height).forward(plane.plane(0), spectra, 0);
    keep_periodic_component(core, plane, spectra);
    const Array<Shares> along_x = shares_along(&core.memory, plane.width, count),
                        along_y = shares_along(&core.memory, plane.height, count);
    Array<Octaves> blocks(&core.memory, spectra.blocks());
    for_each_run(core.parallel, spectra.blocks(), [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t b = first; b < last; ++b) blocks[b] = block_octaves(spectra, b, along_x, along_y);
    });
    Octaves octaves;
    octaves.count = count;
    const double unit = 1 / (static_cast<double>(plane.area()) * static_cast<double>(plane.area()));
    for (const Octaves& block : blocks)
        for (std::uint32_t a = 0; a < count; ++a) octaves.power[a] += block.power[a] * unit;
    return octaves;
}

} // namespace weft
