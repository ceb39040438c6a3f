/// weft_power_spectrum: Welch's mean of windowed periodograms.
#include "analysis/measures.h"
#include "analysis/statistics.h"
#include "base/image.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr std::uint32_t most_groups = 16; // of segments; a number of its own, so that the order of sums is

/// Where segments begin along one axis: half overlap, or a little more, so that the last ends where the picture does.
struct Segments {
    Segments(std::uint32_t whole, std::uint32_t segment) noexcept
        : room(whole - segment), count(segment > 1 ? (room + segment / 2 - 1) / (segment / 2) + 1 : whole)
    {
    }
    std::uint32_t begin(std::uint32_t i) const noexcept
    {
        return count > 1 ? static_cast<std::uint32_t>(std::uint64_t{room} * i / (count - 1)) : 0;
    }
    std::uint32_t room, count;
};

Array<float> hann(std::pmr::memory_resource* memory, std::uint32_t length)
{
    Array<float> window(memory, length);
    for (std::uint32_t i = 0; i < length; ++i)
        window[i] = static_cast<float>(0.5 - 0.5 * std::cos(6.283185307179586 * (i + 0.5) / length));
    return window;
}

/// Sums of periodograms over the half-plane, each group of rows of segments into its own plane of `sums`.
void add_periodograms(Core& core, const Planes& planes, std::uint32_t channel, std::uint32_t width,
                      std::uint32_t height, Array<double>& sums, std::uint32_t groups)
{
    const Segments across(planes.width, width), down(planes.height, height);
    const Array<float> window_x = hann(&core.memory, width), window_y = hann(&core.memory, height);
    const PlaneTransform transform(core, width, height);
    core.parallel.for_each_index(groups, [&](std::uint32_t group) {
        Planes segment(&core.memory, width, height, 1, Array<float>::unset);
        Spectra spectra(&core.memory, width, height, 1);
        double* sum = sums.data() + group * spectra.values.size();
        std::fill_n(sum, spectra.values.size(), 0.0);
        const auto bound = [&](std::uint32_t g) {
            return static_cast<std::uint32_t>(std::uint64_t{down.count} * g / groups);
        };
        for (std::uint32_t i = bound(group); i < bound(group + 1); ++i)
            for (std::uint32_t j = 0; j < across.count; ++j) {
                for (std::uint32_t y = 0; y < height; ++y) {
                    const float* from = planes.row(channel, down.begin(i) + y) + across.begin(j);
                    for (std::uint32_t x = 0; x < width; ++x)
                        segment.row(0, y)[x] = from[x] * window_x[x] * window_y[y];
                }
                transform.forward(segment.plane(0), spectra, 0);
                for (std::size_t k = 0; k < spectra.values.size(); ++k)
                    sum[k] += static_cast<double>(std::norm(spectra.values[k]));
            }
    });
}

/// The half-plane's sum, scaled so that the whole plane's is `variance`, both halves around the middle of `result`.
void unfold(const Spectra& layout, const double* half, double variance, Planes& result, std::uint32_t channel)
{
    const std::uint32_t width = layout.width, height = layout.height;
    const auto index = [&](std::size_t x, std::size_t y) {
        return static_cast<std::size_t>(&layout.at(0, x, y) - layout.values.data());
    };
    double total = 0;
    for (std::uint32_t x = 0; x < layout.columns(); ++x)
        for (std::uint32_t y = 0; y < height; ++y) total += static_cast<double>(layout.weight(x)) * half[index(x, y)];
    const double scale = total > 0 ? variance / total : 0;
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            std::uint32_t k = (x + width - width / 2) % width, l = (y + height - height / 2) % height;
            if (k > width / 2) {
                k = width - k;
                l = l ? height - l : 0;
            }
            result.row(channel, y)[x] = static_cast<float>(half[index(k, l)] * scale);
        }
}

} // namespace

void power_spectrum(Core& core, const weft_image& image, const weft_image& spectrum)
{
    Planes planes = read_image(image, &core.memory, core.parallel, "weft_power_spectrum", "image");
    const Centring centring = centre(core, planes);
    const std::uint32_t groups = std::min(most_groups, Segments(image.height, spectrum.height).count);
    const Spectra layout(&core.memory, spectrum.width, spectrum.height, 1);
    const std::size_t size = layout.values.size();
    Array<double> sums(&core.memory, size * groups, Array<double>::unset);
    Planes result(&core.memory, spectrum.width, spectrum.height, spectrum.channels);
    for (std::uint32_t c = 0; c < image.channels; ++c) {
        add_periodograms(core, planes, c, spectrum.width, spectrum.height, sums, groups);
        for (std::size_t group = 1; group < groups; ++group)
            for (std::size_t k = 0; k < size; ++k) sums[k] += sums[group * size + k];
        unfold(layout, sums.data(), centring.deviation[c] * centring.deviation[c], result, c);
    }
    write_window(spectrum, 0, 0, result.width, result.height, result.values.data(), result.width, result.height);
}

} // namespace weft
