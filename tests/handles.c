/* Contexts, models, textures and their pixels for the tests; every failure ends the test. */
#include "support.h"
#include <stdlib.h>

weft_context *new_context(const char *device, uint32_t threads)
{
    weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
    weft_context *context = NULL;
    options.device = device;
    options.threads = threads;
    assert_ok(weft_context_create(&options, &context));
    assert_non_null(context);
    return context;
}

weft_model *new_texton(weft_context *context, uint32_t side, uint32_t channels, uint32_t support,
                       weft_interpolation interpolation, uint64_t seed)
{
    weft_image photo = new_grain(GRAIN_SOFT, side, side, channels, seed);
    weft_texton_options options = WEFT_TEXTON_OPTIONS_INIT;
    weft_model *model = NULL;
    options.support = support;
    options.iterations = 3;
    options.interpolation = interpolation;
    options.seed = seed;
    assert_ok(weft_analyze_texton(context, &photo, &options, NULL, NULL, &model));
    assert_non_null(model);
    free_image(&photo);
    return model;
}

weft_model *new_picture(weft_context *context, uint32_t width, uint32_t height, uint32_t channels, uint64_t seed)
{
    weft_image picture = new_grain(GRAIN_WHITE, width, height, channels, seed);
    weft_model *model = NULL;
    assert_ok(weft_analyze_picture(context, &picture, &model));
    assert_non_null(model);
    free_image(&picture);
    return model;
}

weft_texture *new_texture(weft_context *context, const weft_model *model, float impacts, uint64_t seed, uint32_t period)
{
    weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    weft_texture *texture = NULL;
    options.impacts = impacts;
    options.seed = seed;
    options.period_x = options.period_y = period;
    assert_ok(weft_texture_create(context, model, &options, &texture));
    assert_non_null(texture);
    return texture;
}

weft_image rendered(const weft_texture *texture, int64_t x, int64_t y, uint32_t level, uint32_t width, uint32_t height,
                    uint32_t channels)
{
    weft_image image = new_image(width, height, channels, WEFT_FORMAT_F32);
    fill_bytes(&image, 0xff);
    assert_ok(weft_texture_render(texture, x, y, level, NULL, NULL, &image));
    return image;
}

void *saved(const weft_model *model, size_t *size)
{
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    assert_ok(weft_model_get(model, &info));
    void *bytes = malloc((size_t)info.bytes);
    assert_non_null(bytes);
    assert_ok(weft_model_save(model, bytes, (size_t)info.bytes));
    *size = (size_t)info.bytes;
    return bytes;
}

weft_image part_of(const weft_model *model, uint32_t index)
{
    weft_part_info info = WEFT_PART_INFO_INIT;
    assert_ok(weft_model_part(model, index, &info));
    weft_image image = new_image(info.width, info.height, info.channels, WEFT_FORMAT_F32);
    assert_ok(weft_model_part_read(model, index, &image));
    return image;
}
