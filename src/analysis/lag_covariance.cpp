/// Correlates each block with its surroundings by Fourier transforms of fixed size, and divides by the number of pairs.
#include "analysis/lag_covariance.h"
#include "analysis/tile_transform.h"
#include "analysis/wasserstein.h"
#include <algorithm>

namespace weft {
namespace {

constexpr std::uint32_t largest_tile = 256;
constexpr std::uint64_t most_blocks = 256;
constexpr std::uint32_t blocks_at_once = 8;

std::uint32_t tile_edge(const Planes& planes, std::uint32_t reach) noexcept
{
    std::uint32_t edge = 32;
    while (edge < largest_tile && edge < std::max(planes.width, planes.height) + 2 * reach) edge *= 2;
    return edge;
}

class Blocks {
public:
    Blocks(Core& core, const Planes& planes, const double* mean, std::uint32_t reach, std::uint64_t seed)
        : transform(core, tile_edge(planes, reach)), memory_(&core.memory), planes_(planes), mean_(mean), reach_(reach),
          edge_(transform.edge() - 2 * reach), columns_((planes.width + edge_ - 1) / edge_),
          sample_(std::uint64_t{columns_} * ((planes.height + edge_ - 1) / edge_), most_blocks, seed)
    {
    }
    std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(sample_.size()); }

    /// The spectrum of the correlation of block `index` with its surroundings.
    void correlate(std::uint32_t index, std::uint32_t channel, Complex* product) const
    {
        const std::size_t side = transform.edge();
        Array<float> tile(memory_, side * side);
        Array<Complex> inner(memory_, transform.frequencies());
        fill(index, channel, 0, tile.data());
        transform.forward(tile.data(), inner.data());
        fill(index, channel, reach_, tile.data());
        transform.forward(tile.data(), product);
        for (std::size_t i = 0; i < inner.size(); ++i) {
            const Complex a = inner[i], b = product[i];
            product[i] = {a.real() * b.real() + a.imag() * b.imag(), a.real() * b.imag() - a.imag() * b.real()};
        }
    }
    /// How many pairs of pixels at lag (x, y) begin in the blocks.
    double pairs(std::int64_t x, std::int64_t y) const noexcept
    {
        const auto within = [](Range range, std::int64_t lag, std::int64_t size) {
            return static_cast<double>(
                std::max<std::int64_t>(0, std::min(range.end, size - lag) - std::max(range.begin, -lag)));
        };
        double sum = 0;
        for (std::uint64_t i = 0; i < sample_.size(); ++i)
            sum += within(range(sample_[i] % columns_, planes_.width), x, planes_.width) *
                   within(range(sample_[i] / columns_, planes_.height), y, planes_.height);
        return sum;
    }

    const TileTransform transform;

private:
    struct Range {
        std::int64_t begin, end;
    };
    Range range(std::uint64_t block, std::uint32_t size) const noexcept
    {
        const auto begin = static_cast<std::int64_t>(block * edge_);
        return {begin, std::min<std::int64_t>(begin + edge_, size)};
    }
    /// The block and `margin` pixels around it, the picture's mean beyond its border; the block's corner is at 0, the
    /// margin before it at the tile's far end.
    void fill(std::uint32_t index, std::uint32_t channel, std::uint32_t margin, float* tile) const noexcept
    {
        const std::int64_t side = transform.edge(), far = margin;
        const Range columns = range(sample_[index] % columns_, planes_.width),
                    rows = range(sample_[index] / columns_, planes_.height);
        std::fill_n(tile, side * side, 0.0f);
        for (std::int64_t y = std::max<std::int64_t>(0, rows.begin - far);
             y < std::min<std::int64_t>(planes_.height, rows.end + far); ++y) {
            const float* row = planes_.row(channel, static_cast<std::size_t>(y));
            float* line = tile + (y - rows.begin + side) % side * side;
            for (std::int64_t x = std::max<std::int64_t>(0, columns.begin - far);
                 x < std::min<std::int64_t>(planes_.width, columns.end + far); ++x)
                line[(x - columns.begin + side) % side] = row[x] - static_cast<float>(mean_[channel]);
        }
    }

    std::pmr::memory_resource* memory_;
    const Planes& planes_;
    const double* mean_;
    std::uint32_t reach_, edge_, columns_;
    Sample sample_;
};

/// The sum over all blocks, added in their order.
Array<float> correlation(Core& core, const Blocks& blocks, std::uint32_t channel, const Progress& progress)
{
    const std::size_t frequencies = blocks.transform.frequencies();
    Array<Complex> products(&core.memory, frequencies * std::min(blocks.count(), blocks_at_once));
    Array<std::complex<double>> sums(&core.memory, frequencies);
    for (std::uint32_t first = 0; first < blocks.count(); first += blocks_at_once) {
        const std::uint32_t batch = std::min(blocks_at_once, blocks.count() - first);
        core.parallel.for_each_index(
            batch, [&](std::uint32_t i) { blocks.correlate(first + i, channel, products.data() + i * frequencies); });
        for (std::size_t i = 0; i < batch * frequencies; ++i)
            sums[i % frequencies] += std::complex<double>(products[i]);
        progress.at(static_cast<double>(first + batch) / blocks.count());
    }
    const std::size_t side = blocks.transform.edge();
    Array<float> result(&core.memory, side * side, Array<float>::unset);
    for (std::size_t i = 0; i < frequencies; ++i) products[i] = Complex(sums[i] / static_cast<double>(side * side));
    blocks.transform.backward(products.data(), result.data());
    return result;
}

} // namespace

LagCovariance lag_covariance_of(Core& core, const Planes& planes, const double* mean, std::uint32_t reach,
                                std::uint64_t seed, const Progress& progress)
{
    const Blocks blocks(core, planes, mean, reach, seed);
    LagCovariance result;
    result.reach = reach;
    result.values = Array<double>(&core.memory, std::size_t{planes.count} * (reach + 1) * (2 * reach + 1));
    const std::int64_t side = blocks.transform.edge(), far = reach;
    for (std::uint32_t c = 0; c < planes.count; ++c) {
        const double begin = static_cast<double>(c) / planes.count, end = static_cast<double>(c + 1) / planes.count;
        const Array<float> sums = correlation(core, blocks, c, progress.part(begin, end));
        for (std::int64_t y = 0; y <= far; ++y)
            for (std::int64_t x = -far; x <= far; ++x)
                result.values[result.index(c, x, y)] =
                    static_cast<double>(sums[static_cast<std::size_t>(y * side + (x + side) % side)]) /
                    std::max(1.0, blocks.pairs(x, y));
    }
    return result;
}

} // namespace weft
