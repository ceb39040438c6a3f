/// Names and planes, method by method.
#include "model/parts.h"
#include <algorithm>
#include <string_view>

namespace weft {

namespace {

Part named(std::string_view name) noexcept
{
    Part part;
    std::copy(name.begin(), name.end(), part.name);
    return part;
}

Part numbered(std::string_view name, std::uint32_t number) noexcept
{
    Part part = named(name);
    char digits[10];
    std::size_t count = 0, end = name.size();
    do digits[count++] = static_cast<char>('0' + number % 10);
    while ((number /= 10) > 0);
    while (count > 0) part.name[end++] = digits[--count];
    return part;
}

void set(Part& part, const Planes& planes, std::size_t first, std::uint32_t channels) noexcept
{
    part.values = planes.plane(first);
    part.width = planes.width;
    part.height = planes.height;
    part.channels = channels;
}

/// `channels` planes from `first` on.
Part with(Part part, const Planes& planes, std::size_t first, std::uint32_t channels) noexcept
{
    set(part, planes, first, channels);
    return part;
}

Part with_made(Part part, Planes planes) noexcept
{
    part.made = std::move(planes);
    set(part, part.made, 0, part.made.count);
    return part;
}

/// x and y as two planes.
Planes places_of(const Model& model, std::pmr::memory_resource* memory)
{
    const Correspondence& from = model.correspondence;
    Planes planes(memory, model.picture.width, model.picture.height, 2, Array<float>::unset);
    std::copy(from.x.begin(), from.x.end(), planes.plane(0));
    std::copy(from.y.begin(), from.y.end(), planes.plane(1));
    return planes;
}

/// The patch's number at each texel of the cell, or of all diamonds, one below the other.
Planes map_of(const Bilayer& bilayer, std::pmr::memory_resource* memory)
{
    const bool wang = bilayer.wang.colours > 0;
    const std::uint32_t width = wang ? bilayer.wang.width : bilayer.structure.width;
    const auto rows = static_cast<std::uint32_t>(bilayer.exchange.map.size() / width);
    Planes planes(memory, width, rows, 1, Array<float>::unset);
    for (std::size_t i = 0; i < planes.values.size(); ++i)
        planes.values[i] = static_cast<float>(bilayer.exchange.map[i] & map_patch);
    return planes;
}

/// A row for each content: its patch, x, y, turn in degrees, scale.
Planes contents_of(const Exchange& exchange, std::pmr::memory_resource* memory)
{
    Planes planes(memory, 5, static_cast<std::uint32_t>(exchange.contents.size()), 1, Array<float>::unset);
    for (std::size_t p = 0; p < exchange.patches.size(); ++p)
        for (std::uint32_t i = 0; i < exchange.patches[p].count; ++i) {
            const std::uint32_t index = exchange.patches[p].first + i;
            const Exchange::Content& content = exchange.contents[index];
            float* row = planes.row(0, index);
            row[0] = static_cast<float>(p);
            row[1] = static_cast<float>(content.x);
            row[2] = static_cast<float>(content.y);
            row[3] = static_cast<float>(content.turn * 45);
            row[4] = content.scale;
        }
    return planes;
}

/// Structure unless there is none, masks, textons, then the noise layer and the exchange if the model has them.
std::uint32_t count_bilayer_parts(const Bilayer& bilayer) noexcept
{
    return (bilayer.plain != 0 ? 0U : 1U) + 2 * static_cast<std::uint32_t>(bilayer.noises.size()) +
           (bilayer.residual.values.empty() ? 0U : 1U) + (bilayer.exchange.patches.empty() ? 0U : 2U);
}

Part bilayer_part(const Model& model, std::uint32_t index, std::pmr::memory_resource* memory)
{
    const Bilayer& bilayer = model.bilayer;
    const auto noises = static_cast<std::uint32_t>(bilayer.noises.size());
    if (bilayer.plain == 0 && index-- == 0) return with(named("structure"), bilayer.structure, 0, model.channels);
    if (index < noises)
        return with(numbered("mask ", index), bilayer.structure, bilayer.structure.count - noises + index, 1);
    index -= noises;
    if (index < noises) return with(numbered("texton ", index), bilayer.noises[index].coefficients, 0, model.channels);
    index -= noises;
    if (!bilayer.residual.values.empty() && index-- == 0)
        return with(named("noise"), bilayer.residual, 0, model.channels);
    return index == 0 ? with_made(named("patches"), map_of(bilayer, memory))
                      : with_made(named("contents"), contents_of(bilayer.exchange, memory));
}

} // namespace

std::uint32_t count_parts(const Model& model) noexcept
{
    switch (model.method) {
    case WEFT_METHOD_TEXTON:
        return model.texton.images;
    case WEFT_METHOD_WAVELET:
        return 0;
    case WEFT_METHOD_BILAYER:
        return count_bilayer_parts(model.bilayer);
    case WEFT_METHOD_STATIONARY:
        return 2;
    default:
        return 1;
    }
}

Part part_of(const Model& model, std::uint32_t index, std::pmr::memory_resource* memory)
{
    switch (model.method) {
    case WEFT_METHOD_TEXTON:
        return with(model.texton.images == 1 ? named("texton") : numbered("texton ", index), model.texton.coefficients,
                    std::size_t{index} * model.channels, model.channels);
    case WEFT_METHOD_BILAYER:
        return bilayer_part(model, index, memory);
    case WEFT_METHOD_STATIONARY:
        if (index == 1) return with_made(named("correspondence"), places_of(model, memory));
        return with(named("tile"), model.picture, 0, model.channels);
    default:
        return with(named("picture"), model.picture, 0, model.channels);
    }
}

} // namespace weft
