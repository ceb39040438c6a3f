/// All cuts between many candidates at low resolution, then the best set of them by swaps from several random starts.
#include "analysis/wang_selection.h"
#include "analysis/compare_pair.h"
#include "analysis/wang_cut.h"
#include "base/hash.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace weft {
namespace {

constexpr std::uint32_t candidates = 96; ///< for north edges, and as many for west edges
constexpr std::uint32_t most_diamonds = 2 * most_wang_colours, coarse_knots = 40, bins = 8, values = 4 * bins;
constexpr double worst_weight = 0.5, common_weight = 0.5, likeness_weight = 0.3;

struct Candidate {
    Wang::Diamond corner;
    float histogram[values]; ///< of the texels of its diamond, a row for each feature, times the feature's weight
};

/// What sets of diamonds are judged by.
struct Table {
    std::uint32_t colours;
    std::uint32_t width, height; ///< of a cell, in the candidates' texels
    Array<Candidate> north, west;
    Array<float> errors;    ///< of the cuts between north i and west j: [i][j][quarter]
    Array<float> common;    ///< of each two candidates, the west ones after the north ones
    float exemplar[values]; ///< its histogram

    const Candidate& at(std::uint32_t edge, std::uint32_t choice) const noexcept
    {
        return edge < colours ? north[choice] : west[choice];
    }
    std::uint32_t row(std::uint32_t edge, std::uint32_t choice) const noexcept
    {
        return edge < colours ? choice : candidates + choice;
    }
    float common_of(std::uint32_t row_a, std::uint32_t row_b) const noexcept
    {
        return common[std::size_t{row_a} * 2 * candidates + row_b];
    }
    const float* cuts(std::uint32_t i, std::uint32_t j) const noexcept
    {
        return errors.data() + (std::size_t{i} * candidates + j) * 4;
    }
};

/// Points that fill a square evenly (Roberts's sequence by the plastic number), shifted by the seed.
Wang::Diamond spread(std::uint64_t seed, std::uint32_t i, std::uint32_t across, std::uint32_t down) noexcept
{
    const std::uint64_t x = mix_bits(seed) + (i + 1) * 0xc13fa9a902a6328fU,
                        y = mix_bits(seed + 1) + (i + 1) * 0x91e10da5c79e7b1dU;
    return {static_cast<std::int32_t>((x >> 32) * across >> 32), static_cast<std::int32_t>((y >> 32) * down >> 32)};
}

/// Histograms of features: eight bins of half a standard deviation.
class Bins {
public:
    explicit Bins(const Features& features) noexcept
    {
        double square[4] = {}, total = 0;
        for (const Feature& pixel : features.pixels)
            for (int c = 0; c < 4; ++c)
                square[c] += static_cast<double>(pixel.value[c]) * static_cast<double>(pixel.value[c]);
        for (const double sum : square) total += sum;
        for (int c = 0; c < 4 && total > 0; ++c) {
            const double deviation = std::sqrt(square[c] / static_cast<double>(features.pixels.size()));
            scale_[c] = deviation > 0 ? static_cast<float>(2 / deviation) : 0;
            weight_[c] = static_cast<float>(square[c] / total);
        }
    }
    void add(const Feature& pixel, float* histogram) const noexcept
    {
        for (std::uint32_t c = 0; c < 4; ++c) {
            const float bin = std::clamp(pixel.value[c] * scale_[c] + 0.5f * bins, 0.0f, bins - 1.0f);
            histogram[c * bins + static_cast<std::uint32_t>(bin)] += weight_[c];
        }
    }

private:
    float scale_[4] = {}, weight_[4] = {};
};

void divide(float* histogram, std::uint64_t count) noexcept
{
    for (std::uint32_t i = 0; i < values && count; ++i) histogram[i] /= static_cast<float>(count);
}

void describe(const Features& features, const Bins& of, std::uint32_t width, std::uint32_t height, Candidate& candidate)
{
    std::uint64_t count = 0;
    for (std::uint32_t y = 0; y < height; ++y) {
        const std::uint32_t from_middle = y < height / 2 ? height / 2 - y : y - height / 2;
        const std::uint32_t half = (height / 2 - std::min(from_middle, height / 2)) * width / height;
        for (std::uint32_t x = width / 2 - half; x < width / 2 + half; ++x, ++count)
            of.add(features.at(static_cast<std::uint32_t>(candidate.corner.x) + x,
                               static_cast<std::uint32_t>(candidate.corner.y) + y),
                   candidate.histogram);
    }
    divide(candidate.histogram, count);
}

/// What two diamonds have in common: twins of each other's texels, the more so the more these stand out. 1: all of it.
float common_of(const Features& features, const Table& table, Wang::Diamond a, Wang::Diamond b) noexcept
{
    const auto w = static_cast<std::int32_t>(table.width), h = static_cast<std::int32_t>(table.height);
    const std::int32_t dx = b.x - a.x, dy = b.y - a.y, step = std::max(1, std::max(w, h) / 16);
    const auto inside = [w, h](std::int32_t x, std::int32_t y) {
        return std::abs(2 * x + 1 - w) * h + std::abs(2 * y + 1 - h) * w < w * h;
    };
    float common = 0, all = 0;
    for (std::int32_t y = step / 2; y < h; y += step)
        for (std::int32_t x = step / 2; x < w; x += step) {
            if (!inside(x, y)) continue;
            all += 1;
            if (inside(x - dx, y - dy))
                common +=
                    2 * square_of(features.at(static_cast<std::size_t>(a.x + x), static_cast<std::size_t>(a.y + y)));
        }
    return all > 0 ? common / all : 0;
}

struct Choice {
    std::uint32_t of[most_diamonds] = {};
    double cost = std::numeric_limits<double>::max();
};

double cost_of(const Table& table, const Choice& choice) noexcept
{
    const std::uint32_t n = table.colours;
    double worst = 0, sum = 0, common = 0, unlike = 0;
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j)
            for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
                const auto error = static_cast<double>(table.cuts(choice.of[i], choice.of[n + j])[quarter]);
                worst = std::max(worst, error);
                sum += error;
            }
    float histogram[values] = {};
    for (std::uint32_t i = 0; i < 2 * n; ++i) {
        const Candidate& one = table.at(i, choice.of[i]);
        for (std::uint32_t j = 0; j < i; ++j)
            common += static_cast<double>(table.common_of(table.row(i, choice.of[i]), table.row(j, choice.of[j])));
        for (std::uint32_t k = 0; k < values; ++k) histogram[k] += one.histogram[k];
    }
    for (std::uint32_t k = 0; k < values; ++k)
        unlike += 0.5 * static_cast<double>(std::abs(histogram[k] / static_cast<float>(2 * n) - table.exemplar[k]));
    return worst_weight * worst + sum / (4.0 * n * n) + common_weight * common / n + likeness_weight * unlike;
}

