/// SPLAT in plain loops: the reference. Included by rows.inl, inside its unnamed namespace.

size_t scratch(uint32_t, uint32_t width, uint32_t taps) { return (width + taps) * size_t(taps) * sizeof(float); }

/// Adds rows of an impact to the accumulators of one row of one plane. Accumulator i of pixel x is sums[i * pitch + x +
/// i]: it depends on the texels' column x + i alone.
void scatter(const Splat& splat, const Texels& texels, const float* plane, const Impacts& found, uint32_t n, int32_t y,
             uint32_t width, float* sums)
{
    const Impact& impact = found.impacts[n];
    const int32_t taps = int32_t(splat.taps), row = impact.row + y, pitch = int32_t(width) + taps;
    if (row <= -taps || row >= texels.height) return;
    const int32_t begin = impact.column < 0 ? -impact.column : 0;
    const int32_t columns = int32_t(width) + taps - 1, rest = texels.width - impact.column;
    const int32_t end = rest < columns ? rest : columns;
    const float* data = plane + impact.origin + y * texels.row;
    for (int32_t x = begin; x < end; ++x) {
        const auto texel = [&](int32_t j) {
            return row + j >= 0 && row + j < texels.height ? data[j * texels.row + x] : 0.0f;
        };
        if (taps == 2) {
            const float v = weft_fma(impact.rho, texel(1), texel(0));
            sums[x] = weft_fma(impact.w0, v, sums[x]);
            sums[pitch + x] = weft_fma(impact.w1, v, sums[pitch + x]);
        } else {
            const Spline& spline = found.splines[n];
            float v = spline.y[0] * texel(0);
            for (int32_t j = 1; j < taps; ++j) v = weft_fma(spline.y[j], texel(j), v);
            for (int32_t i = 0; i < taps; ++i) sums[i * pitch + x] = weft_fma(spline.x[i], v, sums[i * pitch + x]);
        }
    }
}

void splat_strip(const Splat& splat, uint32_t level, const Impacts& found, const Strip& strip)
{
    const Texels& texels = splat.texels[level];
    const uint32_t taps = splat.taps, pitch = strip.width + taps;
    float* sums = static_cast<float*>(strip.scratch);
    for (uint32_t p = 0; p < splat.planes; ++p)
        for (uint32_t y = 0; y < strip.count; ++y) {
            for (uint32_t i = 0; i < taps * pitch; ++i) sums[i] = 0.0f;
            for (uint32_t n = 0; n < found.count; ++n)
                scatter(splat, texels, texels.data + p * texels.plane, found, n, int32_t(strip.first + y), strip.width,
                        sums);
            float* out = strip.data + (size_t(p) * strip.count + y) * strip.stride;
            for (uint32_t x = 0; x < strip.width; ++x) {
                float f = sums[x];
                for (uint32_t i = 1; i < taps; ++i) f = f + sums[i * pitch + x + i];
                out[x] = f + splat.offset[p];
            }
        }
}

/// A texel, 0 outside.
float texel_at(const Texels& texels, const float* image, int64_t column, int64_t row)
{
    return column >= 0 && column < texels.width && row >= 0 && row < texels.height ? image[row * texels.row + column]
                                                                                   : 0.0f;
}

/// What one impact adds to the accumulators of a sample: sums[plane * 6 + i].
void gather(const Splat& splat, const Texels& texels, int64_t image, const weft_taps& tx, const weft_taps& ty,
            float sign, float* sums)
{
    const int64_t column = tx.first - texels.x, row = ty.first - texels.y;
    const int32_t taps = int32_t(splat.taps);
    const weft_weights2 w = taps == 2 ? weft_linear(tx.t, ty.t, sign) : weft_weights2{};
    const Spline spline = taps == 2 ? Spline{} : spline_of(tx.t, ty.t, sign, splat.taps);
    for (uint32_t p = 0; p < splat.planes; ++p, sums += 6) {
        const float* data = texels.data + image * texels.image + p * texels.plane;
        for (int32_t i = 0; i < taps; ++i) {
            float v = texel_at(texels, data, column + i, row);
            if (taps == 2) {
                v = weft_fma(w.rho, texel_at(texels, data, column + i, row + 1), v);
                sums[i] = weft_fma(i == 0 ? w.w0 : w.w1, v, sums[i]);
                continue;
            }
            v = spline.y[0] * v;
            for (int32_t j = 1; j < taps; ++j)
                v = weft_fma(spline.y[j], texel_at(texels, data, column + i, row + j), v);
            sums[i] = weft_fma(spline.x[i], v, sums[i]);
        }
    }
}

void splat_point(const Splat& splat, uint32_t level, const weft_spot& spot, float* f)
{
    const Texels& texels = splat.texels[level];
    const int32_t fx = int32_t(spot.fraction[0]), fy = int32_t(spot.fraction[1]);
    const Range rx = range_of(splat.taps, level, texels.x, texels.width, spot.cell[0], fx);
    const Range ry = range_of(splat.taps, level, texels.y, texels.height, spot.cell[1], fy);
    float sums[40 * 6];
    for (uint32_t i = 0; i < splat.planes * 6; ++i) sums[i] = 0.0f;

    for (Walk wx = walk_from(splat, splat.period[0], rx.first);; advance(splat, splat.period[0], wx)) {
        const Cell cx = cell_at(splat, splat.period[0], wx);
        if (cx.begin > rx.last) break;
        const uint64_t column = weft_absorb(splat.key, cx.number);
        for (Walk wy = walk_from(splat, splat.period[1], ry.first);; advance(splat, splat.period[1], wy)) {
            const Cell cy = cell_at(splat, splat.period[1], wy);
            if (cy.begin > ry.last) break;
            const uint64_t key = weft_absorb(column, cy.number);
            const uint32_t count = impact_count(splat, key);
            for (uint32_t i = 0; i < count; ++i) {
                const uint64_t z = weft_draw(key, i + 1);
                const weft_impact_axis ax = weft_impact_at(weft_low(z), splat.cell_log2);
                const weft_impact_axis ay = weft_impact_at(weft_high(z), splat.cell_log2);
                const int64_t x = cx.begin + ax.pixel, y = cy.begin + ay.pixel;
                if (ax.pixel >= cx.pixels || ay.pixel >= cy.pixels) continue;
                if (x < rx.first || x > rx.last || y < ry.first || y > ry.last) continue;
                const weft_taps tx = weft_taps_at(weft_distance(spot.cell[0] - x, fx, ax.fraction, level), splat.taps);
                const weft_taps ty = weft_taps_at(weft_distance(spot.cell[1] - y, fy, ay.fraction, level), splat.taps);
                const int64_t image = splat.choose ? splat.choose(splat.choice, x, y) : 0;
                gather(splat, texels, image, tx, ty, weft_impact_sign(z, splat.signs), sums);
            }
        }
    }
    for (uint32_t p = 0; p < splat.planes; ++p) {
        float sum = sums[p * 6];
        for (uint32_t i = 1; i < splat.taps; ++i) sum = sum + sums[p * 6 + i];
        f[p] = sum + splat.offset[p];
    }
}
