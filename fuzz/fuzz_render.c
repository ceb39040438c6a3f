/* A model and a texture's options, both untrusted: what scalar renders and samples, simd gives bit for bit. The first
 * 40 bytes are options and position, the model file follows. */
#include "fuzz.h"

enum { side = 16, points = 8 };

typedef struct request {
    weft_texture_options options;
    int64_t x, y;
    uint32_t level, in_space;
} request;

/* Which step of a mixed model is where. */
static float steps[6] = {0, 0.2f, 0.4f, 1, 0.6f, 0.8f};
static const weft_image map = {steps, 0, 3, 2, 1, WEFT_FORMAT_F32};

static request take_request(const uint8_t** bytes, size_t* size)
{
    request r = {WEFT_TEXTURE_OPTIONS_INIT, 0, 0, 0, 0};
    uint32_t small;
    fuzz_take(bytes, size, &r.options.seed, 8);
    fuzz_take(bytes, size, &r.x, 8);
    fuzz_take(bytes, size, &r.y, 8);
    fuzz_take(bytes, size, &r.options.period_x, 4);
    fuzz_take(bytes, size, &r.options.period_y, 4);
    fuzz_take(bytes, size, &r.options.impacts, 4);
    fuzz_take(bytes, size, &small, 4);
    r.level = small % 33;
    r.in_space = small / 33 & 1;
    if (small / 66 & 1) {
        r.options.mix = &map;
        r.options.mix_scale = (float)(small / 132 % 20);
    }
    const uint32_t layers = small / 2640; /* 0 leaves all that is of bi-layer models alone */
    r.options.rotation = (weft_rotation)(layers % 4);
    r.options.noise = (weft_noise)(layers / 4 % 4);
    r.options.scale_min = (float)(layers / 16 % 8) * 0.25f;
    r.options.turbulence = (float)(layers / 128 % 128) - (layers < 128 ? 0.0f : 1.0f);
    return r;
}

/* Points on a surface of a texton's texture, or of wavelet noise in space. */
static weft_status sample_in_space(const weft_texture* texture, weft_method method, const request* r, float* out)
{
    weft_surface_point surface[points];
    weft_solid_point solid[points];
    memset(surface, 0, sizeof surface);
    memset(solid, 0, sizeof solid);
    for (int i = 0; i < points; ++i) {
        const double place[3] = {(double)(r->x % 100000) + i * 1.37, (double)(r->y % 100000) - i * 0.61, i * 2.5};
        memcpy(surface[i].position, place, sizeof place);
        memcpy(solid[i].position, place, sizeof place);
        surface[i].tangent[i % 3] = surface[i].bitangent[(i + 1) % 3] = 1;
        solid[i].footprint = (float)(i * i) * 0.75f;
    }
    return method == WEFT_METHOD_WAVELET ? weft_texture_sample_solid(texture, points, solid, out)
                                         : weft_texture_sample_surface(texture, points, surface, out);
}

/* 0, or the pixels and points of the texture on a device; at most `channels` of each. */
static weft_status evaluate(const char* device, const weft_model* model, const request* r, const weft_model_info* info,
                            float* out)
{
    const uint32_t channels = info->channels;
    weft_texture* texture = NULL;
    weft_status status = weft_texture_create(fuzz_context(device), model, &r->options, &texture);
    if (status != WEFT_OK) return status;
    weft_image image = {out, 0, side, side, channels, WEFT_FORMAT_F32};
    status = weft_texture_render(texture, r->x, r->y, r->level, NULL, NULL, &image);
    if (status == WEFT_OK) {
        weft_point point[points];
        for (int i = 0; i < points; ++i) {
            const float footprint = (float)(i * i) * 0.75f;
            point[i].x = (double)(r->x % 100000) + i * 1.37;
            point[i].y = (double)(r->y % 100000) - i * 0.61;
            point[i].dx[0] = footprint;
            point[i].dx[1] = (float)i * 0.25f;
            point[i].dy[0] = -0.5f * (float)(i & 1);
            point[i].dy[1] = footprint * 0.125f;
        }
        status = weft_texture_sample(texture, points, point, out + (size_t)side * side * channels);
    }
    if (status == WEFT_OK && r->in_space)
        status = sample_in_space(texture, info->method, r, out + (size_t)(side * side + points) * channels);
    weft_texture_free(texture);
    return status;
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
    enum { values = side * side + 2 * points };
    static float reference[values * 16], other[values * 16];
    const request r = take_request(&bytes, &size);
    weft_model* model = NULL;
    if (weft_model_load(fuzz_context("scalar"), bytes, size, &model) != WEFT_OK) return 0;
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    FUZZ_CHECK(weft_model_get(model, &info) == WEFT_OK);
    /* More impacts than this are slow, not new. */
    if (!(r.options.impacts > 100)) {
        const weft_status status = evaluate("scalar", model, &r, &info, reference);
        const weft_status same = evaluate("simd", model, &r, &info, other);
        FUZZ_CHECK(status == same);
        const size_t count = (size_t)(values - (r.in_space ? 0 : points)) * info.channels;
        if (status == WEFT_OK)
            FUZZ_CHECK(memcmp(reference, other, count * sizeof(float)) == 0);
        else
            fuzz_check_error(status);
    }
    weft_model_free(model);
    return 0;
}
