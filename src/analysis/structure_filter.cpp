/// Weights are symmetric and never change: half of them are computed, once, as far as there is room to keep them.
#include "analysis/structure_filter.h"
#include "analysis/similarity.h"
#include "analysis/spectra.h"
#include <algorithm>
#include <cstring>

namespace weft {
namespace {

constexpr std::size_t most_weights = std::size_t{48} << 20; // kept at once, in numbers
constexpr std::uint32_t most_together = 4;                  // planes filtered in one pass over the weights

typedef float Quad __attribute__((vector_size(16)));
inline Quad quad_at(const float* values) noexcept
{
    Quad quad;
    std::memcpy(&quad, values, sizeof quad);
    return quad;
}

/// Weights of the pixels in a strip of rows with those to the right and below, all rows and planes having a margin in
/// which they are 0.
class Filter {
public:
    Filter(Core& core, const Local_spectra& guide, const Structure_filter& filter)
        : core_(core), guide_(guide), filter_(filter), reach_(static_cast<std::int32_t>(filter.width / 2)),
          stride_((guide.width + block - 1) / block * block + 2 * static_cast<std::size_t>(reach_)),
          per_row_(static_cast<std::size_t>(2 * reach_ * (reach_ + 1)) * stride_)
    {
        const std::size_t room = most_weights / per_row_, least = 2 * static_cast<std::size_t>(reach_) + 16;
        strip_ = static_cast<std::uint32_t>(std::min<std::size_t>(std::max(room, least), guide.height));
        weights_ = Array<float>(&core.memory, strip_ * per_row_, Array<float>::unset);
        std::fill_n(weights_.data(), margin(), 0.0F);
    }

    std::size_t stride() const noexcept { return stride_; }
    std::size_t margin() const noexcept { return static_cast<std::size_t>(reach_); }

    /// to <- sums of the weighted planes `from`, `count` of them.
    void apply(const float* const* from, float* const* to, std::uint32_t count, const Progress& progress)
    {
        const std::uint32_t height = guide_.height;
        if (strip_ == height) {
            if (!known_) weigh(0, height, progress.part(0, 0.8));
            known_ = true;
            return add(0, height, 0, from, to, count, progress.part(0.8, 1));
        }
        const std::uint32_t step = strip_ - static_cast<std::uint32_t>(reach_);
        for (std::uint32_t first = 0; first < height; first += step) {
            const std::uint32_t last = std::min(first + step, height),
                                begin = first - std::min(first, static_cast<std::uint32_t>(reach_));
            const double done = static_cast<double>(first) / height, end = static_cast<double>(last) / height;
            weigh(begin, last, progress.part(done, 0.2 * done + 0.8 * end));
            add(first, last, begin, from, to, count, progress.part(0.2 * done + 0.8 * end, end));
        }
    }

private:
    /// body(offset, dx, dy) for all of them to the right in this row, or below it.
    template <class Body> void for_each_offset(const Body& body) const
    {
        std::size_t offset = 0;
        for (std::int32_t dy = 0; dy <= reach_; ++dy)
            for (std::int32_t dx = dy ? -reach_ : 1; dx <= reach_; ++dx) body(offset++, dx, dy);
    }
    float share(std::int32_t d) const noexcept
    {
        return filter_.width % 2 == 0 && (d == reach_ || d == -reach_) ? 0.5F : 1.0F;
    }
    float* row(std::size_t y) noexcept { return weights_.data() + y * per_row_ + margin(); }

    void weigh(std::uint32_t first, std::uint32_t last, const Progress& progress)
    {
        const float scale = 0.5F / filter_.sigma / filter_.sigma;
        for_each_group(last - first, per_row_ * (guide_.size + 8) / 2, progress,
                       [&](std::uint32_t begin, std::uint32_t end) {
                           core_.parallel.for_each_index(end - begin, [&](std::uint32_t i) {
                               const std::uint32_t y = begin + i;
                               for_each_offset([&](std::size_t offset, std::int32_t dx, std::int32_t dy) {
                                   float* to = row(y) + offset * stride_;
                                   const auto other = first + y + static_cast<std::uint32_t>(dy);
                                   if (other < guide_.height)
                                       similarities(guide_, first + y, other, dx, scale, share(dx) * share(dy), to);
                                   else
                                       std::fill_n(to, guide_.width, 0.0F);
                                   float* margins = to + guide_.width; // this one's right, the next one's left
                                   std::fill(margins, std::min(to + stride_, weights_.end()), 0.0F);
                               });
                           });
                       });
    }

    void add(std::uint32_t first, std::uint32_t last, std::uint32_t origin, const float* const* from, float* const* to,
             std::uint32_t count, const Progress& progress)
    {
        for_each_group(last - first, per_row_ * count, progress, [&](std::uint32_t begin, std::uint32_t end) {
            core_.parallel.for_each_index(end - begin, [&](std::uint32_t i) {
                const std::uint32_t y = first + begin + i;
                switch (count) {
                case 1:
                    return add_row<1>(y, origin, from, to);
                case 2:
                    return add_row<2>(y, origin, from, to);
                case 3:
                    return add_row<3>(y, origin, from, to);
                default:
                    return add_row<4>(y, origin, from, to);
                }
            });
        });
    }

