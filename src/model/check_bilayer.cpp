/// The invariants of a bi-layer model: whatever a backend will read is checked here.
#include "model/rules.h"
#include <algorithm>
#include <cstdlib>

namespace weft {

namespace {

void check_noise(const Noise& noise, std::uint32_t channels, const Rules& rules)
{
    rules.planes(noise.coefficients, channels, "noise's texton");
    rules.demand(Rules::all_finite(noise.mean, channels), "a noise's mean is not finite, or beyond 2^64");
    rules.colours(noise, channels);
}

void check_masks(const Bilayer& bilayer, std::uint32_t first, const Rules& rules)
{
    const Planes& planes = bilayer.structure;
    for (std::size_t i = 0; i < planes.area(); ++i) {
        double sum = 0;
        for (std::uint32_t k = first; k < planes.count; ++k) {
            const float mask = planes.plane(k)[i];
            rules.demand(mask >= 0 && mask <= 1, "a mask has the value ", mask, ", not 0..1");
            sum += static_cast<double>(mask);
        }
        rules.demand(sum < 1.001, "the masks' sum is ", sum, ", above 1");
    }
}

bool lies_in(std::int32_t x, std::int32_t y, const Planes& planes) noexcept
{
    return x >= 0 && y >= 0 && static_cast<std::uint32_t>(x) < planes.width &&
           static_cast<std::uint32_t>(y) < planes.height;
}

void check_wang(const Bilayer& bilayer, const Rules& rules)
{
    const Wang& wang = bilayer.wang;
    if (wang.colours == 0) {
        rules.demand(wang.diamonds.empty() && wang.contours.empty(), "there are diamonds, but no colours");
        return;
    }
    rules.demand(wang.colours >= 2 && wang.colours <= most_wang_colours, "Wang tiles have ", wang.colours,
                 " colours, not 2..", most_wang_colours);
    for (const auto& [side, most] :
         {std::pair{wang.width, bilayer.structure.width}, std::pair{wang.height, bilayer.structure.height}})
        rules.demand(side >= 4 && side <= most && side % 2 == 0, "Wang tiles have a side of ", side,
                     ", not an even one of 4..", most);
    rules.demand(wang.knots >= 2 && wang.knots <= 254, "Wang contours have ", wang.knots, " intervals, not 2..254");
    rules.demand(wang.diamonds.size() == 2 * wang.colours, "there are ", wang.diamonds.size(), " diamonds");
    for (const Wang::Diamond& at : wang.diamonds)
        rules.demand(lies_in(at.x, at.y, bilayer.structure), "a diamond lies at ", at.x, ", ", at.y);
    const std::size_t length = wang.knots + 1, rows = std::size_t{4} * wang.colours * wang.colours;
    rules.demand(wang.contours.size() == rows * length, "Wang contours have ", wang.contours.size(), " depths");
    for (std::size_t i = 0; i < wang.contours.size(); ++i) {
        const auto k = static_cast<std::uint32_t>(i % length);
        const int end = static_cast<int>(std::min(k, wang.knots - k));
        rules.demand(10 * std::abs(wang.contours[i]) <= 8 * end, "a Wang contour is ", int{wang.contours[i]},
                     " deep at knot ", k);
    }
}

void check_map(const Bilayer& bilayer, const Rules& rules)
{
    const Exchange& exchange = bilayer.exchange;
    const bool wang = bilayer.wang.colours > 0;
    const std::size_t views = wang ? 2 * std::size_t{bilayer.wang.colours} : 1;
    const std::size_t area = wang ? std::size_t{bilayer.wang.width} * bilayer.wang.height : bilayer.structure.area();
    rules.demand(exchange.map.size() == views * area, "the map of patches has ", exchange.map.size(), " entries, not ",
                 views * area);
    for (const std::uint32_t entry : exchange.map) {
        rules.demand((entry & map_patch) < exchange.patches.size(), "the map names patch ", entry & map_patch, " of ",
                     exchange.patches.size());
        rules.demand((entry >> map_depth_shift & 255) <= most_map_depth, "the map has the depth ",
                     entry >> map_depth_shift & 255);
        rules.demand(!wang || entry >> 30 == 0, "a diamond's patch begins in another cell");
    }
}

void check_exchange(const Bilayer& bilayer, const Rules& rules)
{
    const Exchange& exchange = bilayer.exchange;
    if (exchange.patches.empty()) {
        rules.demand(exchange.map.empty() && exchange.contents.empty() && exchange.contours.empty(),
                     "there are contents, but no patches");
        return;
    }
    rules.demand(exchange.patches.size() <= map_patch, "there are ", exchange.patches.size(), " patches");
    rules.demand(exchange.contours.size() == exchange.contents.size() * contour_knots, "there are ",
                 exchange.contours.size(), " depths of contours for ", exchange.contents.size(), " contents");
    check_map(bilayer, rules);
    std::uint64_t next = 0;
    constexpr std::int32_t far = 1 << 15;
    for (const Exchange::Patch& patch : exchange.patches) {
        rules.demand(patch.x > -far && patch.x < far && patch.y > -far && patch.y < far, "a patch's anchor is at ",
                     patch.x, ", ", patch.y);
        rules.demand(patch.count >= 1 && patch.count <= 64 && patch.first == next, "a patch has ", patch.count,
                     " contents from ", patch.first, " on");
        next += patch.count;
    }
    rules.demand(next == exchange.contents.size(), "there are ", exchange.contents.size(),
                 " contents, the patches name ", next);
    for (const Exchange::Content& content : exchange.contents) {
        rules.demand(lies_in(content.x, content.y, bilayer.structure), "a content lies at ", content.x, ", ",
                     content.y);
        rules.demand(content.turn <= 4, "a content is turned by ", content.turn, " eighths");
        rules.demand(content.scale >= 0.5F && content.scale <= 1, "a content has the scale ", content.scale);
    }
}

} // namespace

void check_bilayer(const Model& model, const Rules& rules)
{
    const Bilayer& bilayer = model.bilayer;
    const auto noises = static_cast<std::uint32_t>(std::min<std::size_t>(bilayer.noises.size(), UINT32_MAX));
    rules.demand(noises >= 1 && noises <= most_noises, "the model has ", noises, " noises, not 1..", most_noises);
    rules.demand(bilayer.plain <= 1, "the model's structure is of kind ", bilayer.plain);
    const std::uint32_t first = bilayer.plain != 0 ? 0 : model.channels;
    rules.planes(bilayer.structure, first + noises, "structure with its masks");
    for (const float mean : model.mean)
        rules.demand(bilayer.plain != 0 || mean == 0, "a model with structure has a mean");
    check_masks(bilayer, first, rules);
    if (!bilayer.residual.values.empty()) rules.planes(bilayer.residual, model.channels, "noise layer");
    for (const Noise& noise : bilayer.noises) check_noise(noise, model.channels, rules);
    rules.demand((bilayer.turns & ~31U) == 0, "the model's turns are ", bilayer.turns);
    rules.demand(bilayer.least_scale >= 0.5F && bilayer.least_scale <= 1, "the model's least scale is ",
                 bilayer.least_scale);
    rules.demand(bilayer.turbulence >= 0 && bilayer.turbulence <= 64, "the model's turbulence is ", bilayer.turbulence);
    rules.demand(bilayer.wavelength >= 4 && bilayer.wavelength <= 4096, "the model's wavelength is ",
                 bilayer.wavelength);
    check_wang(bilayer, rules);
    check_exchange(bilayer, rules);
}

} // namespace weft
