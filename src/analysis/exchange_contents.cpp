/// All transforms of all patches; of each patch the best contents are kept, and tables made of them.
#include "analysis/exchange_contents.h"
#include "analysis/compare_pair.h"
#include "analysis/exchange_contour.h"
#include <algorithm>
#include <vector>

namespace weft {
namespace {

constexpr float good_error = 0.12f, poor_error = 0.24f; ///< along a contour; 1 is chance
constexpr float hopeless = 0.5f;                        ///< near the border: no contour will be good enough
constexpr std::uint32_t wanted = 4, most_borne = 12, most_others = 8, most_per_transform = 3;
constexpr std::uint32_t transforms = turns_offered * scales_offered, most_kept = most_borne + most_others;
constexpr std::uint32_t least_depth = 40; ///< of a patch that shows anything within contour and feather
constexpr float least_side = 24, sides = 8;

constexpr std::uint32_t map_in_left = 0x40000000U, map_in_above = 0x80000000U; ///< as weft_exchange

struct Kept {
    Found place;
    Content_contour contour;
};

/// A patch of one of the views, and what it may show.
struct Candidate_patch {
    std::uint32_t view, patch;
    Patch_frame frame;
    std::uint32_t count;
    Kept kept[most_kept];
};

struct Mapped_view {
    View view;
    Patches_of_view patches;
    Array<Patch_frame> frames;
};

/// What was found of all transforms of a patch, each in order of the errors along their contours.
struct Offers {
    Kept kept[transforms][most_per_transform];
    std::uint32_t count[transforms];
};

bool better(const Kept& a, const Kept& b) noexcept { return a.contour.error < b.contour.error; }

void search(std::pmr::memory_resource* memory, const Search_pictures& pictures, const Patch_shape& shape,
            std::uint32_t transform, Offers& offers)
{
    Found found[most_found];
    const std::uint32_t count =
        find_contents(memory, pictures, shape, transform / scales_offered, transform % scales_offered, found);
    Kept all[most_found];
    std::uint32_t cut = 0;
    for (std::uint32_t i = 0; i < count; ++i)
        if (found[i].error < hopeless) all[cut++] = {found[i], contour_of(pictures, shape, found[i])};
    std::stable_sort(all, all + cut, better);
    offers.count[transform] = std::min(cut, most_per_transform);
    std::copy_n(all, offers.count[transform], offers.kept[transform]);
}

bool alike(const Found& a, const Found& b, std::int32_t far) noexcept
{
    const std::int64_t dx = a.x - b.x, dy = a.y - b.y;
    return a.turn == b.turn && dx * dx + dy * dy < std::int64_t{far} * far;
}

/// Good ones up to `most`; of poor ones as many as are wanted.
void keep(const Kept* all, std::uint32_t count, std::uint32_t most, std::int32_t far, Candidate_patch& patch) noexcept
{
    const std::uint32_t first = patch.count;
    for (std::uint32_t i = 0; i < count && patch.count < first + most; ++i) {
        const float error = all[i].contour.error;
        if (error > poor_error || (error > good_error && patch.count >= first + wanted)) break;
        const Kept* const last = patch.kept + patch.count;
        if (std::any_of<const Kept*>(patch.kept, last,
                                     [&](const Kept& k) { return alike(k.place, all[i].place, far); }))
            continue;
        patch.kept[patch.count++] = all[i];
    }
}

/// The best of those transforms that are borne, or of the others.
void choose(const Offers& offers, const Bearing& bearing, bool borne, std::int32_t far, Candidate_patch& patch)
{
    Kept all[transforms * most_per_transform];
    std::uint32_t count = 0;
    for (std::uint32_t t = 0; t < transforms; ++t)
        if (bearing.bears(t / scales_offered, t % scales_offered) == borne) {
            std::copy_n(offers.kept[t], offers.count[t], all + count);
            count += offers.count[t];
        }
    std::stable_sort(all, all + count, better);
    keep(all, count, borne ? most_borne : most_others, far, patch);
}

using Mapped_views = std::pmr::vector<Mapped_view>;

Mapped_views views_of(Core& core, const Features& features, const Wang& wang, const Progress& progress)
{
    const float side = std::max(least_side, static_cast<float>(std::min(features.width, features.height)) / sides);
    Mapped_views views(wang.colours ? 2 * wang.colours : 1, &core.memory);
    for (std::uint32_t i = 0; i < views.size(); ++i) {
        Mapped_view& to = views[i];
        const double all = static_cast<double>(views.size());
        to.view = wang.colours ? diamond_view(&core.memory, wang, i) : torus_view(&core.memory, features);
        to.patches = patches_of(core, features, to.view, side, progress.part(i / all, (i + 1) / all));
        to.frames = frames_of(&core.memory, to.view, to.patches);
    }
    return views;
}

Array<Candidate_patch> candidates_of(Core& core, const Mapped_views& views)
{
    std::size_t count = 0;
    for (const Mapped_view& view : views) count += view.patches.count;
    Array<Candidate_patch> candidates(&core.memory, count);
    count = 0;
    for (std::uint32_t v = 0; v < views.size(); ++v)
        for (std::uint32_t k = 0; k < views[v].patches.count; ++k)
            candidates[count++] = {v, k, views[v].frames[k], 0, {}};
    return candidates;
}

/// One map after another: patches are numbered through all views.
void draw_map(const Mapped_view& view, std::uint32_t first, std::uint32_t* map) noexcept
{
    const Patches_of_view& patches = view.patches;
    for (std::uint32_t y = 0; y < view.view.height; ++y)
        for (std::uint32_t x = 0; x < view.view.width; ++x) {
            const std::size_t i = std::size_t{y} * view.view.width + x;
            const std::uint32_t k = patches.patch[i];
            if (k == no_patch) continue;
            const Patch_frame& frame = view.frames[k];
            map[i] = (first + k) | std::uint32_t{patches.depth[i]} << map_depth_shift;
            if (static_cast<std::int32_t>(x) < frame.left) map[i] |= map_in_left;
            if (static_cast<std::int32_t>(y) < frame.top) map[i] |= map_in_above;
        }
}

std::int32_t wrapped(std::int32_t place, std::uint32_t size) noexcept
{
    return place % static_cast<std::int32_t>(size);
}

Exchange tables_of(Core& core, const Features& features, const Mapped_views& views,
                   const Array<Candidate_patch>& candidates)
{
    Exchange exchange;
    std::size_t contents = candidates.size(), area = 0;
    for (const Candidate_patch& patch : candidates) contents += patch.count;
    for (const Mapped_view& view : views) area += view.view.area();
    exchange.map = Array<std::uint32_t>(&core.memory, area);
    exchange.patches = Array<Exchange::Patch>(&core.memory, candidates.size());
    exchange.contents = Array<Exchange::Content>(&core.memory, contents);
    exchange.contours = Array<std::uint8_t>(&core.memory, contents * contour_knots);
    std::uint32_t first = 0;
    std::uint32_t* map = exchange.map.data();
    for (const Mapped_view& view : views) {
        draw_map(view, first, map);
        first += view.patches.count;
        map += view.view.area();
    }
    std::uint32_t next = 0;
    for (std::size_t p = 0; p < candidates.size(); ++p) {
        const Candidate_patch& patch = candidates[p];
        const View& view = views[patch.view].view;
        exchange.patches[p] = {patch.frame.x, patch.frame.y, next, patch.count + 1};
        exchange.contents[next] = {wrapped(view.x + patch.frame.x, features.width),
                                   wrapped(view.y + patch.frame.y, features.height), 0, 1};
        std::fill_n(exchange.contours.data() + std::size_t{next++} * contour_knots, contour_knots, std::uint8_t{255});
        for (std::uint32_t i = 0; i < patch.count; ++i) {
            const Kept& kept = patch.kept[i];
            exchange.contents[next] = {kept.place.x, kept.place.y, kept.place.turn, offered_scale[kept.place.scale]};
            std::copy_n(kept.contour.depths, contour_knots,
                        exchange.contours.data() + std::size_t{next++} * contour_knots);
        }
    }
    return exchange;
}

} // namespace

Exchange exchange_of(Core& core, const Features& features, const Wang& wang, const Bounds& bounds,
                     const Bearing& bearing, const Progress& progress)
{
    if (std::min(features.width, features.height) < static_cast<std::uint32_t>(3 * least_side)) return {};
    const Mapped_views views = views_of(core, features, wang, progress.part(0, 0.15));
    const Search_pictures pictures = search_pictures_of(core, features, bounds);
    Array<Candidate_patch> candidates = candidates_of(core, views);
    const auto count = static_cast<std::uint32_t>(candidates.size());
    Array<Offers> offers(&core.memory, count);
    for_each_step(core, count * turns_offered, 4e6, progress.part(0.15, 1), [&](std::uint32_t i) {
        const Candidate_patch& patch = candidates[i / turns_offered];
        const Mapped_view& view = views[patch.view];
        const Patch_shape shape = shape_of(&core.memory, features, view.view, view.patches, patch.frame, patch.patch);
        if (shape.deepest < least_depth) return;
        for (std::uint32_t scale = 0; scale < scales_offered; ++scale)
            search(&core.memory, pictures, shape, i % turns_offered * scales_offered + scale,
                   offers[i / turns_offered]);
    });
    const auto far = static_cast<std::int32_t>(std::max(features.width, features.height) / 24);
    for (std::uint32_t i = 0; i < count; ++i)
        for (const bool borne : {true, false}) choose(offers[i], bearing, borne, far, candidates[i]);
    if (std::none_of(candidates.begin(), candidates.end(), [](const Candidate_patch& p) { return p.count > 0; }))
        return {};
    return tables_of(core, features, views, candidates);
}

} // namespace weft
