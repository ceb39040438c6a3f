/// First the columns, then the rows of the result: what lies beyond the period is laid over the beginning.
#include "analysis/structure_torus.h"
#include "analysis/compare_pair.h"
#include <algorithm>
#include <limits>

namespace weft {
namespace {

constexpr std::uint32_t most_band = 64;
constexpr float half_feather = 2.5f, least_share = 0.7f;
constexpr float length_worth = 0.05f; ///< what a whole size is better than none, in errors
constexpr float seen = 0.1f;          ///< error along a cut that contents should not repeat
constexpr float never = std::numeric_limits<float>::max() / 4;

/// A picture seen so that the cut runs along its lines, across which the period is.
struct Lines {
    const Features& features;
    bool rows; ///< lines are rows: the period is of y

    std::uint32_t count() const noexcept { return rows ? features.width : features.height; }
    std::uint32_t length() const noexcept { return rows ? features.height : features.width; }
    /// Squared difference between place `at` of a line and the place a period later.
    float error(std::uint32_t line, std::uint32_t at, std::uint32_t period) const noexcept
    {
        return rows ? distance(features.at(line, at), features.at(line, at + period))
                    : distance(features.at(at, line), features.at(at + period, line));
    }
};

struct Seam {
    std::uint32_t period = 0;
    float error = never;        ///< mean along the seam
    Array<std::uint32_t> place; ///< of each line, if asked for: from there on the beginning is seen
};

/// The cheapest seam in the band; `closed`: its ends meet, if they can.
class Seam_finder {
public:
    Seam_finder(std::pmr::memory_resource* memory, const Lines& lines, std::uint32_t band)
        : lines_(lines), band_(band), margin_(std::min(3U, band / 4)), cost_(memory, 2 * std::size_t{band}),
          step_(memory, std::size_t{lines.count()} * band)
    {
    }
    /// Starts and ends at `place`, if that is one of the band.
    Seam find(std::pmr::memory_resource* memory, std::uint32_t period, std::uint32_t place, bool want_places)
    {
        const std::uint32_t count = lines_.count();
        float *last = cost_.data(), *next = last + band_;
        for (std::uint32_t line = 0; line < count; ++line) {
            for (std::uint32_t x = 0; x < band_; ++x) next[x] = never;
            for (std::uint32_t x = margin_; x < band_ - margin_; ++x) {
                const bool barred = place < band_ && line == 0 && x != place;
                if (!barred) next[x] = lines_.error(line, x, period) + (line > 0 ? cheapest(line, x, last) : 0);
            }
            std::swap(last, next);
        }
        const auto end =
            static_cast<std::uint32_t>(place < band_ ? place : std::min_element(last, last + band_) - last);
        Seam seam{period, last[end] / static_cast<float>(count), {}};
        if (want_places) trace(memory, end, seam);
        return seam;
    }

private:
    float cheapest(std::uint32_t line, std::uint32_t x, const float* last) noexcept
    {
        float best = last[x];
        std::int8_t step = 0;
        if (x > 0 && last[x - 1] < best) {
            best = last[x - 1];
            step = -1;
        }
        if (x + 1 < band_ && last[x + 1] < best) {
            best = last[x + 1];
            step = 1;
        }
        step_[std::size_t{line} * band_ + x] = step;
        return best;
    }
    void trace(std::pmr::memory_resource* memory, std::uint32_t end, Seam& seam) const
    {
        seam.place = Array<std::uint32_t>(memory, lines_.count());
        for (std::uint32_t line = lines_.count(); line-- > 0;) {
            seam.place[line] = end;
            end = static_cast<std::uint32_t>(static_cast<std::int32_t>(end) + step_[std::size_t{line} * band_ + end]);
        }
    }

    const Lines& lines_;
    std::uint32_t band_, margin_;
    Array<float> cost_;
    Array<std::int8_t> step_;
};

Seam best_seam(Core& core, const Lines& lines, bool closed, const Progress& progress)
{
    const std::uint32_t length = lines.length(), band = std::min(most_band, length / 8);
    const auto least = static_cast<std::uint32_t>(least_share * static_cast<float>(length));
    const std::uint32_t periods = length - band - least + 1, nowhere = band;
    Array<float> errors(&core.memory, periods);
    for_each_step(core, periods, 20.0 * band * lines.count(), progress, [&](std::uint32_t i) {
        errors[i] = Seam_finder(&core.memory, lines, band).find(&core.memory, least + i, nowhere, false).error -
                    length_worth * static_cast<float>(least + i) / static_cast<float>(length);
    });
    const auto best = static_cast<std::uint32_t>(std::min_element(errors.begin(), errors.end()) - errors.begin());
    Seam_finder finder(&core.memory, lines, band);
    Seam seam = finder.find(&core.memory, least + best, nowhere, true);
    if (!closed) return seam;
    const std::uint32_t middle = seam.place[seam.place.size() / 2];
    Seam round = finder.find(&core.memory, seam.period, seam.place[0], true),
         other = finder.find(&core.memory, seam.period, middle, true);
    return other.error < round.error ? std::move(other) : std::move(round);
}

/// Share of the beginning at place `at`, where the seam of that line is at `place`.
float share_of(std::uint32_t at, std::uint32_t place) noexcept
{
    const float beyond = static_cast<float>(at) - static_cast<float>(place);
    return std::clamp(0.5f + beyond / (2 * half_feather), 0.0f, 1.0f);
}

Planes folded(Core& core, const Planes& planes, const Seam& seam, bool rows)
{
    Planes result(&core.memory, rows ? planes.width : seam.period, rows ? seam.period : planes.height, planes.count,
                  Array<float>::unset);
    for (std::uint32_t c = 0; c < planes.count; ++c)
        for (std::uint32_t y = 0; y < result.height; ++y)
            for (std::uint32_t x = 0; x < result.width; ++x) {
                const std::uint32_t at = rows ? y : x;
                const bool twice = at + seam.period < (rows ? planes.height : planes.width); // bands may be narrow
                const float share = twice ? share_of(at, seam.place[rows ? x : y]) : 1, here = planes.row(c, y)[x];
                float& to = result.row(c, y)[x];
                to = here;
                if (share < 1) {
                    const float later = rows ? planes.row(c, y + seam.period)[x] : planes.row(c, y)[x + seam.period];
                    to = later + share * (here - later);
                }
            }
    return result;
}

Features folded(Core& core, const Features& features, const Seam& seam)
{
    Features result(&core.memory, seam.period, features.height);
    for (std::uint32_t y = 0; y < result.height; ++y)
        for (std::uint32_t x = 0; x < result.width; ++x) {
            const float share = x + seam.period < features.width ? share_of(x, seam.place[y]) : 1;
            result.at(x, y) =
                share < 1 ? lerp(features.at(x + seam.period, y), features.at(x, y), share) : features.at(x, y);
        }
    return result;
}

std::uint32_t beyond(const Seam& seam) noexcept
{
    return seam.error < seen ? 0 : *std::max_element(seam.place.begin(), seam.place.end()) + 3;
}

} // namespace

Torus torus_of(Core& core, const Features& features, const Planes& structure, const Progress& progress)
{
    const Seam across = best_seam(core, {features, false}, false, progress.part(0, 0.5));
    const Features cylinder = folded(core, features, across);
    const Seam down = best_seam(core, {cylinder, true}, true, progress.part(0.5, 1));
    Torus torus{folded(core, folded(core, structure, across, false), down, true), beyond(across), beyond(down)};
    return torus;
}

} // namespace weft
