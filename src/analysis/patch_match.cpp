/// The scan goes by blocks along diagonals: when a block begins, those left of it and above it are finished.
#include "analysis/patch_match.h"
#include "analysis/compare_pair.h"
#include "base/hash.h"
#include <algorithm>

namespace weft {
namespace {

constexpr std::uint32_t candidates = 4;

/// Sum of the squared differences of `rows` rows of `line` values. For 31 x 31 patches four rows stay below 2^32.
template <std::uint32_t fixed_line>
inline std::uint32_t rows_distance(const std::int16_t* a, std::size_t a_stride, const std::int16_t* b,
                                   std::size_t b_stride, std::uint32_t line, std::uint32_t rows) noexcept
{
    std::uint32_t total = 0;
    for (std::uint32_t j = 0; j < rows; ++j) {
        std::int32_t sum = 0;
        for (std::uint32_t i = 0; i < (fixed_line ? fixed_line : line); ++i) {
            const auto difference = static_cast<std::int16_t>(a[i] - b[i]);
            sum += difference * difference;
        }
        total += static_cast<std::uint32_t>(sum);
        a += a_stride;
        b += b_stride;
    }
    return total;
}

class Scan {
public:
    Scan(const Lab_picture& tile, const Lab_picture& exemplar, const Uniformity& uniformity, std::uint64_t key,
         Match_field& field)
        : tile_(tile), exemplar_(exemplar), uniformity_(uniformity), field_(field), key_(key),
          side_(2 * field.reach + 1), line_(side_ * exemplar.channels),
          origin_x_(static_cast<std::uint32_t>(mix_bits(key) % field.width)),
          origin_y_(static_cast<std::uint32_t>(mix_bits(key + 1) % field.height)), backwards_((key & 1) != 0)
    {
        while ((std::max(exemplar.width, exemplar.height) >> octaves_) > 1) ++octaves_;
    }

    /// Pixels from (u, v) on, counted along the scan. Returns the sum of the distances.
    std::uint64_t block(std::uint32_t u_begin, std::uint32_t v_begin, std::uint32_t u_end, std::uint32_t v_end) const
    {
        std::uint64_t sum = 0;
        for (std::uint32_t v = v_begin; v < v_end; ++v) {
            const std::uint32_t y = position(origin_y_, v, field_.height);
            for (std::uint32_t u = u_begin; u < u_end; ++u)
                sum += line_ == 33 ? pixel<33>(position(origin_x_, u, field_.width), y)
                                   : pixel<0>(position(origin_x_, u, field_.width), y);
        }
        return sum;
    }

private:
    struct Best {
        Place place;
        std::uint64_t cost, distance;
    };

    std::uint32_t position(std::uint32_t origin, std::uint32_t step, std::uint32_t size) const noexcept
    {
        if (backwards_) return origin >= step ? origin - step : origin + size - step;
        return origin + step < size ? origin + step : origin + step - size;
    }

    /// Takes the place if it costs less.
    template <std::uint32_t fixed_line>
    void consider(const std::int16_t* patch, std::uint32_t x, std::uint32_t y, Best& best) const noexcept
    {
        constexpr std::uint32_t rows_at_once = 4;
        const std::uint64_t penalty = uniformity_.penalty(x, y);
        std::uint64_t distance = 0;
        const std::int16_t* other = exemplar_.at(x - field_.reach, y - field_.reach);
        const std::size_t stride = tile_.stride(), other_stride = exemplar_.stride();
        for (std::uint32_t j = 0; j < side_; j += rows_at_once) {
            if (distance + penalty >= best.cost) return;
            distance += rows_distance<fixed_line>(patch + j * stride, stride, other + j * other_stride, other_stride,
                                                  line_, std::min(rows_at_once, side_ - j));
        }
        if (distance + penalty < best.cost)
            best = {{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)}, distance + penalty, distance};
    }

    /// What a neighbour's match makes likely here, if it lies in the exemplar.
    template <std::uint32_t fixed_line>
    void propagate(const std::int16_t* patch, Place place, std::uint32_t dx, std::uint32_t dy,
                   Best& best) const noexcept
    {
        const std::uint32_t x = place.x + dx, y = place.y + dy, reach = field_.reach; // -1 is added as 2^32 - 1
        if (x < reach || y < reach || x >= exemplar_.width - reach || y >= exemplar_.height - reach) return;
        if (x == best.place.x && y == best.place.y) return;
        consider<fixed_line>(patch, x, y, best);
    }

