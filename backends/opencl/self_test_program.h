/// The small fixed programs of the self-test, one for each use, and where they are looked at. Every kernel has a part
/// in them.
#pragma once
#include "common/field.h"
#include <cstddef>
#include <cstdint>
#include <weft/backend.h>

namespace weft::opencl {

/// Programs point into themselves: built in place, never copied.
class SelfTestProgram {
public:
    static constexpr std::uint32_t channels = 2, width = 20, height = 7, stride = 32, windows = 3, spot_count = 24;
    static constexpr std::size_t value_count = std::size_t{channels} * (windows * width * height + 3 * spot_count);

    static constexpr weft_use uses[] = {WEFT_USE_WINDOW, WEFT_USE_POINTS, WEFT_USE_SURFACE, WEFT_USE_SOLID};

    explicit SelfTestProgram(weft_use use);
    SelfTestProgram(const SelfTestProgram&) = delete;

    weft_program program = {};

    /// Calls render(window) and copies the pixels, then the same for the other windows; `values` moves on.
    template <class Render> static void look(Render render, float*& values)
    {
        static constexpr std::int64_t corners[windows][3] = {
            {-5, -3, 0}, {(std::int64_t{1} << 40) - 7, -(std::int64_t{1} << 40) + 29, 0}, {-11, 8, 1}};
        for (const auto& corner : corners) {
            alignas(64) float pixels[channels * height * stride];
            weft_window window = {};
            window.size = sizeof window;
            window.width = width;
            window.height = height;
            window.stride = stride;
            window.x = corner[0];
            window.y = corner[1];
            window.level = static_cast<std::uint32_t>(corner[2]);
            window.data = pixels;
            render(window);
            for (std::uint32_t row = 0; row < channels * height; ++row)
                for (std::uint32_t x = 0; x < width; ++x) *values++ = pixels[row * stride + x];
        }
    }

    /// Calls sample(batch), whose results are written where `values` points.
    template <class Sample> static void look_at_spots(weft_use use, Sample sample, float*& values)
    {
        static constexpr float frame[9] = {0.8f, 0.0f, 0.6f, 0.36f, 0.8f, -0.48f, -0.48f, 0.6f, 0.64f};
        float frames[spot_count * 9];
        weft_spot spots[spot_count] = {};
        for (std::uint32_t i = 0; i < spot_count; ++i) {
            const weft_u64 z = weft_mix(i + 1);
            spots[i].cell[0] = static_cast<std::int64_t>(z & 0xff) - 128;
            spots[i].cell[1] = (i & 1 ? 1 : -1) * (static_cast<std::int64_t>(z >> 8 & 0xff) + (std::int64_t{1} << 40));
            spots[i].fraction[0] = static_cast<std::uint32_t>(z >> 40);
            spots[i].fraction[1] = static_cast<std::uint32_t>(z >> 16 & WEFT_FRACTION_MASK);
            spots[i].level = static_cast<float>(i % 5) * 0.375f;
            for (std::uint32_t k = 0; k < 9; ++k) frames[i * 9 + k] = frame[k];
            if (use == WEFT_USE_POINTS) continue;
            spots[i].cell[2] = static_cast<std::int64_t>(z >> 32 & 0xff) - 128;
            spots[i].fraction[2] = static_cast<std::uint32_t>(z >> 8 & WEFT_FRACTION_MASK);
        }
        weft_batch batch = {};
        batch.size = sizeof batch;
        batch.count = spot_count;
        batch.spots = spots;
        batch.frames = use == WEFT_USE_SURFACE ? frames : nullptr;
        batch.out = values;
        sample(batch);
        values += spot_count * channels;
    }

private:
    struct Pictures {
        weft_mip levels[2];
        weft_mips mips;
    };
    static constexpr std::uint32_t band_count = 3;

    static constexpr std::uint32_t cell_x = 8, cell_y = 6, colours_of_edges = 2, knots = 4, views = 4;

    void fill_bands(weft_use use);
    void compose();
    void add(const weft_layer& layer);
    void fill(Pictures& pictures, std::uint32_t planes, std::uint32_t images, std::uint32_t size_x,
              std::uint32_t size_y);
    weft_splat splat(const Pictures& textons, std::uint32_t taps) const;
    weft_layer layer(weft_layer_kind kind, std::uint32_t planes, std::int32_t mask_layer) const;

    static constexpr std::uint32_t thresholds[4] = {0x20000000, 0x60000000, 0xa0000000, 0xe8000000};
    static constexpr float zeros[2] = {0.0f, 0.0f}, means[2] = {0.4375f, -0.3f},
                           colours[4] = {0.9f, -0.2f, 0.35f, 1.1f}, feathers[2] = {0.125f, 0.0625f};
    static constexpr weft_piece pieces[2] = {{-1.0f, -0.8f, 0.7f, 0.1f, -0.2f}, {0.1f, 0.05f, 1.1f, -0.3f, 0.05f}};
    static constexpr weft_tone tones[2] = {{-1.0f, 1.5f, 2, 0, pieces}, {-0.5f, 0.7f, 1, 0, pieces}};

    float data_[2048];
    std::size_t used_ = 0;
    Pictures source_, two_, four_;
    weft_tile tile_ = {}, composed_ = {};
    weft_wang wang_ = {};
    weft_exchange exchange_ = {};
    weft_diamond diamonds_[views];
    std::int8_t edges_[4 * colours_of_edges * colours_of_edges * (knots + 1)];
    float sharp_[2 * (knots + 1)];
    weft_u32 map_[views * cell_y * cell_x];
    weft_patch patches_[views];
    weft_content contents_[2 * views];
    std::uint8_t contours_[2 * views * WEFT_CONTOUR];
    weft_splat splats_[2];
    weft_band table_[2 * band_count];
    weft_bands bands_ = {sizeof(weft_bands), band_count, table_};
    weft_layer layers_[5];
    const weft_layer* order_[5];
};

} // namespace weft::opencl
