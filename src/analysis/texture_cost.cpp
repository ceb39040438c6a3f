/// Exhaustive search: candidates side by side, rows of the patch in an order that tells early.
#include "analysis/texture_cost.h"
#include "analysis/lab_planes.h"
#include "base/hash.h"
#include "model/correspondence.h"
#include <algorithm>
#include <cfloat>

namespace weft {
namespace {

constexpr const char* function = "weft_texture_cost";
constexpr std::uint32_t candidates = 16, band = 64; ///< positions in a row at once; rows of positions between reports

/// One patch of the output, plane by plane, and the least distance so far.
struct Sought {
    const float* pixels;
    float least;
};

/// Rows of a patch, far apart first.
Array<std::uint32_t> row_order(std::pmr::memory_resource* memory, std::uint32_t patch)
{
    Array<std::uint32_t> order(memory, patch, Array<std::uint32_t>::unset);
    std::uint32_t step = 1;
    for (const std::uint32_t next : {7U, 5U, 3U})
        if (step == 1 && patch > next && patch % next != 0) step = next;
    for (std::uint32_t i = 0; i < patch; ++i) order[i] = i * step % patch;
    return order;
}

class Search {
public:
    Search(Core& core, const Planes& exemplar, std::uint32_t patch)
        : exemplar_(exemplar), patch_(patch), order_(row_order(&core.memory, patch)),
          columns_(exemplar.width - patch + 1)
    {
    }

    std::uint32_t rows() const noexcept { return exemplar_.height - patch_ + 1; }

    /// Positions whose top row is in [first, last).
    void look(Sought& sought, std::uint32_t first, std::uint32_t last) const noexcept
    {
        for (std::uint32_t y = first; y < last; ++y)
            for (std::uint32_t x = 0; x < columns_; x += candidates) {
                if (x + candidates <= columns_)
                    sought.least = std::min(sought.least, least_of<candidates>(sought, x, y));
                else
                    for (std::uint32_t rest = x; rest < columns_; ++rest)
                        sought.least = std::min(sought.least, least_of<1>(sought, rest, y));
            }
    }

private:
    template <std::uint32_t count> float least_of(const Sought& sought, std::uint32_t x, std::uint32_t y) const noexcept
    {
        float sums[count] = {};
        for (const std::uint32_t row : order_) {
            for (std::uint32_t c = 0; c < exemplar_.count; ++c) {
                const float* there = exemplar_.row(c, y + row) + x;
                const float* own = sought.pixels + (std::size_t{c} * patch_ + row) * patch_;
                for (std::uint32_t i = 0; i < patch_; ++i)
                    for (std::uint32_t k = 0; k < count; ++k) {
                        const float d = there[i + k] - own[i];
                        sums[k] += d * d;
                    }
            }
            if (*std::min_element(sums, sums + count) >= sought.least) return sought.least;
        }
        return *std::min_element(sums, sums + count);
    }

    const Planes& exemplar_;
    std::uint32_t patch_;
    Array<std::uint32_t> order_;
    std::uint32_t columns_;
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
    Array<Sought> sought(&core.memory, options.samples, Array<Sought>::unset);
    const std::size_t size = pixels.size() / options.samples;
    for (std::uint32_t i = 0; i < options.samples; ++i) sought[i] = {&pixels[size * i], FLT_MAX};
    const Search search(core, exemplar, options.patch);
    for (std::uint32_t row = 0; row < search.rows(); row += band) {
        progress.at(static_cast<double>(row) / search.rows());
        const std::uint32_t last = std::min(search.rows(), row + band);
        core.parallel.for_each_index(options.samples, [&](std::uint32_t i) { search.look(sought[i], row, last); });
    }
    double sum = 0;
    for (const Sought& each : sought) sum += static_cast<double>(each.least);
    progress.at(1);
    return static_cast<float>(sum / options.samples / (static_cast<double>(options.patch) * options.patch));
}

} // namespace weft