    template <std::uint32_t count>
    void add_row(std::uint32_t y, std::uint32_t origin, const float* const* from, float* const* to)
    {
        for (std::uint32_t c = 0; c < count; ++c)
            std::copy_n(from[c] + y * stride_ + margin(), stride_ - 2 * margin(), to[c] + y * stride_ + margin());
        const auto y_signed = static_cast<std::int32_t>(y), height = static_cast<std::int32_t>(guide_.height);
        std::size_t offset = 0;
        for (std::int32_t dy = 0; dy <= reach_; ++dy) {
            const std::int32_t least = dy ? -reach_ : 1;
            const auto offsets = static_cast<std::size_t>(reach_ - least + 1);
            if (y_signed + dy < height)
                add_offsets<count, 1>(row(y - origin) + offset * stride_, y + static_cast<std::uint32_t>(dy), least,
                                      from, y, to);
            if (y_signed - dy >= 0) {
                const std::uint32_t above = y - static_cast<std::uint32_t>(dy);
                add_offsets<count, -1>(row(above - origin) + offset * stride_, above, least, from, y, to);
            }
            offset += offsets;
        }
    }

    /// The neighbours of row y in row `other`: those at dx for sign 1; for sign -1 those that have it at dx. A few at a
    /// time, so that no more streams of weights are read than a processor foresees.
    template <std::uint32_t count, std::int32_t sign>
    void add_offsets(const float* weights, std::uint32_t other, std::int32_t least, const float* const* from,
                     std::uint32_t y, float* const* to) const
    {
        constexpr std::int32_t streams = 6;
        for (std::int32_t first = least; first <= reach_; first += streams) {
            const std::int32_t last = std::min(first + streams - 1, reach_);
            for (std::size_t x = 0; x < stride_ - 2 * margin(); x += block) {
                const std::size_t at = y * stride_ + margin() + x, near = other * stride_ + margin() + x;
                Quad left[count], right[count];
                for (std::uint32_t c = 0; c < count; ++c) {
                    left[c] = quad_at(to[c] + at);
                    right[c] = quad_at(to[c] + at + 4);
                }
                const float* weight = weights + x + static_cast<std::size_t>(first - least) * stride_;
                for (std::int32_t dx = first; dx <= last; ++dx, weight += stride_) {
                    const float* shifted = weight + (sign > 0 ? 0 : -dx);
                    const Quad a = quad_at(shifted), b = quad_at(shifted + 4);
                    for (std::uint32_t c = 0; c < count; ++c) {
                        const float* value = from[c] + near + sign * dx;
                        left[c] += a * quad_at(value);
                        right[c] += b * quad_at(value + 4);
                    }
                }
                for (std::uint32_t c = 0; c < count; ++c) {
                    std::memcpy(to[c] + at, &left[c], sizeof(Quad));
                    std::memcpy(to[c] + at + 4, &right[c], sizeof(Quad));
                }
            }
        }
    }

    static constexpr std::size_t block = 8;
    Core& core_;
    const Local_spectra& guide_;
    const Structure_filter filter_;
    std::int32_t reach_;
    std::size_t stride_, per_row_; ///< of a plane's row; weights of a row
    std::uint32_t strip_;
    Array<float> weights_; ///< [row of the strip][offset][stride]
    bool known_ = false;
};

} // namespace

void filter_structure(Core& core, const Local_spectra& guide, const Structure_filter& filter, Planes& planes,
                      const Progress& progress)
{
    const std::uint32_t width = planes.width, height = planes.height, count = planes.count;
    Filter pass(core, guide, filter);
    const std::size_t area = pass.stride() * height;
    Array<float> before(&core.memory, area * (count + 1)), after(&core.memory, area * (count + 1));
    for (std::size_t c = 0; c <= count; ++c) // the last plane, all 1, gives the sums of weights
        for (std::size_t y = 0; y < height; ++y) {
            float* to = before.data() + c * area + y * pass.stride() + pass.margin();
            if (c < count)
                std::copy_n(planes.row(c, y), width, to);
            else
                std::fill_n(to, width, 1.0F);
        }
    float* sums = after.data() + count * area;
    for (std::uint32_t i = 0; i < filter.iterations; ++i) {
        const Progress share =
            progress.part(i ? (i + 2.0) / (filter.iterations + 2.0) : 0, (i + 3.0) / (filter.iterations + 2.0));
        const std::uint32_t wanted = i ? count : count + 1;
        for (std::uint32_t c = wanted; c > 0;) {
            const std::uint32_t together = std::min(c, most_together);
            const float* from[most_together];
            float* to[most_together];
            for (std::uint32_t j = 0; j < together; ++j) {
                from[j] = before.data() + (c - together + j) * area;
                to[j] = after.data() + (c - together + j) * area;
            }
            pass.apply(from, to, together,
                       share.part(1 - static_cast<double>(c) / wanted, 1 - static_cast<double>(c - together) / wanted));
            c -= together;
        }
        for_each_run(core.parallel, height, [&](std::uint32_t first, std::uint32_t last) {
            for (std::size_t c = 0; c < count; ++c)
                for (std::size_t k = first * pass.stride() + pass.margin(); k < last * pass.stride(); ++k)
                    if (sums[k] > 0) before[c * area + k] = after[c * area + k] / sums[k];
        });
    }
    for (std::size_t c = 0; c < count; ++c)
        for (std::size_t y = 0; y < height; ++y)
            std::copy_n(before.data() + c * area + y * pass.stride() + pass.margin(), width, planes.row(c, y));
}

} // namespace weft
