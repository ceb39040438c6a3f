/// Distances in float, in an order that no vector length changes; sums in double, in pieces that no thread count does.
#include "analysis/kmeans.h"
#include "base/hash.h"
#include <algorithm>

namespace weft {
namespace {

constexpr std::uint32_t piece = 64; // blocks of points that are summed together

/// Squared distances of a block's points to a centre.
void distances(const float* block, const float* centre, std::uint32_t size, float* to) noexcept
{
    float sum[Points::lanes] = {};
    for (std::uint32_t i = 0; i < size; ++i)
        for (std::uint32_t lane = 0; lane < Points::lanes; ++lane) {
            const float difference = block[i * Points::lanes + lane] - centre[i];
            sum[lane] += difference * difference;
        }
    std::copy_n(sum, Points::lanes, to);
}

/// Nearest centres of points, and the sums that the next centres are made of.
class Round {
public:
    Round(Core& core, const Points& points, Means& means)
        : core_(core), points_(points), means_(means), pieces_((points.blocks() + piece - 1) / piece),
          width_(std::size_t{means.count} * (points.size + 1) + 1), sums_(&core.memory, pieces_ * width_),
          nearest_(&core.memory, std::size_t{points.blocks()} * Points::lanes, Array<std::uint8_t>::unset)
    {
        for (std::uint8_t& k : nearest_) k = 255;
    }

    /// How many points have another centre than before; the sums of squares are those of the centres as they were.
    std::uint64_t run()
    {
        Array<std::uint64_t> changes(&core_.memory, pieces_);
        core_.parallel.for_each_index(pieces_, [&](std::uint32_t p) { changes[p] = assign(p); });
        for (std::size_t p = 1; p < pieces_; ++p) {
            for (std::size_t i = 0; i < width_; ++i) sums_[i] += sums_[p * width_ + i];
            changes[0] += changes[p];
        }
        means_.squares = sums_[width_ - 1];
        for (std::uint32_t k = 0; k < means_.count; ++k) {
            const double* sum = sums_.data() + k * (std::size_t{points_.size} + 1);
            means_.members[k] = static_cast<std::uint32_t>(sum[points_.size]);
            for (std::uint32_t i = 0; changes[0] > 0 && means_.members[k] > 0 && i < points_.size; ++i)
                means_.centres[std::size_t{k} * points_.size + i] = static_cast<float>(sum[i] / sum[points_.size]);
        }
        return changes[0];
    }

private:
    std::uint64_t assign(std::uint32_t p)
    {
        double* sums = sums_.data() + p * width_;
        std::fill_n(sums, width_, 0.0);
        std::uint64_t changes = 0;
        for (std::uint32_t b = p * piece; b < std::min((p + 1) * piece, points_.blocks()); ++b) {
            const float* block = points_.block(b);
            float least[Points::lanes], squares[Points::lanes];
            std::uint8_t nearest[Points::lanes] = {};
            distances(block, means_.centres.data(), points_.size, least);
            for (std::uint32_t k = 1; k < means_.count; ++k) {
                distances(block, means_.centres.data() + std::size_t{k} * points_.size, points_.size, squares);
                for (std::uint32_t lane = 0; lane < Points::lanes; ++lane)
                    if (squares[lane] < least[lane]) {
                        least[lane] = squares[lane];
                        nearest[lane] = static_cast<std::uint8_t>(k);
                    }
            }
            for (std::uint32_t lane = 0; lane < std::min(Points::lanes, points_.count - b * Points::lanes); ++lane) {
                std::uint8_t& before = nearest_[std::size_t{b} * Points::lanes + lane];
                changes += before != nearest[lane] ? 1 : 0;
                before = nearest[lane];
                double* sum = sums + nearest[lane] * (std::size_t{points_.size} + 1);
                for (std::uint32_t i = 0; i < points_.size; ++i)
                    sum[i] += static_cast<double>(block[i * Points::lanes + lane]);
                sum[points_.size] += 1;
                sums[width_ - 1] += static_cast<double>(least[lane]);
            }
        }
        return changes;
    }

    Core& core_;
    const Points& points_;
    Means& means_;
    std::uint32_t pieces_;
    std::size_t width_;
    Array<double> sums_; ///< of each piece: per centre the numbers and how many points; the squares
    Array<std::uint8_t> nearest_;
};

} // namespace

Means spread_means(Core& core, const Points& points, std::uint32_t count, std::uint64_t seed)
{
    Means means;
    means.centres = Array<float>(&core.memory, std::size_t{count} * points.size);
    means.members = Array<std::uint32_t>(&core.memory, count);
    Array<float> least(&core.memory, std::size_t{points.blocks()} * Points::lanes, Array<float>::unset);
    std::uint32_t next = static_cast<std::uint32_t>(mix_in(seed, 0) % points.count);
    while (true) {
        float* centre = means.centres.data() + std::size_t{means.count} * points.size;
        for (std::uint32_t i = 0; i < points.size; ++i) centre[i] = points.at(next, i);
        double sum = 0;
        for (std::uint32_t b = 0; b < points.blocks(); ++b) {
            float squares[Points::lanes];
            distances(points.block(b), centre, points.size, squares);
            for (std::uint32_t lane = 0; lane < Points::lanes && b * Points::lanes + lane < points.count; ++lane) {
                float& smallest = least[std::size_t{b} * Points::lanes + lane];
                smallest = means.count ? std::min(smallest, squares[lane]) : squares[lane];
                sum += static_cast<double>(smallest);
            }
        }
        if (++means.count == count || !(sum > 0)) return means;
        double place = sum * (static_cast<double>(mix_in(seed, means.count) >> 11) * 0x1p-53);
        next = 0;
        for (std::uint32_t i = 0; i < points.count; ++i)
            if (least[i] > 0) { // the last such point, should rounding run past the end
                next = i;
                place -= static_cast<double>(least[i]);
                if (place < 0) break;
            }
    }
}

void refine_means(Core& core, const Points& points, std::uint32_t rounds, Means& means, const Progress& progress)
{
    Round round(core, points, means);
    for (std::uint32_t i = 0; i < rounds; ++i) {
        progress.at(static_cast<double>(i) / rounds);
        if (round.run() == 0) return;
    }
}

} // namespace weft
