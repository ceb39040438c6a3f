/// Averages the products of windowed segments' transforms, segment after segment, so that threads change no bit.
#include "analysis/cross_spectrum.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr std::uint32_t most_segments = 4096; // one standard error is then below 2 % of the power at each frequency
constexpr std::uint32_t segments_at_once = 32;

/// Origins of segments along one axis.
struct Origins {
    std::uint32_t length, edge, count;

    Origins(std::uint32_t pixels, std::uint32_t segment) noexcept
        : length(pixels), edge(segment), count((pixels - segment + segment / 2 - 1) / (segment / 2) + 1)
    {
    }
    std::uint32_t operator[](std::uint32_t i) const noexcept
    {
        return count == 1 ? (length - edge) / 2
                          : static_cast<std::uint32_t>(std::uint64_t{length - edge} * i / (count - 1));
    }
};

void thin_out(Origins& columns, Origins& rows) noexcept
{
    const double excess = static_cast<double>(columns.count) * rows.count / most_segments;
    if (excess <= 1) return;
    Origins& longer = columns.count > rows.count ? columns : rows;
    Origins& shorter = columns.count > rows.count ? rows : columns;
    shorter.count =
        std::max(1u, std::min(shorter.count, static_cast<std::uint32_t>(shorter.count / std::sqrt(excess))));
    longer.count = std::max(1u, std::min(longer.count, most_segments / shorter.count));
}

class Segments {
public:
    Segments(Core& core, const Planes& planes, const double* mean, const TileTransform& transform)
        : memory_(&core.memory), planes_(planes), mean_(mean), transform_(transform),
          columns_(planes.width, transform.edge()), rows_(planes.height, transform.edge()),
          window_(memory_, transform.edge())
    {
        thin_out(columns_, rows_);
        const double edge = transform.edge();
        double square = 0;
        for (std::uint32_t i = 0; i < transform.edge(); ++i) {
            const double value = 0.5 - 0.5 * std::cos(6.283185307179586 * (i + 0.5) / edge);
            window_[i] = static_cast<float>(value);
            square += value * value;
        }
        // Parseval: the squared modulus of the DFT sums to edge^2 times the window's energy times the variance.
        scale_ = 1 / (edge * edge * square * square * static_cast<double>(count()));
    }
    std::uint32_t count() const noexcept { return columns_.count * rows_.count; }
    double scale() const noexcept { return scale_; }

    /// The transforms of all channels of one segment.
    void transform(std::uint32_t index, Complex* spectra) const
    {
        const std::size_t edge = transform_.edge(), left = columns_[index % columns_.count],
                          top = rows_[index / columns_.count];
        Array<float> tile(memory_, edge * edge, Array<float>::unset);
        for (std::uint32_t c = 0; c < planes_.count; ++c) {
            for (std::size_t y = 0; y < edge; ++y)
                for (std::size_t x = 0; x < edge; ++x)
                    tile[y * edge + x] =
                        (planes_.row(c, top + y)[left + x] - static_cast<float>(mean_[c])) * window_[y] * window_[x];
            transform_.forward(tile.data(), spectra + c * transform_.frequencies());
        }
    }

private:
    std::pmr::memory_resource* memory_;
    const Planes& planes_;
    const double* mean_;
    const TileTransform& transform_;
    Origins columns_, rows_;
    Array<float> window_;
    double scale_ = 0;
};

/// Adds the products of the channels' transforms at frequency `i` of one segment.
void add_products(const Complex* spectra, std::size_t frequencies, std::size_t i, std::uint32_t channels,
                  std::complex<double>* sums) noexcept
{
    for (std::uint32_t c = 0; c < channels; ++c) {
        const Complex a = spectra[c * frequencies + i];
        for (std::uint32_t d = 0; d <= c; ++d, ++sums) {
            const Complex b = spectra[d * frequencies + i];
            *sums += std::complex<double>(static_cast<double>(a.real() * b.real() + a.imag() * b.imag()),
                                          static_cast<double>(a.imag() * b.real() - a.real() * b.imag()));
        }
    }
}

} // namespace

CrossSpectrum cross_spectrum_of(Core& core, const Planes& planes, const double* mean, const TileTransform& transform,
                                const Progress& progress)
{
    const Segments segments(core, planes, mean, transform);
    const std::size_t frequencies = transform.frequencies(), size = frequencies * planes.count;
    CrossSpectrum result;
    result.channels = planes.count;
    result.values = Array<std::complex<double>>(&core.memory, frequencies * result.triangle());
    Array<Complex> spectra(&core.memory, size * std::min(segments.count(), segments_at_once));
    for (std::uint32_t first = 0; first < segments.count(); first += segments_at_once) {
        const std::uint32_t batch = std::min(segments_at_once, segments.count() - first);
        core.parallel.for_each_index(
            batch, [&](std::uint32_t i) { segments.transform(first + i, spectra.data() + i * size); });
        core.parallel.for_each_index(4 * transform.blocks(), [&](std::uint32_t part) {
            const std::size_t length = transform.block_size() / 4;
            for (std::size_t i = part * length; i < (part + 1) * length; ++i)
                for (std::uint32_t segment = 0; segment < batch; ++segment)
                    add_products(spectra.data() + segment * size, frequencies, i, planes.count,
                                 result.values.data() + i * result.triangle());
        });
        progress.at(static_cast<double>(first + batch) / segments.count());
    }
    for (std::complex<double>& value : result.values) value *= segments.scale();
    return result;
}

} // namespace weft
