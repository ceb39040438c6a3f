/* Uses libweft as an application does: a synthetic photo, its texton, a window of its noise. With an argument the simd
 * plug-in must have been found. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <weft/weft.h>

enum { side = 64, wide = 128 };

static int bad(const char *what)
{
    fprintf(stderr, "%s: %s\n", what, weft_error_message());
    return 1;
}

static int has_device(const char *backend)
{
    uint32_t count = 0, i;
    if (weft_device_count(&count) != WEFT_OK) return 0;
    for (i = 0; i < count; ++i) {
        weft_device_info info = WEFT_DEVICE_INFO_INIT;
        if (weft_device_get(i, &info) != WEFT_OK) return 0;
        printf("%s: %s\n", info.name, info.description);
        if (strncmp(info.name, backend, strlen(backend)) == 0 && info.status == WEFT_OK) return 1;
    }
    return 0;
}

int main(int count, char **arguments)
{
    static unsigned char photo[side * side * 3], out[wide * wide * 3];
    const weft_image in = {photo, 0, side, side, 3, WEFT_FORMAT_U8}, window = {out, 0, wide, wide, 3, WEFT_FORMAT_U8};
    weft_context *context = NULL;
    weft_model *model = NULL;
    weft_texture *texture = NULL;
    uint32_t state = 1;
    size_t i;
    double sum = 0, expected = 0;
    for (i = 0; i < sizeof photo; ++i) {
        state = state * 1664525u + 1013904223u;
        photo[i] = (unsigned char)(64 + (state >> 25));
        expected += photo[i] / (double)sizeof photo;
    }
    if (weft_version() >> 8 != (WEFT_VERSION_MAJOR << 8 | WEFT_VERSION_MINOR)) return bad("version");
    if (!has_device("scalar")) return bad("scalar");
    if (count > 1 && strcmp(arguments[1], "plugins") == 0 && !has_device("simd")) return bad("simd");
    if (weft_context_create(NULL, &context) != WEFT_OK) return bad("context");
    if (weft_analyze_texton(context, &in, NULL, NULL, NULL, &model) != WEFT_OK) return bad("analysis");
    if (weft_texture_create(context, model, NULL, &texture) != WEFT_OK) return bad("texture");
    if (weft_texture_render(texture, 0, 0, 0, NULL, NULL, &window) != WEFT_OK) return bad("render");
    for (i = 0; i < sizeof out; ++i) sum += out[i] / (double)sizeof out;
    weft_texture_free(texture);
    weft_model_free(model);
    weft_context_free(context);
    printf("mean of the photo %.2f, of the texture %.2f\n", expected, sum);
    return sum > expected - 4 && sum < expected + 4 ? 0 : bad("mean");
}
