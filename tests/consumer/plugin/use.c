/* use PLAIN TINTED: renders through two plug-ins that libweft has never seen. PLAIN is a path to load, or - if
 * WEFT_BACKEND_PATH leads to it; its pixels are those of "scalar". TINTED adds 1/4, which shows whose pixels they were.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <weft/weft.h>

enum { width = 37, height = 23, channels = 3, side = 48, values = side * side * channels, points = 64 };

static void demand(int good, const char *what)
{
    if (good) return;
    fprintf(stderr, "%s: %s\n", what, weft_error_message());
    exit(1);
}

static weft_context *open_context(const char *device)
{
    weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
    weft_context *context = NULL;
    options.device = device;
    demand(weft_context_create(&options, &context) == WEFT_OK, device);
    return context;
}

static void render(weft_context *context, const weft_model *model, uint32_t period, int64_t x, int64_t y,
                   uint32_t level, float *out)
{
    weft_texture_options options = WEFT_TEXTURE_OPTIONS_INIT;
    weft_texture *texture = NULL;
    weft_point point[points];
    const weft_image image = {out, 0, side, side, channels, WEFT_FORMAT_F32};
    int i;
    options.period_x = period * width;
    options.period_y = period * height;
    demand(weft_texture_create(context, model, &options, &texture) == WEFT_OK, "texture");
    demand(weft_texture_render(texture, x, y, level, NULL, NULL, &image) == WEFT_OK, "render");
    for (i = 0; i < points; ++i) {
        const float d = (float)i * 0.3f;
        const weft_point p = {(double)x + i * 3.7, (double)y - i * 1.3, {d, 0.1f}, {-0.2f, d * 0.5f}};
        point[i] = p;
    }
    demand(weft_texture_sample(texture, points, point, out + values) == WEFT_OK, "sample");
    weft_texture_free(texture);
}

static int listed(const char *name, uint32_t exact)
{
    uint32_t count = 0, i;
    demand(weft_device_count(&count) == WEFT_OK, "count");
    for (i = 0; i < count; ++i) {
        weft_device_info info = WEFT_DEVICE_INFO_INIT;
        demand(weft_device_get(i, &info) == WEFT_OK, "device");
        if (strcmp(info.name, name) == 0 && info.status == WEFT_OK && info.exact == exact) return 1;
    }
    return 0;
}

int main(int count, char **arguments)
{
    static float photo[width * height * channels], a[values + points * channels], b[values + points * channels];
    static const int64_t places[][2] = {{0, 0}, {-1000, 77}, {INT64_C(1) << 40, -(INT64_C(1) << 40)}};
    const weft_image in = {photo, 0, width, height, channels, WEFT_FORMAT_F32};
    weft_model *picture = NULL, *noise = NULL;
    weft_context *scalar, *plain, *tinted;
    uint32_t state = 5, level, period, i;
    size_t k;
    demand(count == 3, "two arguments");
    for (k = 0; k < sizeof photo / sizeof *photo; ++k) {
        state = state * 1664525u + 1013904223u;
        photo[k] = (float)(state >> 8) * 0x1p-24f;
    }
    if (strcmp(arguments[1], "-") != 0) demand(weft_backend_load(arguments[1]) == WEFT_OK, arguments[1]);
    demand(weft_backend_load(arguments[2]) == WEFT_OK, arguments[2]);
    demand(listed("plain:c", 1) && listed("tinted:c", 0), "the list of devices");
    scalar = open_context("scalar");
    plain = open_context("plain");
    tinted = open_context("tinted:c");
    demand(weft_analyze_picture(scalar, &in, &picture) == WEFT_OK, "picture");
    demand(weft_analyze_texton(scalar, &in, NULL, NULL, NULL, &noise) == WEFT_OK, "noise");
    for (i = 0; i < 3; ++i)
        for (level = 0; level < 8; ++level)
            for (period = 0; period < 3; ++period) {
                render(scalar, picture, period, places[i][0], places[i][1], level, a);
                render(plain, picture, period, places[i][0], places[i][1], level, b);
                demand(memcmp(a, b, sizeof a) == 0, "plain is not exact");
                render(tinted, picture, period, places[i][0], places[i][1], level, b);
                for (k = 0; k < values + points * channels; ++k)
                    demand(b[k] > a[k] + 0.249f && b[k] < a[k] + 0.251f, "the pixels are not the plug-in's");
            }
    /* What a plug-in does not support is evaluated by "scalar". */
    render(scalar, noise, 0, 5, 6, 0, a);
    render(tinted, noise, 0, 5, 6, 0, b);
    demand(memcmp(a, b, sizeof a) == 0, "the noise is not scalar's");
    weft_model_free(picture);
    weft_model_free(noise);
    weft_context_free(scalar);
    weft_context_free(plain);
    weft_context_free(tinted);
    return 0;
}
