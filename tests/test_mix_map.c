/* Mixing: a map's steps are seen where the map has them, not half a texton beside. */
#include "estimate.h"
#include <stdlib.h>

#define WIDTH 128 /* of the output and of the map's period: half of it faint, half strong, twice within the width */
#define HEIGHT 1024

static weft_model *grain_of(weft_context *context, float contrast)
{
    weft_image photo = new_grain(GRAIN_SOFT, 48, 48, 1, 4);
    weft_texton_options options = WEFT_TEXTON_OPTIONS_INIT;
    weft_model *model = NULL;
    options.support = 16;
    double mean = 0;
    for (uint32_t i = 0; i < 48 * 48; ++i) mean += (double)values(&photo)[i] / (48 * 48);
    for (uint32_t i = 0; i < 48 * 48; ++i)
        values(&photo)[i] = (float)(0.5 + (double)contrast * ((double)values(&photo)[i] - mean));
    assert_ok(weft_analyze_texton(context, &photo, &options, NULL, NULL, &model));
    free_image(&photo);
    return model;
}

/* Columns to the right of the map's edge in whose stead the output has a border from faint to strong, and back. */
static void borders_are_where_the_map_has_them(void **state)
{
    (void)state;
    weft_context *context = new_context(NULL, 0);
    weft_model *faint = grain_of(context, 0.1f), *strong = grain_of(context, 1), *mixed = NULL;
    assert_ok(weft_model_mix(context, faint, strong, 0, 2, &mixed));
    weft_image map = new_image(2, 1, 1, WEFT_FORMAT_F32);
    values(&map)[0] = 0;
    values(&map)[1] = 1;
    Estimate rising = {0, 0, 0}, falling = {0, 0, 0};
    for (uint32_t n = 0; n < 40; ++n) {
        weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
        weft_texture *texture = NULL;
        options.mix = &map;
        options.mix_scale = WIDTH / 2;
        options.seed = n;
        assert_ok(weft_texture_create(context, mixed, &options, &texture));
        weft_image image = rendered(texture, 0, 0, 0, WIDTH, HEIGHT, 1);
        double power[WIDTH] = {0}, plateau = 0;
        for (uint32_t y = 0; y < HEIGHT; ++y)
            for (uint32_t x = 0; x < WIDTH; ++x) {
                const double difference = (double)value_at(&image, x, y, 0) - 0.5;
                power[x] += difference * difference / HEIGHT;
            }
        /* A quarter of the width around each edge. */
        for (uint32_t x = WIDTH * 11 / 16; x < WIDTH * 13 / 16; ++x) plateau += power[x] / (WIDTH / 8);
        double before = 0, after = 0;
        for (uint32_t x = WIDTH / 4; x < WIDTH * 3 / 4; ++x) before += power[x] / plateau;
        for (uint32_t x = 0; x < WIDTH / 4; ++x) after += (power[x] + power[x + WIDTH * 3 / 4]) / plateau;
        add(&rising, WIDTH / 4 - before);
        add(&falling, after - WIDTH / 4);
        free_image(&image);
        weft_texture_free(texture);
    }
    /* Linear interpolation of the map spreads both borders alike, the faint half adds a hundredth. */
    assert_expected(&rising, 0, 3, "columns to the right: border", 1);
    assert_expected(&falling, 0, 3, "columns to the right: border", 2);
    free_image(&map);
    weft_model_free(mixed);
    weft_model_free(strong);
    weft_model_free(faint);
    weft_context_free(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(borders_are_where_the_map_has_them)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
