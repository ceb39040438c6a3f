/// Patches are unwrapped so that the first of their texels, in x and in y, lie in the cell.
#include "analysis/exchange_shape.h"
#include <algorithm>

namespace weft {

Turning::Turning(std::uint32_t eighths, float scale) noexcept
{
    constexpr float half = 0.70710678f;
    static constexpr float cosines[] = {1, half, 0, -half, -1}, sines[] = {0, half, 1, half, 0};
    const float c = cosines[eighths] / scale, s = sines[eighths] / scale;
    m[0] = c;
    m[1] = 0 - s;
    m[2] = s;
    m[3] = c;
}

Array<Patch_frame> frames_of(std::pmr::memory_resource* memory, const View& view, const Patches_of_view& patches)
{
    struct Sum {
        std::int32_t first_x, first_y;
        std::int64_t x, y, count;
    };
    Array<Sum> sums(memory, patches.count);
    Array<Patch_frame> frames(memory, patches.count);
    const auto w = static_cast<std::int32_t>(view.width), h = static_cast<std::int32_t>(view.height);
    const auto near = [](std::int32_t at, std::int32_t first, std::int32_t size) {
        return at - first > size / 2 ? at - size : first - at > size / 2 ? at + size : at;
    };
    for (std::int32_t y = 0; y < h; ++y)
        for (std::int32_t x = 0; x < w; ++x) {
            const std::uint32_t k =
                patches.patch[static_cast<std::size_t>(y) * view.width + static_cast<std::size_t>(x)];
            if (k == no_patch) continue;
            Sum& sum = sums[k];
            Patch_frame& frame = frames[k];
            if (sum.count == 0) {
                sum.first_x = x;
                sum.first_y = y;
                frame = {x, y, x + 1, y + 1, 0, 0};
            }
            const std::int32_t at_x = view.torus ? near(x, sum.first_x, w) : x,
                               at_y = view.torus ? near(y, sum.first_y, h) : y;
            frame.left = std::min(frame.left, at_x);
            frame.right = std::max(frame.right, at_x + 1);
            frame.top = std::min(frame.top, at_y);
            frame.bottom = std::max(frame.bottom, at_y + 1);
            sum.x += 2 * at_x + 1;
            sum.y += 2 * at_y + 1;
            ++sum.count;
        }
    for (std::uint32_t k = 0; k < patches.count; ++k) {
        Patch_frame& frame = frames[k];
        const std::int32_t right = frame.left < 0 ? w : 0, down = frame.top < 0 ? h : 0;
        frame.left += right;
        frame.right += right;
        frame.top += down;
        frame.bottom += down;
        frame.x = static_cast<std::int32_t>(sums[k].x / (2 * sums[k].count)) + right;
        frame.y = static_cast<std::int32_t>(sums[k].y / (2 * sums[k].count)) + down;
    }
    return frames;
}

Patch_shape shape_of(std::pmr::memory_resource* memory, const Features& features, const View& view,
                     const Patches_of_view& patches, const Patch_frame& frame, std::uint32_t patch)
{
    Patch_shape shape{view.x + frame.x, view.y + frame.y, 0, {}};
    const auto each = [&](auto&& body) {
        for (std::int32_t y = frame.top; y < frame.bottom; ++y)
            for (std::int32_t x = frame.left; x < frame.right; ++x) {
                const std::size_t i =
                    static_cast<std::size_t>(y) % view.height * view.width + static_cast<std::size_t>(x) % view.width;
                if (patches.patch[i] == patch) body(x, y, patches.depth[i]);
            }
    };
    std::size_t count = 0;
    each([&](std::int32_t, std::int32_t, std::uint8_t depth) {
        shape.deepest = std::max(shape.deepest, depth);
        count += depth <= zone_depth;
    });
    shape.texels = Array<Patch_shape::Texel>(memory, count);
    count = 0;
    each([&](std::int32_t x, std::int32_t y, std::uint8_t depth) {
        if (depth > zone_depth) return;
        shape.texels[count++] = {static_cast<float>(x - frame.x) + 0.5f, static_cast<float>(y - frame.y) + 0.5f, depth,
                                 features.at(static_cast<std::size_t>(view.x + x) % features.width,
                                             static_cast<std::size_t>(view.y + y) % features.height)};
    });
    return shape;
}

} // namespace weft
