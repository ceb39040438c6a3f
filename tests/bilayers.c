/* Small bi-layer models of every kind. */
#include "bilayers.h"
#include <string.h>

weft_image new_discs(uint32_t width, uint32_t height, uint32_t channels, uint64_t seed)
{
    Random random = {seed};
    weft_image ground = new_grain(GRAIN_SOFT, width, height, channels, seed),
               discs = new_grain(GRAIN_STREAKS, width, height, channels, seed + 1);
    for (uint32_t i = 0; i < width * height / 300 + 2; ++i) {
        const int x = (int)random_below(&random, width), y = (int)random_below(&random, height);
        const int radius = 4 + (int)random_below(&random, 5);
        for (int v = -radius; v <= radius; ++v)
            for (int u = -radius; u <= radius; ++u) {
                if (u * u + v * v > radius * radius || x + u < 0 || y + v < 0 || x + u >= (int)width ||
                    y + v >= (int)height)
                    continue;
                const size_t at = ((size_t)(y + v) * width + (size_t)(x + u)) * channels;
                for (uint32_t c = 0; c < channels; ++c)
                    values(&ground)[at + c] = values(&discs)[at + c] + (c % 2 ? -0.25f : 0.25f);
            }
    }
    free_image(&discs);
    return ground;
}

static const struct Kind {
    const char *name;
    uint32_t width, height, channels, noises;
    weft_structure structure;
    weft_masks masks;
    uint32_t equalize, border;
} kinds[BILAYER_KINDS] = {
    {"wang", 48, 48, 3, 2, WEFT_STRUCTURE_WANG, WEFT_MASKS_BINARY, 0, 0},
    {"exchange", 64, 48, 3, 2, WEFT_STRUCTURE_EXCHANGE, WEFT_MASKS_BINARY, 0, 0},
    {"both", 64, 64, 1, 2, WEFT_STRUCTURE_BOTH, WEFT_MASKS_BINARY, 0, 0},
    {"no structure", 48, 40, 3, 3, WEFT_STRUCTURE_NONE, WEFT_MASKS_BINARY, 0, 0},
    {"stationary", 40, 48, 2, 1, WEFT_STRUCTURE_NONE, WEFT_MASKS_BINARY, 0, 0},
    {"barycentric", 48, 48, 3, 3, WEFT_STRUCTURE_WANG, WEFT_MASKS_BARYCENTRIC, 0, 0},
    {"equalized", 48, 48, 4, 2, WEFT_STRUCTURE_EXCHANGE, WEFT_MASKS_BINARY, 1, 3},
    {"auto", 48, 64, 1, 0, WEFT_STRUCTURE_AUTO, WEFT_MASKS_DEFAULT, 0, 0},
};

const char *bilayer_kind(uint32_t kind) { return kinds[kind].name; }

weft_bilayer_options bilayer_options(uint32_t kind)
{
    weft_bilayer_options options = WEFT_BILAYER_OPTIONS_INIT;
    options.noises = kinds[kind].noises;
    options.structure = kinds[kind].structure;
    options.masks = kinds[kind].masks;
    options.equalize = kinds[kind].equalize;
    options.border = kinds[kind].border;
    options.window = options.mask_window = 4;
    options.support = 16;
    options.seed = kind;
    return options;
}

weft_model *new_bilayer(weft_context *context, uint32_t kind)
{
    const weft_bilayer_options options = bilayer_options(kind);
    weft_image photo = new_discs(kinds[kind].width, kinds[kind].height, kinds[kind].channels, 7 + kind);
    weft_model *model = NULL;
    assert_ok(weft_analyze_bilayer(context, &photo, &options, NULL, NULL, &model));
    free_image(&photo);
    return model;
}

uint32_t part_named(const weft_model *model, const char *name)
{
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    assert_ok(weft_model_get(model, &info));
    for (uint32_t i = 0; i < info.parts; ++i) {
        weft_part_info part = WEFT_PART_INFO_INIT;
        assert_ok(weft_model_part(model, i, &part));
        if (strcmp(part.name, name) == 0) return i;
    }
    fail_msg("the model has no part %s", name);
    return 0;
}
