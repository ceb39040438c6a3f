/// Exhaustive search: means of parts of patches tell of most candidates that they are not nearest, several side by
/// side.
#include "analysis/texture_cost.h"
#include "analysis/lab_planes.h"
#include "base/hash.h"
#include "model/correspondence.h"
#include <algorithm>
#include <cfloat>
#include <cmath>

namespace weft {
namespace {

constexpr const char* function = "weft_texture_cost";
constexpr std::uint32_t side_by_side = 16; ///< candidates in a row
constexpr std::uint32_t most_probes = 1024;
constexpr std::uint32_t band_rows = 32;                    ///< rows of candidates whose parts are known at once
constexpr std::uint32_t cuts = 3, parts = cuts * cuts + 1; ///< the whole, and 3 x 3 parts of it

/// Part `k` of a patch: pixels [left, right) x [top, bottom).
struct Part {
    std::uint32_t left, right, top, bottom;
    float scale() const noexcept
    {
        const std::uint32_t area = (right - left) * (bottom - top);
        return area > 0 ? 1 / std::sqrt(static_cast<float>(area)) : 0;
    }
};

Part part_of(std::uint32_t patch, std::uint32_t k) noexcept
{
    if (k == 0) return {0, patch, 0, patch};
    const std::uint32_t column = (k - 1) % cuts, row = (k - 1) / cuts;
    return {patch * column / cuts, patch * (column + 1) / cuts, patch * row / cuts, patch * (row + 1) / cuts};
}

/// Sums over parts, over the root of their number of pixels: the squared distance between those of two patches is at
/// most that of the patches (Cauchy and Schwarz), for the whole and for its parts.
void add_part(const float* row, std::size_t stride, std::uint32_t count, const Part& part, float* sums) noexcept
{
    std::fill_n(sums, count, 0.0f);
    for (std::uint32_t y = part.top; y < part.bottom; ++y)
        for (std::uint32_t x = part.left; x < part.right; ++x) {
            const float* from = row + y * stride + x;
            for (std::uint32_t i = 0; i < count; ++i) sums[i] += from[i];
        }
    const float scale = part.scale();
    for (std::uint32_t i = 0; i < count; ++i) sums[i] *= scale;
}

/// A patch of the output, plane by plane, and the least distance so far.
struct Sought {
    const float* pixels;
    const float* sums; ///< of its parts: part by part, plane by plane
    float least;
};

class Search {
public:
    Search(Core& core, const Planes& exemplar, std::uint32_t patch)
        : core_(core), exemplar_(exemplar), patch_(patch), columns_(exemplar.width - patch + 1),
          stride_((columns_ + side_by_side - 1) / side_by_side * side_by_side),
          sums_(&core.memory, std::size_t{stride_} * band_rows * parts * exemplar.count)
    {
    }

    std::uint32_t rows() const noexcept { return exemplar_.height - patch_ + 1; }

    /// A few candidates from all over, so that most others are ruled out early.
    void probe(Sought& sought) const noexcept
    {
        const std::uint64_t probes = std::min<std::uint64_t>(most_probes, std::uint64_t{columns_} * rows() / 64);
        for (std::uint64_t i = 0; i < probes; ++i) {
            const std::uint64_t bits = mix_bits(i);
            sought.least = least_with(sought, static_cast<std::uint32_t>((bits & 0xffffffffU) * columns_ >> 32),
                                      static_cast<std::uint32_t>((bits >> 32) * rows() >> 32));
        }
    }

    void prepare(std::uint32_t first, std::uint32_t last)
    {
        first_ = first;
        core_.parallel.for_each_index(last - first, [&](std::uint32_t row) {
            for (std::uint32_t k = 0; k < parts; ++k)
                for (std::uint32_t c = 0; c < exemplar_.count; ++c)
                    add_part(exemplar_.row(c, first + row), exemplar_.width, columns_, part_of(patch_, k),
                             sums_of(row, k, c));
        });
    }

    /// Candidates in rows [first, last), which are prepared.
    void look(Sought& sought, std::uint32_t last) noexcept
    {
        for (std::uint32_t y = first_; y < last; ++y)
            for (std::uint32_t x = 0; x < columns_; x += side_by_side) {
                if (ruled_out(sought, x, y - first_, 0, 1) || ruled_out(sought, x, y - first_, 1, parts)) continue;
                const std::uint32_t end = std::min(columns_, x + side_by_side);
                for (std::uint32_t i = x; i < end; ++i) sought.least = least_with(sought, i, y);
            }
    }

