/// Drawing a window's impacts once, in canonical order, and dealing them to the bands that they reach.
#include "opencl/impacts.h"
#include "opencl/walk.h"
#include <algorithm>
#include <cstring>

namespace weft::opencl {

namespace {

/// The bands, first to last, that see a texton of `height` rows of which row `row` is under the window's first row.
struct Reached {
    Reached(weft_i32 row, weft_i32 height, weft_i32 band_count, weft_i32 rows, weft_i32 taps)
        : first(std::max(0, 1 - taps - row) / rows), last(std::min(band_count - 1, (height - 1 - row) / rows))
    {
    }
    weft_i32 first, last;
};

void set_weights(float* weights, weft_taps x, weft_taps y, float sign, weft_u32 taps)
{
    if (taps == 2) {
        const weft_weights2 w = weft_linear(x.t, y.t, sign);
        weights[0] = w.w0;
        weights[1] = w.w1;
        weights[2] = w.rho;
    } else {
        const weft_weights wx = weft_spline(x.t, taps), wy = weft_spline(y.t, taps);
        for (weft_u32 i = 0; i < taps; ++i) weights[i] = wx.w[i] * sign;
        std::copy(wy.w, wy.w + taps, weights + taps);
    }
}

} // namespace

/// One cell of the walk, and what its impacts are measured against.
struct Impacts::Cells {
    const LayerLayout& layer;
    const LevelLayout& level;
    const weft_u32* counts;
    const Choice& choice;
    const weft_window& window;
    weft_i64 centre_x, centre_y; ///< of the window's first pixel
    Walk x, y;
    weft_u64 key;
};

void Impacts::collect(const LayerLayout& layer, const LevelLayout& level, const weft_u32* counts, const Choice& choice,
                      const weft_window& window)
{
    const weft_i64 unit = weft_i64{1} << window.level;
    const weft_i64 x = window.x * unit + unit / 2, y = window.y * unit + unit / 2;
    // More columns: the accumulator of tap i of a pixel is that of its i-th neighbour.
    const weft_i64 end_x = level.after_x + (window.width + layer.taps - 2) * unit;
    const weft_i64 end_y = level.after_y + (window.height - 1) * unit;
    Cells cells{layer, level, counts, choice, window, x, y, {}, {}, 0};
    reaching_.clear();
    for (cells.x = walk_from(x, level.before_x, layer.period_x, layer.cell_log2); cells.x.start <= end_x;
         cells.x = walk_on(cells.x, layer.period_x, layer.cell_log2)) {
        const weft_u64 column_key = weft_absorb(layer.key, static_cast<weft_u64>(cells.x.cell));
        for (cells.y = walk_from(y, level.before_y, layer.period_y, layer.cell_log2); cells.y.start <= end_y;
             cells.y = walk_on(cells.y, layer.period_y, layer.cell_log2)) {
            cells.key = weft_absorb(column_key, static_cast<weft_u64>(cells.y.cell));
            draw(cells);
        }
    }
    deal(layer, level, window.height);
}

void Impacts::draw(const Cells& cells)
{
    const weft_window& window = cells.window;
    const weft_u32 taps = cells.layer.taps;
    const auto reach = static_cast<weft_i32>(taps) - 1;
    const weft_i32 centre = window.level == 0 ? WEFT_FRACTION_HALF : 0;
    const weft_u32 probability = weft_high(weft_draw(cells.key, 0));
    for (weft_u32 i = 0; i < cells.layer.count_limit && cells.counts[i] <= probability; ++i) {
        const weft_u64 z = weft_draw(cells.key, i + 1);
        const weft_impact_axis x = weft_impact_at(weft_low(z), cells.layer.cell_log2);
        const weft_impact_axis y = weft_impact_at(weft_high(z), cells.layer.cell_log2);
        if (x.pixel >= cells.x.size || y.pixel >= cells.y.size) continue;
        const weft_taps tx =
            weft_taps_at(weft_distance(-weft_i64{cells.x.start + x.pixel}, centre, x.fraction, window.level), taps);
        const weft_taps ty =
            weft_taps_at(weft_distance(-weft_i64{cells.y.start + y.pixel}, centre, y.fraction, window.level), taps);
        const auto column = static_cast<weft_i32>(tx.first - cells.level.x),
                   row = static_cast<weft_i32>(ty.first - cells.level.y);
        const auto width = static_cast<weft_i32>(window.width), height = static_cast<weft_i32>(window.height);
        if (column >= static_cast<weft_i32>(cells.level.width) || column + width - 1 + reach < 0) continue;
        if (row >= static_cast<weft_i32>(cells.level.height) || row + height - 1 + reach < 0) continue;
        Reaching& impact = reaching_.emplace_back();
        impact.column = column;
        impact.row = row;
        impact.image =
            cells.choice.image(cells.centre_x + cells.x.start + x.pixel, cells.centre_y + cells.y.start + y.pixel);
        set_weights(impact.weights, tx, ty, weft_impact_sign(z, cells.layer.signs), taps);
    }
}

void Impacts::deal(const LayerLayout& layer, const LevelLayout& level, std::uint32_t height)
{
    const auto rows = static_cast<weft_i32>(WEFT_BLOCK_ROWS(layer.taps)), taps = static_cast<weft_i32>(layer.taps);
    const auto band_count = (static_cast<weft_i32>(height) + rows - 1) / rows;
    const auto texton_height = static_cast<weft_i32>(level.height), stride = static_cast<weft_i32>(level.stride);
    bands_.assign(static_cast<std::size_t>(band_count) + 2, 0);
    for (const Reaching& impact : reaching_) {
        const Reached to(impact.row, texton_height, band_count, rows, taps);
        for (weft_i32 band = to.first; band <= to.last; ++band) ++bands_[static_cast<std::size_t>(band) + 2];
    }
    for (std::size_t i = 2; i < bands_.size(); ++i) bands_[i] += bands_[i - 1];
    const std::size_t words = WEFT_IMPACT_WORDS(layer.taps);
    list_.resize(bands_.back() * words);
    // bands_[b + 1] walks from the beginning of band b to its end, which is the beginning of the next.
    for (const Reaching& impact : reaching_) {
        const Reached to(impact.row, texton_height, band_count, rows, taps);
        for (weft_i32 band = to.first; band <= to.last; ++band) {
            weft_u32* entry = list_.data() + bands_[static_cast<std::size_t>(band) + 1]++ * words;
            const auto row = impact.row + band * rows + static_cast<weft_i32>(level.frame_y);
            entry[0] = static_cast<weft_u32>(impact.column);
            entry[1] = static_cast<weft_u32>(row * stride + static_cast<weft_i32>(level.frame_x)) +
                       impact.image * level.image_step;
            std::memcpy(entry + 2, impact.weights, (words - 2) * sizeof(float));
        }
    }
}

} // namespace weft::opencl
