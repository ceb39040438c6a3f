/// The Poisson process of a SPLAT layer: which cells can hold an impact that reaches, and the impacts of a cell.
/// Included by rows.inl, inside its unnamed namespace.

/// Cell `index` of the period that begins at `base`; without a period base is 0.
struct Walk {
    int64_t base, index;
};

/// One axis of a cell: its first pixel, the number that is hashed, and how many of its pixels lie within the period.
struct Cell {
    int64_t begin;
    uint64_t number;
    int32_t pixels;
};

Walk walk_from(const Splat& splat, uint32_t period, int64_t pixel)
{
    if (period == 0) return {0, pixel >> splat.cell_log2};
    const int64_t base = weft_divide_down(pixel, period) * int64_t(period);
    return {base, (pixel - base) >> splat.cell_log2};
}

Cell cell_at(const Splat& splat, uint32_t period, const Walk& walk)
{
    const int64_t size = int64_t(1) << splat.cell_log2;
    const int64_t rest = int64_t(period) - walk.index * size;
    return {walk.base + walk.index * size, uint64_t(walk.index), int32_t(period != 0 && rest < size ? rest : size)};
}

void advance(const Splat& splat, uint32_t period, Walk& walk)
{
    ++walk.index;
    if (period == 0 || (walk.index << splat.cell_log2) < int64_t(period)) return;
    walk.base += period;
    walk.index = 0;
}

/// The pixels that an impact can lie in to reach a sample.
struct Range {
    int64_t first, last;
};

/// Texel first..first + taps - 1 are read; one of them is in the level if first is in lowest..highest. By the
/// definition of first, the impact is then between (highest + shift + 3/2) and (lowest + shift + 1/2) texels before the
/// sample.
Range range_of(uint32_t taps, uint32_t level, int32_t origin, int32_t size, int64_t pixel, int32_t fraction)
{
    const int64_t lowest = origin - (int64_t(taps) - 1), highest = int64_t(origin) + size - 1;
    const int64_t twice_shift = taps > 2 ? int64_t(taps) - 2 : taps == 1 ? -1 : 0;
    const int64_t half = int64_t(1) << (level + 23);
    return {pixel + ((fraction - (2 * highest + twice_shift + 3) * half) >> 24),
            pixel + ((fraction - (2 * lowest + twice_shift + 1) * half) >> 24)};
}

uint32_t impact_count(const Splat& splat, uint64_t key)
{
    const uint32_t high = weft_high(weft_draw(key, 0));
    uint32_t count = 0;
    while (count < splat.count_limit && splat.counts[count] <= high) ++count;
    return count;
}

/// Where pixel 0 of a window's level lies: at a pixel's centre on level 0, at its corner above.
int64_t sample_pixel(int64_t index, uint32_t level)
{
    return index * (int64_t(1) << level) + (level != 0 ? int64_t(1) << (level - 1) : 0);
}

int32_t sample_fraction(uint32_t level) { return level != 0 ? 0 : WEFT_FRACTION_HALF; }

Spline spline_of(float tx, float ty, float sign, uint32_t taps)
{
    const weft_weights x = weft_spline(tx, taps), y = weft_spline(ty, taps);
    Spline spline;
    for (uint32_t i = 0; i < 6; ++i) {
        spline.x[i] = x.w[i] * sign;
        spline.y[i] = y.w[i];
    }
    return spline;
}

/// One block being searched.
struct Search {
    const Splat& splat;
    const Block& block;
    const Texels& texels;
    int64_t x, y; ///< pixel of the block's first sample
    int32_t fraction;
};

/// Appends the impact z of a cell unless it does not reach.
void append_impact(const Search& s, const Cell& cx, const Cell& cy, uint64_t z, Impacts& found)
{
    const weft_impact_axis ax = weft_impact_at(weft_low(z), s.splat.cell_log2);
    const weft_impact_axis ay = weft_impact_at(weft_high(z), s.splat.cell_log2);
    if (ax.pixel >= cx.pixels || ay.pixel >= cy.pixels) return;
    const int64_t x = cx.begin + ax.pixel, y = cy.begin + ay.pixel;
    const uint32_t taps = s.splat.taps;
    const weft_taps tx = weft_taps_at(weft_distance(s.x - x, s.fraction, ax.fraction, s.block.level), taps);
    const weft_taps ty = weft_taps_at(weft_distance(s.y - y, s.fraction, ay.fraction, s.block.level), taps);
    const int64_t column = tx.first - s.texels.x, row = ty.first - s.texels.y, reach = int64_t(taps) - 2;
    if (column >= s.texels.width || column + s.block.width + reach < 0) return;
    if (row >= s.texels.height || row + s.block.height + reach < 0) return;

    const float sign = weft_impact_sign(z, s.splat.signs);
    const int64_t image = s.splat.choose ? s.splat.choose(s.splat.choice, x, y) : 0;
    Impact& impact = found.impacts[found.count];
    impact.origin = image * s.texels.image + row * s.texels.row + column;
    impact.column = int32_t(column);
    impact.row = int32_t(row);
    if (taps == 2) {
        const weft_weights2 w = weft_linear(tx.t, ty.t, sign);
        impact.w0 = w.w0;
        impact.w1 = w.w1;
        impact.rho = w.rho;
    } else {
        found.splines[found.count] = spline_of(tx.t, ty.t, sign, taps);
    }
    ++found.count;
}

bool find_impacts(const Splat& splat, const Block& block, Impacts& found)
{
    const uint32_t level = block.level;
    const Texels& texels = splat.texels[level];
    const Search search = {
        splat, block, texels, sample_pixel(block.x, level), sample_pixel(block.y, level), sample_fraction(level)};
    const int64_t right = sample_pixel(block.x + block.width - 1, level);
    const int64_t below = sample_pixel(block.y + block.height - 1, level);
    const int32_t fraction = search.fraction;
    const int64_t x0 = range_of(splat.taps, level, texels.x, texels.width, search.x, fraction).first;
    const int64_t x1 = range_of(splat.taps, level, texels.x, texels.width, right, fraction).last;
    const int64_t y0 = range_of(splat.taps, level, texels.y, texels.height, search.y, fraction).first;
    const int64_t y1 = range_of(splat.taps, level, texels.y, texels.height, below, fraction).last;

    const Walk top = walk_from(splat, splat.period[1], y0);
    for (Walk wx = walk_from(splat, splat.period[0], x0);; advance(splat, splat.period[0], wx)) {
        const Cell cx = cell_at(splat, splat.period[0], wx);
        if (cx.begin > x1) return true;
        const uint64_t column = weft_absorb(splat.key, cx.number);
        for (Walk wy = top;; advance(splat, splat.period[1], wy)) {
            const Cell cy = cell_at(splat, splat.period[1], wy);
            if (cy.begin > y1) break;
            const uint64_t key = weft_absorb(column, cy.number);
            const uint32_t count = impact_count(splat, key);
            while (found.capacity - found.count < count)
                if (!found.grow(found)) return false;
            for (uint32_t i = 0; i < count; ++i) append_impact(search, cx, cy, weft_draw(key, i + 1), found);
        }
    }
}
