/* A small image and arbitrary options: analysis, comparison and description end with a status, within 64 MiB. The first
 * 36 bytes are options and sizes, pixels follow. */
#include "fuzz.h"

enum { most_side = 28, least_layered = 32, most_layered = 39 };

static int32_t count_down(void* user, float done)
{
    int* left = user;
    FUZZ_CHECK(done >= 0 && done <= 1);
    return (*left)-- == 0;
}

static void compare(weft_context* context, const weft_image* image, uint64_t seed)
{
    weft_compare_options options = WEFT_COMPARE_OPTIONS_INIT;
    weft_comparison comparison = WEFT_COMPARISON_INIT;
    options.seed = seed;
    const weft_status status = weft_compare(context, image, image, &options, NULL, NULL, &comparison);
    if (status != WEFT_OK)
        fuzz_check_error(status);
    else
        FUZZ_CHECK(comparison.histogram_distance == -1 || comparison.histogram_distance >= 0);
}

static void describe(weft_context* context, const weft_image* image)
{
    weft_description description = WEFT_DESCRIPTION_INIT;
    const weft_status status = weft_describe(context, image, NULL, NULL, &description);
    if (status != WEFT_OK)
        fuzz_check_error(status);
    else
        FUZZ_CHECK(memchr(description.reasons, 0, sizeof description.reasons) && description.anisotropy <= 1);
}

/* As wavelet noise, with the texton's options in the place of its own. */
static weft_status analyze_wavelet(weft_context* context, const weft_image* image, const weft_texton_options* texton,
                                   int* left, weft_model** model)
{
    weft_wavelet_options options = WEFT_WAVELET_OPTIONS_INIT;
    options.bands = texton->support;
    options.tone_knots = texton->iterations;
    options.gaussian = (uint32_t)texton->interpolation;
    return weft_analyze_wavelet(context, image, &options, count_down, left, model);
}

/* As a bi-layer texture, likewise; what only takes longer is kept small. */
static weft_status analyze_bilayer(weft_context* context, weft_image image, const weft_texton_options* texton,
                                   int* left, weft_model** model)
{
    weft_bilayer_options options = WEFT_BILAYER_OPTIONS_INIT;
    image.width = least_layered + image.width % (most_layered - least_layered + 1);
    image.height = least_layered + image.height % (most_layered - least_layered + 1);
    options.noises = texton->support % 8;
    options.window = options.mask_window = texton->iterations;
    options.support = 8 + texton->support % 32;
    options.masks = texton->projection;
    options.structure = texton->interpolation;
    options.colours = 2;
    options.border = texton->support / 8 % 80;
    options.equalize = texton->support / 1024 % 2;
    options.depth = texton->support / 2048 % 3;
    options.filter_width = 2 + texton->support / 8192 % 8;
    options.filter_iterations = 1;
    options.seed = texton->seed;
    return weft_analyze_bilayer(context, &image, &options, count_down, left, model);
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
    static float pixels[most_layered * most_layered * 16 + 1];
    weft_context* context = fuzz_context("scalar");
    weft_texton_options options = WEFT_TEXTON_OPTIONS_INIT;
    uint8_t shape[8];
    fuzz_take(&bytes, &size, shape, sizeof shape);
    fuzz_take(&bytes, &size, (char*)&options + sizeof options.size, sizeof options - sizeof options.size);
    if (shape[7] & 1)
        options.iterations %= 16; /* more of them are slow, not new */
    else
        options.iterations = 1;
    const uint32_t width = 1 + shape[0] % most_side, height = 1 + shape[1] % most_side, channels = shape[2] % 18;
    weft_image image = {pixels, 0, width, height, channels, shape[3] % 5};
    memset(pixels, 0, sizeof pixels);
    memcpy(pixels, bytes, size < sizeof pixels ? size : sizeof pixels);

    weft_model* model = NULL;
    int left = shape[5] == 0 ? -1 : shape[5];
    weft_status status;
    if (shape[4] % 4 == 0)
        status = weft_analyze_picture(context, &image, &model);
    else if (shape[4] % 8 == 5)
        status = analyze_wavelet(context, &image, &options, &left, &model);
    else if (shape[4] % 16 == 14)
        status = analyze_bilayer(context, image, &options, &left, &model);
    else
        status = weft_analyze_texton(context, &image, &options, count_down, &left, &model);
    if (status == WEFT_OK) {
        fuzz_check_model(context, model);
        weft_model_free(model);
    } else {
        fuzz_check_error(status);
        FUZZ_CHECK(model == NULL);
    }
    if (shape[6] % 64 == 63) compare(context, &image, options.seed);
    if (shape[6] % 64 == 62) describe(context, &image);
    return 0;
}
