/// Algorithm 1 of the paper: from coarse to fine, histogram, stationarity, patches, and again.
#include "analysis/stationarization.h"
#include "analysis/patch_match.h"
#include "analysis/stationarity_cost.h"
#include "analysis/stationarity_projection.h"
#include "analysis/tile_histogram.h"
#include "analysis/vote.h"
#include "base/elementary.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/image.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr const char* function = "weft_analyze_stationary";
constexpr std::uint32_t most_levels = 24, coarsest_iterations = 30, finer_iterations = 3;
/// Of the last vote: the middles of patches agree better than their rims, so the tile is sharper and keeps more of the
/// photo's histogram.
constexpr std::uint32_t last_patch = 7;
constexpr double ln2 = 0.6931471805599453, step_log2 = 0.37851162325372983; // of 1.3
constexpr double penalty_share = 0.3;                                       // of the mean distance

struct Level {
    std::uint32_t width, height, exemplar_width, exemplar_height, iterations;
    double begin, end; ///< its share of the work
};

struct Levels {
    std::uint32_t count = 0;
    Level levels[most_levels];
};

/// Sides grow by equal factors near 1.3. At the coarsest level neither tile nor exemplar is smaller than a patch.
Levels plan(const weft_image& photo, const weft_stationary_options& options)
{
    const std::uint32_t least = std::min({options.width, options.height, photo.width, photo.height});
    const double wanted = log2_of(options.start), room = log2_of(static_cast<double>(least) / options.patch);
    const double depth = std::max(0.0, std::min(wanted, room));
    Levels plan;
    plan.count = 1 + static_cast<std::uint32_t>(depth / step_log2 + 0.5);
    double work = 0;
    for (std::uint32_t i = 0; i < plan.count; ++i) {
        Level& level = plan.levels[i];
        const std::uint32_t below = plan.count - 1 - i;
        const double scale = below == 0 ? 1 : exponential_of_minus(ln2 * depth * below / (plan.count - 1));
        const auto side = [&](std::uint32_t full) {
            const auto even = 2 * static_cast<std::uint32_t>(full * scale / 2 + 0.5);
            return below == 0 ? full : std::max(std::min(even, full), options.patch);
        };
        level.width = side(options.width);
        level.height = side(options.height);
        const auto reduced_side = [&](std::uint32_t full, std::uint32_t part, std::uint32_t whole) {
            const auto nearest = static_cast<std::uint32_t>((std::uint64_t{full} * part + whole / 2) / whole);
            return std::min(full, std::max(nearest, options.patch));
        };
        level.exemplar_width = reduced_side(photo.width, level.width, options.width);
        level.exemplar_height = reduced_side(photo.height, level.height, options.height);
        level.iterations = i == 0 ? coarsest_iterations : finer_iterations;
        level.begin = work;
        work += (level.iterations + 1.0) * level.width * level.height;
        level.end = work;
    }
    for (Level& level : plan.levels) {
        level.begin /= work;
        level.end /= work;
    }
    return plan;
}

class Synthesis {
public:
    Synthesis(Core& core, const Planes& photo, const weft_stationary_options& options, const Progress& progress)
        : core_(core), options_(options), full_(lab_of(core, photo, progress))
    {
        require(varies(full_), function, ": photo is one colour");
        if (!options.sigma_map) return;
        factors_ = read_image(*options.sigma_map, &core.memory, core.parallel, function, "options->sigma_map");
        for (const float factor : factors_.values)
            require(factor >= 0 && factor <= 1, function, ": options->sigma_map has the value ", factor, ", not 0..1");
    }

    void run(const Levels& plan, const Progress& progress)
    {
        for (std::uint32_t i = 0; i < plan.count; ++i) {
            const Level& level = plan.levels[i];
            refine(plan, i, progress.part(level.begin, level.end));
        }
    }

    Correspondence correspondence() const
    {
        Correspondence result;
        result.photo_width = full_.width;
        result.photo_height = full_.height;
        result.patch = std::min(options_.patch, last_patch);
        result.x = Array<std::uint16_t>(&core_.memory, field_.area(), Array<std::uint16_t>::unset);
        result.y = Array<std::uint16_t>(&core_.memory, field_.area(), Array<std::uint16_t>::unset);
        for (std::size_t i = 0; i < field_.area(); ++i) {
            result.x[i] = field_.places[i].x;
            result.y[i] = field_.places[i].y;
        }
        return result;
    }
    /// In squared Lab units per pixel of a patch.
    double texture_cost() const noexcept
    {
        return mean_distance_ / (static_cast<double>(lab_scale) * lab_scale * field_.patch_pixels());
    }

private:
    static bool varies(const Lab_picture& picture) noexcept
    {
        const std::size_t size = picture.values.size(), n = picture.channels;
        for (std::size_t i = n; i < size; ++i)
            if (picture.values[i] != picture.values[i - n]) return true;
        return false;
    }

