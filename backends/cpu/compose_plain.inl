/// TILE with WANG or exchange in plain loops: the reference. Included by rows.inl, inside its unnamed namespace.

float source_texel(const weft_mip& mip, uint32_t plane, int32_t x, int32_t y)
{
    return mip.data[(size_t(plane) * mip.height + size_t(y)) * mip.width + size_t(x)];
}

float source_level(const weft_mips& source, const Spot_place& at, int32_t level, uint32_t plane)
{
    const weft_mip& mip = source.level[level];
    const weft_pair x = weft_pair_at(at.x, level, mip.scale_x, mip.width);
    const weft_pair y = weft_pair_at(at.y, level, mip.scale_y, mip.height);
    const float upper =
        weft_lerp(source_texel(mip, plane, x.first, y.first), source_texel(mip, plane, x.second, y.first), x.t);
    const float lower =
        weft_lerp(source_texel(mip, plane, x.first, y.second), source_texel(mip, plane, x.second, y.second), x.t);
    return weft_lerp(upper, lower, y.t);
}

float source_value(const weft_mips& source, const Spot_place& at, const weft_between& level, uint32_t plane)
{
    const float f = source_level(source, at, level.whole, plane);
    return level.t > 0 ? weft_lerp(f, source_level(source, at, level.whole + 1, plane), level.t) : f;
}

/// Some planes of a view, after exchange.
void view_values(const Composed& c, Looker& looker, const View& view, uint32_t slot, uint32_t first, uint32_t planes,
                 float* f)
{
    const weft_mips& source = *c.tile->source;
    const Content content = c.tile->exchange ? looker.content(view, slot) : Content{};
    for (uint32_t p = 0; p < planes; ++p) {
        if (!(content.share >= 1)) f[p] = source_value(source, view.base(), looker.level(), first + p);
        if (!(content.share > 0)) continue;
        const float g = source_value(source, content.source, content.level, first + p);
        f[p] = content.share >= 1 ? g : weft_lerp(f[p], g, content.share);
    }
}

void compose(const Composed& c, const Axis_places* places, uint32_t count, float level, uint32_t first, uint32_t planes,
             float* f, size_t pitch)
{
    Looker looker(c, level);
    for (uint32_t i = 0; i < count; ++i) {
        float values[2][most_planes];
        View views[2];
        const float share = looker.views(looker.place(places, i), views[0], views[1]);
        if (share > 0) view_values(c, looker, views[0], 0, first, planes, values[0]);
        if (!(share >= 1)) view_values(c, looker, views[1], 1, first, planes, values[1]);
        for (uint32_t p = 0; p < planes; ++p)
            f[p * pitch + i] = share >= 1  ? values[0][p]
                               : share > 0 ? weft_lerp(values[1][p], values[0][p], share)
                                           : values[1][p];
    }
}
