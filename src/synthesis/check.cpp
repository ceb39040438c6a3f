/// Programs are checked here once, so that no backend need.
#include "synthesis/check.h"
#include "synthesis/check_parts.h"
#include <cmath>

namespace weft {

namespace {

/// A choice is a plane of a TILE that comes before.
void check_choice(const weft_ref& choice, const weft_program& program, std::uint32_t index)
{
    check_ref(choice, program, index, "a choice");
    if (choice.layer == -1) return;
    const weft_layer& chooser = *program.layers[choice.layer];
    demand(chooser.tile && chooser.tile->displacement.layer == -1, "a choice by no TILE");
    demand(program.use != WEFT_USE_SURFACE, "a choice on a surface");
}

void check_splat(const weft_splat& splat, const weft_layer& layer, const weft_program& program, std::uint32_t index)
{
    demand(splat.taps == 1 || splat.taps == 2 || splat.taps == 4 || splat.taps == 6, splat.taps, " taps");
    demand(splat.cell_log2 <= 15, "cells of 2^", splat.cell_log2);
    demand(within(splat.count_limit, 1, 255) && splat.counts, splat.count_limit, " counts");
    for (std::uint32_t i = 1; i < splat.count_limit; ++i)
        demand(splat.counts[i - 1] <= splat.counts[i], "counts that descend");
    demand(splat.signs <= 1 && splat.textons && splat.offset, "an incomplete SPLAT");
    check_choice(splat.choice, program, index);
    demand(all_finite(splat.offset, layer.planes), "an offset that is not finite");
    for (std::uint32_t p = 0; p < layer.planes; ++p)
        demand(splat.offset[p] != 0 || !std::signbit(splat.offset[p]), "an offset of -0");
    check_mips(*splat.textons, layer.planes, false);
}

void check_bands(const weft_bands& bands, const weft_layer& layer, const weft_program& program)
{
    demand(within(bands.count, 1, 24) && bands.bands, bands.count, " bands");
    for (std::uint32_t i = 0; i < bands.count * layer.planes; ++i) {
        const weft_band& band = bands.bands[i];
        demand(std::isfinite(band.weight) && (band.weight == 0 || band.lattice), "a band without lattice");
        if (!band.lattice) continue;
        demand(band.width >= 1 && band.height >= 1 && band.depth >= 1 &&
                   (band.depth == 1 || program.use == WEFT_USE_SOLID),
               "a lattice of ", band.width, " x ", band.height, " x ", band.depth);
        for (const std::uint32_t shift : {band.x, band.y, band.z}) demand(shift < 1U << 31, "a shift of ", shift);
        for (int axis = 0; axis < 2; ++axis) {
            const std::uint32_t b = i / layer.planes, period = program.period[axis],
                                side = axis == 0 ? band.width : band.height;
            demand(period == 0 || (period % (1U << b) == 0 && (period >> b) % side == 0), "a lattice of ", side,
                   " in a period of ", period);
        }
        const std::size_t count = std::size_t{band.width} * band.height * band.depth;
        const bool seen = i >= layer.planes && bands.bands[i - layer.planes].lattice == band.lattice;
        demand(seen || all_finite(band.lattice, count), "a coefficient that is not finite");
    }
}

void check_tone(const weft_tone& tone)
{
    demand(within(tone.count, 1, 64) && tone.pieces && std::isfinite(tone.low) && std::isfinite(tone.high) &&
               tone.low <= tone.high,
           "a tone curve of ", tone.count, " pieces");
    for (std::uint32_t k = 0; k < tone.count; ++k) {
        const weft_piece& piece = tone.pieces[k];
        demand(all_finite(&piece.x, 1) && all_finite(&piece.c0, 1) && all_finite(&piece.c1, 1) &&
                   all_finite(&piece.c2, 1) && all_finite(&piece.c3, 1),
               "a tone curve that is not finite");
        demand(k == 0 ? piece.x <= tone.low : tone.pieces[k - 1].x < piece.x, "a tone curve that descends");
    }
}

void check_layer(const weft_program& program, std::uint32_t index)
{
    const weft_layer& layer = *program.layers[index];
    demand(within(layer.planes, 1, 40) && layer.channels <= layer.planes && layer.channels <= 16, layer.planes,
           " planes, ", layer.channels, " of them coloured");
    check_ref(layer.mask, program, index, "a mask");
    demand(layer.mask.layer == -1 || program.use <= WEFT_USE_POINTS, "a mask in space");
    demand(layer.colour && layer.mean && all_finite(layer.colour, std::size_t{program.channels} * layer.channels) &&
               all_finite(layer.mean, program.channels),
           "a colour that is not finite");
    demand((layer.kind == WEFT_LAYER_SPLAT) == (layer.splat != nullptr) &&
               (layer.kind == WEFT_LAYER_TILE) == (layer.tile != nullptr) &&
               (layer.kind == WEFT_LAYER_BANDS) == (layer.bands != nullptr) &&
               (layer.splat || layer.tile || layer.bands),
           "a layer of kind ", layer.kind);
    demand(layer.splat   ? program.use != WEFT_USE_SOLID
           : layer.bands ? program.use != WEFT_USE_SURFACE
                         : program.use <= WEFT_USE_POINTS,
           "a layer of kind ", layer.kind, " for use ", program.use);
    if (layer.splat) check_splat(*layer.splat, layer, program, index);
    if (layer.tile) check_tile(*layer.tile, program, index);
    if (layer.bands) check_bands(*layer.bands, layer, program);
    for (std::uint32_t c = 0; layer.tones && c < layer.channels; ++c) check_tone(layer.tones[c]);
}

} // namespace

void check_program(const weft_program& program)
{
    demand(program.use >= WEFT_USE_WINDOW && program.use <= WEFT_USE_SOLID, "use ", program.use);
    demand(within(program.channels, 1, 16), program.channels, " channels");
    demand(within(program.layer_count, 1, 32) && program.layers, program.layer_count, " layers");
    for (const std::uint32_t period : program.period) demand(period <= 1U << 24, "a period of ", period);
    for (std::uint32_t i = 0; i < program.layer_count; ++i) check_layer(program, i);
}

} // namespace weft