    /// The lesser of the least distance and that of the candidate at (x, y).
    float least_with(const Sought& sought, std::uint32_t x, std::uint32_t y) const noexcept
    {
        float sum = 0;
        const float* own = sought.pixels;
        for (std::uint32_t c = 0; c < exemplar_.count; ++c)
            for (std::uint32_t row = 0; row < patch_; ++row, own += patch_) {
                const float* there = exemplar_.row(c, y + row) + x;
                for (std::uint32_t i = 0; i < patch_; ++i) sum += (there[i] - own[i]) * (there[i] - own[i]);
                if (sum >= sought.least) return sought.least;
            }
        return sum;
    }

private:
    float* sums_of(std::uint32_t row, std::uint32_t k, std::uint32_t c) noexcept
    {
        return &sums_[((std::size_t{row} * parts + k) * exemplar_.count + c) * stride_];
    }

    /// Do parts [first, last) show that none of the candidates from x on is nearer? Rounding is given a margin.
    bool ruled_out(const Sought& sought, std::uint32_t x, std::uint32_t row, std::uint32_t first,
                   std::uint32_t last) noexcept
    {
        float bounds[side_by_side] = {};
        for (std::uint32_t k = first; k < last; ++k)
            for (std::uint32_t c = 0; c < exemplar_.count; ++c) {
                const float *there = sums_of(row, k, c) + x, own = sought.sums[k * exemplar_.count + c];
                for (std::uint32_t i = 0; i < side_by_side; ++i) bounds[i] += (there[i] - own) * (there[i] - own);
            }
        std::uint32_t nearer = 0;
        for (std::uint32_t i = 0; i < side_by_side; ++i) nearer |= bounds[i] * 0.999f < sought.least ? 1U : 0U;
        return nearer == 0;
    }

    Core& core_;
    const Planes& exemplar_;
    std::uint32_t patch_, columns_, stride_, first_ = 0;
    Array<float> sums_;
};

/// Patches at random places of an image that repeats.
Array<float> sample(Core& core, const Planes& output, const weft_texture_cost_options& options)
{
    const std::size_t patch = options.patch, size = patch * patch * output.count;
    Array<float> pixels(&core.memory, size * options.samples, Array<float>::unset);
    for (std::uint32_t i = 0; i < options.samples; ++i) {
        const std::uint64_t bits = mix_in(options.seed, i);
        const std::size_t left = (bits & 0xffffffffU) * output.width >> 32, top = (bits >> 32) * output.height >> 32;
        float* to = &pixels[size * i];
        for (std::uint32_t c = 0; c < output.count; ++c)
            for (std::size_t y = 0; y < patch; ++y)
                for (std::size_t x = 0; x < patch; ++x)
                    *to++ = output.row(c, (top + y) % output.height)[(left + x) % output.width];
    }
    return pixels;
}

} // namespace

float texture_cost(Core& core, const weft_image& exemplar_image, const weft_image& output_image,
                   const weft_texture_cost_options& options, const Progress& progress)
{
    progress.at(0);
    const Planes exemplar = lab_planes(core, exemplar_image, function, "exemplar"),
                 output = lab_planes(core, output_image, function, "output");
    const Array<float> pixels = sample(core, output, options);
    const std::size_t patch = options.patch, area = patch * patch, sums = std::size_t{parts} * output.count;
    Array<float> own_sums(&core.memory, sums * options.samples, Array<float>::unset);
    Array<Sought> sought(&core.memory, options.samples, Array<Sought>::unset);
    Search search(core, exemplar, options.patch);
    for (std::uint32_t i = 0; i < options.samples; ++i) {
        const float* own = &pixels[area * output.count * i];
        for (std::size_t s = 0; s < sums; ++s)
            add_part(own + s % output.count * area, patch, 1,
                     part_of(options.patch, static_cast<std::uint32_t>(s / output.count)), &own_sums[sums * i + s]);
        sought[i] = {own, &own_sums[sums * i], FLT_MAX};
        search.probe(sought[i]);
    }
    for (std::uint32_t row = 0; row < search.rows(); row += band_rows) {
        progress.at(static_cast<double>(row) / search.rows());
        const std::uint32_t last = std::min(search.rows(), row + band_rows);
        search.prepare(row, last);
        core.parallel.for_each_index(options.samples, [&](std::uint32_t i) { search.look(sought[i], last); });
    }
    double sum = 0;
    for (const Sought& each : sought) sum += static_cast<double>(each.least);
    progress.at(1);
    return static_cast<float>(sum / options.samples / static_cast<double>(area));
}

} // namespace weft