    void refine(const Levels& plan, std::uint32_t number, const Progress& progress)
    {
        const Level& level = plan.levels[number];
        const bool finest = number + 1 == plan.count;
        const Lab_picture coarse =
            finest ? Lab_picture()
                   : reduced(core_, full_, level.exemplar_width, level.exemplar_height, progress.part(0, 0.05));
        const Lab_picture& exemplar = finest ? full_ : coarse;
        start(plan, number, exemplar, progress.part(0.05, 0.07));
        const Value_counts goal(core_, exemplar, progress.part(0.07, 0.1));
        const std::uint32_t spacing =
            plan.count == 1 ? 5 : (2 * (plan.count - 1) + 3 * number + (plan.count - 1) / 2) / (plan.count - 1);
        const Neighbourhoods around(core_, level.width, level.height, options_.sigma,
                                    options_.sigma_map ? &factors_ : nullptr, spacing);
        Lab_picture tile(&core_.memory, level.width, level.height, exemplar.channels, field_.reach);
        Uniformity uniformity(core_, exemplar, field_);
        const Progress rest = progress.part(0.1, 1);
        vote(core_, field_, exemplar, tile, rest.part(0, 0.5 / (level.iterations + 0.5)));
        for (std::uint32_t i = 0; i < level.iterations; ++i) {
            watch(tile, i);
            const double share = 1 / (level.iterations + 0.5);
            const Progress part = rest.part((i + 0.5) * share, (i + 1.5) * share);
            match_histogram(core_, goal, tile, part.part(0, 0.05));
            if (options_.stationarity != WEFT_STATIONARITY_NONE)
                project(core_, around, options_.stationarity, options_.moments, tile, part.part(0.05, 0.3));
            tile.wrap();
            uniformity.count(core_, field_, penalty_share * mean_distance_, part.part(0.3, 0.35));
            const std::uint64_t key = mix_in(mix_in(options_.seed, number), i);
            mean_distance_ = search(core_, tile, exemplar, uniformity, (key & ~std::uint64_t{1}) | (i & 1), field_,
                                    part.part(0.35, 0.85));
            tell(plan, number, i);
            if (finest && i + 1 == level.iterations) return;
            weigh(core_, field_, part.part(0.85, 0.87));
            vote(core_, field_, exemplar, tile, part.part(0.87, 1));
        }
    }

    void start(const Levels& plan, std::uint32_t number, const Lab_picture& exemplar, const Progress& progress)
    {
        const Level& level = plan.levels[number];
        Match_field field(&core_.memory, level.width, level.height, options_.patch / 2);
        if (number == 0)
            scatter(core_, exemplar, mix_bits(options_.seed), field, progress);
        else
            rescale(core_, field_, plan.levels[number - 1].exemplar_width, plan.levels[number - 1].exemplar_height,
                    exemplar, field, progress);
        field_ = std::move(field);
    }

    /// For whoever is told: how stationary the tile is as it was voted; of a large one once a level, as it takes time.
    void watch(const Lab_picture& tile, std::uint32_t iteration)
    {
        constexpr std::size_t large = 128 * 128;
        if (!options_.report || (iteration > 0 && std::size_t{tile.width} * tile.height > large)) return;
        Planes lab(&core_.memory, tile.width, tile.height, tile.channels, Array<float>::unset);
        for (std::uint32_t y = 0; y < tile.height; ++y)
            for (std::uint32_t x = 0; x < tile.width; ++x)
                for (std::uint32_t c = 0; c < tile.channels; ++c)
                    lab.row(c, y)[x] = static_cast<float>(tile.at(x, y)[c]) / lab_scale;
        const weft_stationarity_options usual = {sizeof usual, WEFT_STATIONARITY_HISTOGRAM, 0.1f, 2};
        stationarity_cost_ = stationarity_cost(core_, lab, usual, Progress());
    }

    void tell(const Levels& plan, std::uint32_t number, std::uint32_t iteration) const
    {
        if (!options_.report) return;
        const Level& level = plan.levels[number];
        weft_stationary_step step{};
        step.size = sizeof step;
        step.level = number;
        step.levels = plan.count;
        step.iteration = iteration;
        step.iterations = level.iterations;
        step.width = level.width;
        step.height = level.height;
        step.texture_cost = static_cast<float>(texture_cost());
        step.stationarity_cost = stationarity_cost_;
        options_.report(options_.report_user, &step);
    }

    Core& core_;
    const weft_stationary_options& options_;
    const Lab_picture full_;
    Planes factors_;
    Match_field field_;
    double mean_distance_ = 0;
    float stationarity_cost_ = -1; ///< as last watched
};

} // namespace

Stationary_tile stationarize(Core& core, const weft_image& photo, const weft_stationary_options& options,
                             const Progress& progress)
{
    progress.at(0);
    const Planes planes = read_image(photo, &core.memory, core.parallel, function, "photo", progress.part(0, 0.02));
    Stationary_tile result;
    {
        Synthesis synthesis(core, planes, options, progress.part(0.02, 0.1));
        synthesis.run(plan(photo, options), progress.part(0.1, 0.97));
        result.origin = synthesis.correspondence();
        result.texture_cost = synthesis.texture_cost();
    }
    result.tile = assemble(planes, result.origin, options.width, options.height, &core.memory, core.parallel,
                           progress.part(0.97, 1));
    return result;
}

} // namespace weft
