/// Averages in double, each rounded to float once, in a fixed order: the same on every machine.
#include "synthesis/mips.h"
#include "synthesis/refinement.h"
#include <algorithm>
#include <cmath>
#include <functional>

namespace weft {

namespace {

void publish(Mip_chain& chain, const Planes& zero, std::uint32_t images, std::uint32_t levels) noexcept
{
    chain.mips.size = sizeof chain.mips;
    chain.mips.width = zero.width;
    chain.mips.height = zero.height;
    chain.mips.planes = zero.count / images;
    chain.mips.images = images;
    chain.mips.levels = levels;
    chain.mips.level = chain.level;
    for (std::uint32_t l = 0; l < levels; ++l) {
        const Planes& planes = l == 0 && chain.own[0].values.empty() ? zero : chain.own[l];
        chain.level[l] = {planes.values.data(),
                          planes.width,
                          planes.height,
                          0,
                          0,
                          static_cast<float>(planes.width) / static_cast<float>(zero.width),
                          static_cast<float>(planes.height) / static_cast<float>(zero.height)};
    }
}

/// Calls row(c, y) for every row of the planes.
void for_each_row(const Planes& planes, Parallel& parallel,
                  const std::function<void(std::uint32_t, std::uint32_t)>& row)
{
    const std::uint32_t step = std::max(1U, 16384U / planes.width), tasks = (planes.height + step - 1) / step;
    const auto work = [&](std::uint32_t task) {
        const std::uint32_t end = std::min(planes.height, (task + 1) * step);
        for (std::uint32_t c = 0; c < planes.count; ++c)
            for (std::uint32_t y = task * step; y < end; ++y) row(c, y);
    };
    parallel.for_each_index(tasks, std::ref(work));
}

/// Texels of the finer level under texel i of the coarser: [first, last], the outer ones in part. In units of
/// 1 / coarse of a fine texel, so that every weight is an integer.
struct Span {
    Span(std::uint32_t i, std::uint32_t fine, std::uint32_t coarse) noexcept
        : begin(std::uint64_t{i} * fine), end(begin + fine), unit(coarse),
          first(static_cast<std::uint32_t>(begin / coarse)), last(static_cast<std::uint32_t>((end - 1) / coarse))
    {
    }
    double weight(std::uint32_t texel) const noexcept
    {
        const std::uint64_t from = std::max(begin, std::uint64_t{texel} * unit),
                            to = std::min(end, std::uint64_t{texel + 1} * unit);
        return static_cast<double>(to - from);
    }
    std::uint64_t begin, end;
    std::uint32_t unit, first, last;
};

void average(const Planes& fine, Planes& coarse, std::uint32_t c, std::uint32_t y) noexcept
{
    const Span rows(y, fine.height, coarse.height);
    const double whole = static_cast<double>(fine.width) * fine.height;
    for (std::uint32_t x = 0; x < coarse.width; ++x) {
        const Span columns(x, fine.width, coarse.width);
        double sum = 0;
        for (std::uint32_t j = rows.first; j <= rows.last; ++j) {
            double inner = 0;
            for (std::uint32_t i = columns.first; i <= columns.last; ++i)
                inner += columns.weight(i) * static_cast<double>(fine.row(c, j)[i]);
            sum += rows.weight(j) * inner;
        }
        coarse.row(c, y)[x] = static_cast<float>(sum / whole);
    }
}

std::uint32_t side_at(std::uint32_t side, std::uint32_t level) noexcept
{
    return std::max(1U, (side + (1U << level) / 2) >> level);
}

/// The largest standard deviation that a level of one texel gives, and how many impacts a sample of it meets.
struct Reach {
    double deviation, impacts;
};

Reach reach_of(const Planes& planes, double rate, std::uint32_t level, std::uint32_t taps) noexcept
{
    const double pixel = static_cast<double>(1U << level);
    Reach reach{0, rate * pixel * pixel * taps * taps};
    for (std::uint32_t c = 0; c < planes.count; ++c)
        reach.deviation =
            std::max(reach.deviation, std::abs(static_cast<double>(planes.row(c, 0)[0])) * std::sqrt(rate) * pixel);
    return reach;
}

} // namespace

void make_picture_mips(Mip_chain& chain, const Planes& picture, std::pmr::memory_resource* memory, Parallel& parallel)
{
    std::uint32_t levels = 1;
    const Planes* fine = &picture;
    while ((fine->width > 1 || fine->height > 1) && levels < most_levels) {
        Planes& coarse = chain.own[levels];
        coarse = Planes(memory, side_at(picture.width, levels), side_at(picture.height, levels), picture.count,
                        Array<float>::unset);
        const auto row = [&](std::uint32_t c, std::uint32_t y) { average(*fine, coarse, c, y); };
        for_each_row(coarse, parallel, std::ref(row));
        fine = &coarse;
        ++levels;
    }
    publish(chain, picture, 1, levels);
}

void make_texton_mips(Mip_chain& chain, const Splat_source& source, double scale, double rate, std::uint32_t most,
                      std::pmr::memory_resource* memory, Parallel& parallel)
{
    constexpr double unseen = 1.0 / 2048; // of the range of colours
    constexpr double most_impacts = 8192; // a sample: beyond, a window takes minutes
    const Planes& alpha = source.coefficients;
    chain.own[0] =
        Planes(memory, alpha.width, alpha.height, alpha.count / source.stored * source.images, Array<float>::unset);
    for (std::size_t i = 0; i < chain.own[0].values.size(); ++i)
        chain.own[0].values[i] = static_cast<float>(static_cast<double>(alpha.values[i]) * scale);
    std::uint32_t levels = 1;
    for (; levels < most; ++levels) {
        const Planes& fine = chain.own[levels - 1];
        if (fine.width == 1 && fine.height == 1) {
            const Reach next = reach_of(fine, rate, levels - 1, source.taps);
            if (next.deviation / 2 < unseen || next.impacts * 4 > most_impacts) break;
        }
        chain.own[levels] = coarser(fine, source.taps, levels == 1, memory, parallel);
    }
    publish(chain, chain.own[0], source.images, levels);
}

} // namespace weft
