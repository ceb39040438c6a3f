/// weft_compare: checks, prepares both pictures once, and asks each metric in turn.
#include "analysis/compare.h"
#include "analysis/compare_metrics.h"
#include "base/image.h"
#include <algorithm>
#include <cfloat>

namespace weft {
namespace {

constexpr std::uint32_t least_side = 16;

void check_side(const char* name, const char* side, std::uint32_t pixels)
{
    require(pixels >= least_side, "weft_compare: ", name, "->", side, " is ", pixels, ", the least is ", least_side);
}

float narrow(double metric) noexcept { return static_cast<float>(std::min(metric, static_cast<double>(FLT_MAX))); }

/// The mean over the levels that are defined.
double mean_of_levels(const weft_comparison& comparison) noexcept
{
    double sum = 0, count = 0;
    for (const float level : comparison.patch_distance_level)
        if (level >= 0) sum += static_cast<double>(level), ++count;
    return count > 0 ? sum / count : undefined;
}

} // namespace

void compare(Core& core, const weft_image& exemplar, const weft_image& output, const weft_compare_options& options,
             const Progress& progress, weft_comparison& comparison)
{
    check_image(&exemplar, "weft_compare", "exemplar");
    check_image(&output, "weft_compare", "output");
    require(output.channels == exemplar.channels, "weft_compare: output->channels is ", output.channels,
            ", exemplar->channels is ", exemplar.channels);
    check_side("exemplar", "width", exemplar.width);
    check_side("exemplar", "height", exemplar.height);
    check_side("output", "width", output.width);
    check_side("output", "height", output.height);

    weft_comparison result = WEFT_COMPARISON_INIT;
    result.size = comparison.size;
    progress.at(0);
    const Pair pair = prepare_pair(core, exemplar, output, progress.part(0, 0.08));
    result.model_error = narrow(model_error(core, pair, progress.part(0.08, 0.16)));
    result.histogram_distance = narrow(histogram_distance(core, pair, options.seed, progress.part(0.16, 0.3)));
    result.autocovariance_error = narrow(autocovariance_error(core, pair, options.seed, progress.part(0.3, 0.38)));
    for (std::uint32_t level = 0; level < 3; ++level)
        result.patch_distance_level[level] = narrow(
            patch_distance(core, pair, level, options.seed, progress.part(0.38 + 0.12 * level, 0.5 + 0.12 * level)));
    result.patch_distance = narrow(mean_of_levels(result));
    result.repetition = narrow(repetition(core, pair, options.seed, progress.part(0.74, 0.82)));
    result.verbatim_copy = narrow(verbatim_copy(core, pair, options.seed, progress.part(0.82, 0.98)));
    result.seam_score = narrow(seam_score(core, pair, progress.part(0.98, 1)));
    comparison = result;
}

} // namespace weft
