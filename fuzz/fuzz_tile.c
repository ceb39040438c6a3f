/* A small photo and arbitrary options: a stationary tile, or a status; and its costs. The first 36 bytes are options
 * and sizes, pixels follow. */
#include "fuzz.h"

enum { most_side = 24, largest = 80 };

static int32_t count_down(void* user, float done)
{
    int* left = user;
    FUZZ_CHECK(done >= 0 && done <= 1);
    return (*left)-- == 0;
}

static void check_costs(weft_context* context, const weft_image* photo, int measure, uint32_t patch, float sigma)
{
    weft_stationarity_options stationarity = WEFT_STATIONARITY_OPTIONS_INIT;
    weft_texture_cost_options texture = WEFT_TEXTURE_COST_OPTIONS_INIT;
    float cost = -1;
    stationarity.stationarity = measure;
    stationarity.sigma = sigma;
    texture.patch = patch;
    texture.samples = 8;
    weft_status status = weft_stationarity_cost(context, photo, &stationarity, NULL, NULL, NULL, &cost);
    if (status != WEFT_OK)
        fuzz_check_error(status);
    else
        FUZZ_CHECK(cost >= 0);
    status = weft_texture_cost(context, photo, photo, &texture, NULL, NULL, &cost);
    if (status != WEFT_OK)
        fuzz_check_error(status);
    else
        FUZZ_CHECK(cost >= 0);
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
    static float pixels[most_side * most_side * 16 + 1], map_pixels[4];
    weft_context* context = fuzz_context("scalar");
    weft_stationary_options options = WEFT_STATIONARY_OPTIONS_INIT;
    uint8_t shape[8];
    fuzz_take(&bytes, &size, shape, sizeof shape);
    fuzz_take(&bytes, &size, (char*)&options + sizeof options.size, 28);
    if (options.width - 1 >= largest) options.width = 64 + options.width % 16; /* larger ones, as the default is, are slow, not new */
    if (options.height - 1 >= largest) options.height = 64 + options.height % 16;
    const weft_image photo = {pixels,        0,           1 + shape[0] % most_side, 1 + shape[1] % most_side,
                              shape[2] % 18, shape[3] % 5};
    const weft_image map = {map_pixels, 0, 2, 2, 1, WEFT_FORMAT_F32};
    if (shape[4] & 1) {
        fuzz_take(&bytes, &size, map_pixels, sizeof map_pixels);
        options.sigma_map = &map;
    }
    memset(pixels, 0, sizeof pixels);
    memcpy(pixels, bytes, size < sizeof pixels ? size : sizeof pixels);

    weft_model* model = NULL;
    /* Oriented bands, high moments and many channels take minutes under a sanitizer: only their beginning is seen. */
    const int slow = options.stationarity == WEFT_STATIONARITY_STEERABLE || options.moments > 2 || photo.channels > 4;
    int left = slow ? shape[5] % 16 : shape[5] == 0 ? -1 : shape[5];
    options.seed = shape[6];
    const weft_status status = weft_analyze_stationary(context, &photo, &options, count_down, &left, &model);
    if (status == WEFT_OK) {
        fuzz_check_model(context, model);
        weft_model_free(model);
    } else {
        fuzz_check_error(status);
        FUZZ_CHECK(model == NULL);
    }
    if (shape[7] & 1) check_costs(context, &photo, options.stationarity, options.patch, options.sigma);
    return 0;
}