    /// Around the best place, over ever smaller distances.
    template <std::uint32_t fixed_line>
    void search_at_random(const std::int16_t* patch, std::uint64_t pixel, Best& best) const noexcept
    {
        const std::uint32_t reach = field_.reach;
        const std::uint32_t most_x = exemplar_.width - 1 - reach, most_y = exemplar_.height - 1 - reach;
        for (std::uint32_t k = 0; k < candidates; ++k) {
            const std::uint64_t bits = mix_in(key_ + k, pixel);
            const auto dice = static_cast<std::uint32_t>(bits & 0xff);
            const std::uint32_t octave = (256 * k + dice) * octaves_ / (256 * candidates);
            const std::uint32_t radius = std::max(exemplar_.width, exemplar_.height) >> octave;
            const auto along = [&](std::uint32_t middle, std::uint32_t most, std::uint64_t random) {
                const std::uint32_t low = middle > reach + radius ? middle - radius : reach;
                const std::uint32_t high = std::min(most, middle + radius);
                return low + static_cast<std::uint32_t>(((random & 0xfffffff) * (high - low + 1)) >> 28);
            };
            const std::uint32_t x = along(best.place.x, most_x, bits >> 8), y = along(best.place.y, most_y, bits >> 36);
            if (x == best.place.x && y == best.place.y) continue;
            consider<fixed_line>(patch, x, y, best);
        }
    }

    template <std::uint32_t fixed_line> std::uint64_t pixel(std::uint32_t x, std::uint32_t y) const noexcept
    {
        const std::uint32_t width = field_.width, height = field_.height;
        const std::size_t row = std::size_t{y} * width;
        const std::int16_t* patch = tile_.at(x, y) - field_.reach * (tile_.stride() + tile_.channels);
        Best best{{0, 0}, ~std::uint64_t{0}, 0};
        const Place before = field_.places[row + x];
        consider<fixed_line>(patch, before.x, before.y, best);
        const std::uint32_t step = backwards_ ? 1u : ~0u; // to the neighbour that the scan came from
        const std::uint32_t beside = x + step < width ? x + step : (backwards_ ? 0 : width - 1);
        const std::uint32_t above = y + step < height ? y + step : (backwards_ ? 0 : height - 1);
        propagate<fixed_line>(patch, field_.places[row + beside], 0 - step, 0, best);
        propagate<fixed_line>(patch, field_.places[std::size_t{above} * width + x], 0, 0 - step, best);
        search_at_random<fixed_line>(patch, row + x, best);
        field_.places[row + x] = best.place;
        field_.costs[row + x] = best.cost;
        return best.distance;
    }

    const Lab_picture &tile_, &exemplar_;
    const Uniformity& uniformity_;
    Match_field& field_;
    const std::uint64_t key_;
    const std::uint32_t side_, line_, origin_x_, origin_y_;
    const bool backwards_;
    std::uint32_t octaves_ = 0;
};

} // namespace

double search(Core& core, const Lab_picture& tile, const Lab_picture& exemplar, const Uniformity& uniformity,
              std::uint64_t key, Match_field& field, const Progress& progress)
{
    const Scan scan(tile, exemplar, uniformity, key, field);
    const std::uint32_t side = std::max(field.width, field.height) <= 96 ? 16 : 32;
    const std::uint32_t across = (field.width + side - 1) / side, down = (field.height + side - 1) / side;
    const double cost = 3.0 * candidates * side * side * field.patch_pixels();
    Array<std::uint64_t> sums(&core.memory, std::size_t{across} * down);
    for (std::uint32_t diagonal = 0; diagonal < across + down - 1; ++diagonal) {
        const std::uint32_t first = diagonal < down ? 0 : diagonal - down + 1;
        const std::uint32_t count = std::min(diagonal, across - 1) - first + 1;
        const double share = 1.0 / (across + down - 1);
        for_each_step(core, count, cost, progress.part(diagonal * share, (diagonal + 1) * share), [&](std::uint32_t i) {
            const std::uint32_t u = (first + i) * side, v = (diagonal - first - i) * side;
            sums[std::size_t{v / side} * across + u / side] =
                scan.block(u, v, std::min(u + side, field.width), std::min(v + side, field.height));
        });
    }
    std::uint64_t sum = 0;
    for (const std::uint64_t part : sums) sum += part;
    return static_cast<double>(sum) / static_cast<double>(field.area());
}

} // namespace weft
