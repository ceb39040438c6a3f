/* What the fuzz targets share. */
#include "fuzz.h"

weft_context* fuzz_context(const char* device)
{
    static weft_context* contexts[4];
    static char names[4][32];
    for (size_t i = 0; i < 4; ++i) {
        if (contexts[i] && strcmp(names[i], device) == 0) return contexts[i];
        if (contexts[i]) continue;
        weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
        options.threads = 1;
        options.device = device;
        options.memory_limit = UINT64_C(64) << 20;
        FUZZ_CHECK(weft_context_create(&options, &contexts[i]) == WEFT_OK);
        snprintf(names[i], sizeof names[i], "%s", device);
        return contexts[i];
    }
    fprintf(stderr, "fuzz_context: more than four devices\n");
    abort();
}

void fuzz_check_error(weft_status status)
{
    FUZZ_CHECK(status < 0 && status > WEFT_ERROR_INTERNAL);
    FUZZ_CHECK(strncmp(weft_status_name(status), "WEFT_ERROR_", 11) == 0);
    FUZZ_CHECK(weft_error_message()[0] != '\0');
}

void fuzz_take(const uint8_t** bytes, size_t* size, void* value, size_t count)
{
    const size_t there = *size < count ? *size : count;
    memset(value, 0, count);
    if (there) memcpy(value, *bytes, there);
    *bytes += there;
    *size -= there;
}

static int is_finite(float value) { return value - value == 0; }

static void check_info(const weft_model* model, const weft_model_info* info)
{
    const int wavelet = info->method == WEFT_METHOD_WAVELET, tile = info->method == WEFT_METHOD_STATIONARY;
    FUZZ_CHECK(info->method >= WEFT_METHOD_TEXTON && info->method <= WEFT_METHOD_PICTURE);
    FUZZ_CHECK(info->channels >= 1 && info->channels <= 16 && (info->parts == 0) == wavelet);
    FUZZ_CHECK(info->width <= 16384 && info->height <= 16384 && (info->width == 0) == wavelet);
    FUZZ_CHECK((info->photo_width > 0) == tile && (info->photo_height > 0) == tile);
    FUZZ_CHECK(info->model_error == -1 || (info->model_error >= 0 && is_finite(info->model_error)));
    for (uint32_t c = 0; c < info->channels; ++c) FUZZ_CHECK(is_finite(info->mean[c]) && info->deviation[c] >= 0);
    for (uint32_t i = 0; i < info->parts; ++i) {
        weft_part_info part = WEFT_PART_INFO_INIT;
        FUZZ_CHECK(weft_model_part(model, i, &part) == WEFT_OK);
        FUZZ_CHECK(part.low <= part.high && memchr(part.name, 0, sizeof part.name));
    }
}

/* The bytes of a model, of which there are info->bytes. */
static uint8_t* save(const weft_model* model, const weft_model_info* info)
{
    uint8_t* bytes = malloc((size_t)info->bytes);
    FUZZ_CHECK(bytes && weft_model_save(model, bytes, (size_t)info->bytes) == WEFT_OK);
    return bytes;
}

/* The parameters of wavelet noise make the same model. */
static void check_wavelet(weft_context* context, const weft_model* model, const weft_model_info* info,
                          const uint8_t* bytes)
{
    weft_wavelet wavelet = WEFT_WAVELET_INIT;
    weft_model* again = NULL;
    const weft_status status = weft_model_get_wavelet(model, &wavelet);
    FUZZ_CHECK((status == WEFT_OK) == (info->method == WEFT_METHOD_WAVELET));
    if (status != WEFT_OK) return;
    FUZZ_CHECK(weft_model_from_wavelet(context, &wavelet, &again) == WEFT_OK);
    uint8_t* saved = save(again, info);
    FUZZ_CHECK(memcmp(saved, bytes, (size_t)info->bytes) == 0);
    free(saved);
    weft_model_free(again);
}

/* Whatever the correspondence says, it says of the photo's pixels. */
static void check_apply(const weft_model* model, const weft_model_info* info)
{
    enum { most = 1 << 16 };
    static uint8_t map[most], tile[most];
    if ((uint64_t)info->photo_width * info->photo_height > most || (uint64_t)info->width * info->height > most) return;
    if (info->method != WEFT_METHOD_STATIONARY) return;
    const weft_image from = {map, 0, info->photo_width, info->photo_height, 1, WEFT_FORMAT_U8},
                     to = {tile, 0, info->width, info->height, 1, WEFT_FORMAT_U8};
    memset(map, 77, sizeof map);
    FUZZ_CHECK(weft_model_apply(model, &from, &to) == WEFT_OK);
    for (uint32_t i = 0; i < info->width * info->height; ++i) FUZZ_CHECK(tile[i] == 77);
}

void fuzz_check_model(weft_context* context, const weft_model* model)
{
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    weft_model* again = NULL;
    FUZZ_CHECK(weft_model_get(model, &info) == WEFT_OK);
    check_info(model, &info);
    check_apply(model, &info);
    FUZZ_CHECK(info.bytes < UINT64_C(64) << 20);
    uint8_t* first = save(model, &info);
    FUZZ_CHECK(weft_model_load(context, first, (size_t)info.bytes, &again) == WEFT_OK);
    uint8_t* second = save(again, &info);
    FUZZ_CHECK(memcmp(first, second, (size_t)info.bytes) == 0);
    check_wavelet(context, model, &info, first);
    weft_model_free(again);
    free(first);
    free(second);
}