/// Swaps one diamond at a time for the best candidate until none is better.
Choice best_from(const Table& table, std::uint64_t seed) noexcept
{
    Choice best;
    for (std::uint32_t i = 0; i < 2 * table.colours; ++i)
        best.of[i] = static_cast<std::uint32_t>(mix_in(seed, i) % candidates);
    best.cost = cost_of(table, best);
    for (bool better = true; better;) {
        better = false;
        for (std::uint32_t i = 0; i < 2 * table.colours; ++i)
            for (std::uint32_t k = 0; k < candidates; ++k) {
                Choice other = best;
                other.of[i] = k;
                other.cost = cost_of(table, other);
                if (other.cost >= best.cost) continue;
                best = other;
                better = true;
            }
    }
    return best;
}

Table table_of(Core& core, const Features& features, const Wang& coarse, std::uint64_t seed, const Progress& progress)
{
    Table table{};
    table.colours = coarse.colours;
    table.width = coarse.width;
    table.height = coarse.height;
    table.north = Array<Candidate>(&core.memory, candidates);
    table.west = Array<Candidate>(&core.memory, candidates);
    table.errors = Array<float>(&core.memory, std::size_t{candidates} * candidates * 4);
    table.common = Array<float>(&core.memory, std::size_t{4} * candidates * candidates);
    const Bins of(features);
    for (const Feature& pixel : features.pixels) of.add(pixel, table.exemplar);
    divide(table.exemplar, features.pixels.size());
    const std::uint32_t across = features.width - coarse.width + 1, down = features.height - coarse.height + 1;
    core.parallel.for_each_index(candidates, [&](std::uint32_t i) {
        table.north[i].corner = spread(seed, i, across, down);
        table.west[i].corner = spread(seed, candidates + i, across, down);
        describe(features, of, coarse.width, coarse.height, table.north[i]);
        describe(features, of, coarse.width, coarse.height, table.west[i]);
    });
    progress.at(0);
    core.parallel.for_each_index(2 * candidates, [&](std::uint32_t i) {
        const auto corner = [&](std::uint32_t k) {
            return k < candidates ? table.north[k].corner : table.west[k - candidates].corner;
        };
        for (std::uint32_t j = 0; j < 2 * candidates; ++j)
            table.common[std::size_t{i} * 2 * candidates + j] = common_of(features, table, corner(i), corner(j));
    });
    progress.at(0);
    const double cost = 4.0 * candidates * 20 * coarse.knots * coarse.knots;
    for_each_step(core, candidates, cost, progress, [&](std::uint32_t i) {
        for (std::uint32_t j = 0; j < candidates; ++j)
            for (std::uint32_t q = 0; q < 4; ++q) {
                const Quarter quarter{coarse.width, coarse.height, coarse.knots, q / 2, q % 2};
                table.errors[(std::size_t{i} * candidates + j) * 4 + q] =
                    cut_quarter(&core.memory, features, quarter, table.north[i].corner, table.west[j].corner, nullptr)
                        .error;
            }
    });
    return table;
}

