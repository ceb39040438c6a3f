/// How much an output's borders stand out when it is laid side by side with itself.
#include "analysis/compare_metrics.h"
#include <algorithm>
#include <cmath>

namespace weft {
namespace {

/// Mean moduli of the differences between each line and the next, around the border.
struct Differences {
    Array<double> first;  ///< [i]: between lines i and i + 1; the last one is the border
    Array<double> second; ///< [i]: of the two second differences that reach across the same gap
};

struct Lines {
    const Planes& planes;
    bool columns;

    std::size_t count() const noexcept { return columns ? planes.width : planes.height; }
    std::size_t length() const noexcept { return columns ? planes.height : planes.width; }
    double at(std::uint32_t c, std::size_t line, std::size_t i) const noexcept
    {
        const std::size_t around = line < count() ? line : line - count();
        return static_cast<double>(columns ? planes.row(c, i)[around] : planes.row(c, around)[i]);
    }
};

/// Lines are taken in runs of 16, so that columns are read a cache line at a time.
Differences differences_of(Core& core, const Lines& lines, const Progress& progress)
{
    constexpr std::size_t run_length = 16;
    const std::size_t count = lines.count(), length = lines.length();
    Differences result{Array<double>(&core.memory, count), Array<double>(&core.memory, count)};
    const auto runs = static_cast<std::uint32_t>((count + run_length - 1) / run_length);
    const double scale = 1 / static_cast<double>(length * lines.planes.count);
    for_each_step(core, runs, static_cast<double>(run_length * length * lines.planes.count) * 4, progress,
                  [&](std::uint32_t run) {
                      const std::size_t begin = run * run_length, end = std::min(count, begin + run_length);
                      const auto add = [&](std::uint32_t c, std::size_t line, std::size_t i) {
                          const double a = lines.at(c, line + count - 1, i), b = lines.at(c, line, i),
                                       d = lines.at(c, line + 1, i), e = lines.at(c, line + 2, i);
                          result.first[line] += scale * std::abs(d - b);
                          result.second[line] += scale * (std::abs(a - 2 * b + d) + std::abs(b - 2 * d + e));
                      };
                      for (std::uint32_t c = 0; c < lines.planes.count; ++c)
                          if (lines.columns)
                              for (std::size_t i = 0; i < length; ++i)
                                  for (std::size_t line = begin; line < end; ++line) add(c, line, i);
                          else
                              for (std::size_t line = begin; line < end; ++line)
                                  for (std::size_t i = 0; i < length; ++i) add(c, line, i);
                  });
    return result;
}

/// How many standard deviations the border's value is from the mean of the inner ones, [margin, size - 1 - margin).
double outlyingness(const Array<double>& values, std::size_t margin) noexcept
{
    const std::size_t begin = margin, end = values.size() - 1 - margin;
    const double count = static_cast<double>(end - begin);
    double sum = 0, squares = 0;
    for (std::size_t i = begin; i < end; ++i) sum += values[i];
    const double mean = sum / count;
    for (std::size_t i = begin; i < end; ++i) squares += (values[i] - mean) * (values[i] - mean);
    const double deviation = std::sqrt(squares / count);
    return deviation > 1e-12 * mean ? std::abs(values[values.size() - 1] - mean) / deviation : undefined;
}

} // namespace

double seam_score(Core& core, const Pair& pair, const Progress& progress)
{
    if (!pair.output_varies) return undefined;
    double score = undefined;
    for (const bool columns : {true, false}) {
        const Differences differences =
            differences_of(core, Lines{pair.output, columns}, columns ? progress.part(0, 0.5) : progress.part(0.5, 1));
        score = std::max({score, outlyingness(differences.first, 0), outlyingness(differences.second, 1)});
    }
    return score;
}

} // namespace weft