/// The best set of diamonds that is found.
void choose(Core& core, const Table& table, std::uint64_t seed, Wang& coarse, const Progress& progress)
{
    const std::uint32_t n = table.colours, starts = std::clamp(512 / (n * n), 2U, 32U);
    Array<Choice> found(&core.memory, starts);
    for_each_step(core, starts, 3e6 * n * n, progress,
                  [&](std::uint32_t i) { found[i] = best_from(table, mix_in(seed, i)); });
    const Choice& best =
        *std::min_element(found.begin(), found.end(), [](const Choice& a, const Choice& b) { return a.cost < b.cost; });
    for (std::uint32_t i = 0; i < 2 * n; ++i) coarse.diamonds[i] = table.at(i, best.of[i]).corner;
}

/// Mean and worst of the cuts of one edge's diamond with all of the other direction.
double cuts_of(std::pmr::memory_resource* memory, const Features& features, const Wang& wang, std::uint32_t edge,
               Wang::Diamond corner)
{
    const std::uint32_t n = wang.colours;
    double worst = 0, sum = 0;
    for (std::uint32_t other = 0; other < n; ++other)
        for (std::uint32_t q = 0; q < 4; ++q) {
            const Wang::Diamond north = edge < n ? corner : wang.diamonds[other],
                                west = edge < n ? wang.diamonds[n + other] : corner;
            const Quarter quarter{wang.width, wang.height, wang.knots, q / 2, q % 2};
            const auto error = static_cast<double>(cut_quarter(memory, features, quarter, north, west, nullptr).error);
            worst = std::max(worst, error);
            sum += error;
        }
    return sum / (4 * n) + worst_weight * worst;
}

/// Moves one diamond after another to where its cuts cost less, by steps of 2 and 1.
void settle(Core& core, const Features& features, Wang& wang, const Progress& progress)
{
    constexpr std::uint32_t ways = 9, steps = 4;
    const auto right = static_cast<std::int32_t>(features.width - wang.width),
               bottom = static_cast<std::int32_t>(features.height - wang.height);
    const std::uint32_t edges = 2 * wang.colours;
    for (std::uint32_t i = 0; i < steps * edges; ++i) {
        const std::uint32_t edge = i % edges;
        const std::int32_t step = i / edges % 2 == 0 ? 2 : 1;
        const Wang::Diamond from = wang.diamonds[edge];
        const auto moved = [&](std::uint32_t way) { // the first way is to stay
            const auto k = static_cast<std::int32_t>((way + 4) % ways);
            return Wang::Diamond{std::clamp(from.x + (k % 3 - 1) * step, 0, right),
                                 std::clamp(from.y + (k / 3 - 1) * step, 0, bottom)};
        };
        double costs[ways];
        core.parallel.for_each_index(
            ways, [&](std::uint32_t way) { costs[way] = cuts_of(&core.memory, features, wang, edge, moved(way)); });
        wang.diamonds[edge] = moved(static_cast<std::uint32_t>(std::min_element(costs, costs + ways) - costs));
        progress.at((i + 1.0) / (steps * edges));
    }
}

} // namespace

void select_diamonds(Core& core, const Features& features, std::uint64_t seed, Wang& wang, const Progress& progress)
{
    Features small;
    const Features* coarse_features = &features;
    Wang coarse;
    coarse.colours = wang.colours;
    std::uint32_t level = 0;
    while (std::max(wang.width, wang.height) / 2 >> level > coarse_knots) {
        small = halved(core, *coarse_features);
        coarse_features = &small;
        ++level;
    }
    coarse.width = std::max(4U, wang.width >> level & ~1U);
    coarse.height = std::max(4U, wang.height >> level & ~1U);
    coarse.knots = std::max(coarse.width, coarse.height) / 2;
    coarse.diamonds = Array<Wang::Diamond>(&core.memory, wang.diamonds.size());
    choose(core, table_of(core, *coarse_features, coarse, seed, progress.part(0, 0.6)), seed, coarse,
           progress.part(0.6, 0.8));
    settle(core, *coarse_features, coarse, progress.part(0.8, 1));
    for (std::size_t i = 0; i < wang.diamonds.size(); ++i)
        wang.diamonds[i] = {
            std::min(coarse.diamonds[i].x << level, static_cast<std::int32_t>(features.width - wang.width)),
            std::min(coarse.diamonds[i].y << level, static_cast<std::int32_t>(features.height - wang.height))};
}

} // namespace weft
