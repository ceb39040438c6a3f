/* Devices, contexts, models and textures with every wrong argument: the status, a sentence that names function and
 * argument, untouched outputs. */
#include "refusals.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static weft_context *context;
static weft_model *texton, *picture;
static weft_texture *noise;

static int begin(void **state)
{
    (void)state;
    context = new_context("scalar", 1);
    texton = new_texton(context, 32, 3, 8, WEFT_INTERPOLATION_LINEAR, 1);
    picture = new_picture(context, 12, 10, 2, 2);
    noise = new_texture(context, texton, 0, 0, 0);
    return 0;
}

static int end(void **state)
{
    (void)state;
    weft_texture_free(noise);
    weft_model_free(picture);
    weft_model_free(texton);
    weft_context_free(context);
    return 0;
}

static void devices(void **state)
{
    (void)state;
    weft_device_info info, before;
    uint32_t count = 0;
    assert_ok(weft_device_count(&count));
    assert_true(count >= 1);
    REFUSED(weft_device_count(NULL), "weft_device_count", "count");
    REFUSED(weft_device_get(0, NULL), "weft_device_get", "info");
    const uint32_t sizes[] = {0, 1, 3};
    for (size_t i = 0; i < 3; ++i) {
        memset(&info, 0xa5, sizeof info);
        info.size = sizes[i];
        before = info;
        REFUSED(weft_device_get(0, &info), "weft_device_get", "size");
        assert_memory_equal(&info, &before, sizeof info);
    }
    const uint32_t indices[] = {count, count + 1, UINT32_MAX};
    for (size_t i = 0; i < 3; ++i) {
        memset(&info, 0xa5, sizeof info);
        info.size = sizeof info;
        before = info;
        REFUSED(weft_device_get(indices[i], &info), "weft_device_get", "index");
        assert_memory_equal(&info, &before, sizeof info);
    }
    REFUSED(weft_backend_load(NULL), "weft_backend_load", "path");
}

static void contexts(void **state)
{
    (void)state;
    weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
    weft_context *out;
    const char *function = "weft_context_create";
    REFUSED(weft_context_create(&options, NULL), function, "context");
    const uint32_t sizes[] = {0, 1, 3};
    for (size_t i = 0; i < 3; ++i) {
        options.size = sizes[i];
        REFUSED_HANDLE(weft_context_create(&options, &out), out, WEFT_ERROR_ARGUMENT, function, "size");
    }
    const char *devices_of_nobody[] = {"",          "nobody", "scalar:1", "simd:nothing", "opencl:4000000000",
                                       "opencl:-1", ":",      "scalar "};
    for (size_t i = 0; i < sizeof devices_of_nobody / sizeof *devices_of_nobody; ++i) {
        const weft_context_options fresh = WEFT_CONTEXT_OPTIONS_INIT;
        options = fresh;
        options.device = devices_of_nobody[i];
        REFUSED_HANDLE(weft_context_create(&options, &out), out, WEFT_ERROR_DEVICE, function, devices_of_nobody[i]);
    }
    const weft_context_options fresh = WEFT_CONTEXT_OPTIONS_INIT;
    const weft_allocator no_allocator = {NULL, NULL, NULL};
    const weft_executor no_executor = {NULL, NULL};
    options = fresh;
    options.allocator = &no_allocator;
    REFUSED_HANDLE(weft_context_create(&options, &out), out, WEFT_ERROR_ARGUMENT, function, "allocator");
    options = fresh;
    options.executor = &no_executor;
    REFUSED_HANDLE(weft_context_create(&options, &out), out, WEFT_ERROR_ARGUMENT, function, "executor");

    weft_device_info info = WEFT_DEVICE_INFO_INIT;
    REFUSED(weft_context_device(NULL, &info), "weft_context_device", "context");
    REFUSED(weft_context_device(context, NULL), "weft_context_device", "info");
    info.size = 2;
    REFUSED(weft_context_device(context, &info), "weft_context_device", "size");
    assert_string_equal(info.name, "");
    weft_context_free(NULL);
}

static void models(void **state)
{
    (void)state;
    size_t size = 0, length = 12345;
    unsigned char *bytes = saved(texton, &size);
    weft_model *model;
    const weft_status argument = WEFT_ERROR_ARGUMENT;
    REFUSED_HANDLE(weft_model_load(NULL, bytes, size, &model), model, argument, "weft_model_load", "context");
    REFUSED_HANDLE(weft_model_load(context, NULL, size, &model), model, argument, "weft_model_load", "bytes");
    REFUSED(weft_model_load(context, bytes, size, NULL), "weft_model_load", "model");
    REFUSED_HANDLE(weft_model_load(context, bytes, 0, &model), model, WEFT_ERROR_FORMAT, "weft_model_load", "");

    memset(bytes, 0xa5, size);
    REFUSED(weft_model_save(NULL, bytes, size), "weft_model_save", "model");
    REFUSED(weft_model_save(texton, NULL, size), "weft_model_save", "bytes");
    REFUSED(weft_model_save(texton, bytes, size - 1), "weft_model_save", "size");
    REFUSED(weft_model_save(texton, bytes, size + 1), "weft_model_save", "size");
    REFUSED(weft_model_save(texton, bytes, 0), "weft_model_save", "size");
    REFUSED(weft_model_save(texton, bytes, SIZE_MAX), "weft_model_save", "size");
    for (size_t i = 0; i < size; ++i) assert_int_equal(bytes[i], 0xa5);

    const char *text = "TEXTON\n";
    REFUSED_HANDLE(weft_model_load_texton(NULL, text, 7, &model), model, argument, "weft_model_load_texton", "context");
    REFUSED_HANDLE(weft_model_load_texton(context, NULL, 7, &model), model, argument, "weft_model_load_texton", "text");
    REFUSED(weft_model_load_texton(context, text, 7, NULL), "weft_model_load_texton", "model");
    REFUSED_HANDLE(weft_model_load_texton(context, text, 0, &model), model, WEFT_ERROR_FORMAT, "weft_model_load_texton",
                   "");
    REFUSED(weft_model_save_texton(NULL, (char *)bytes, size, &length), "weft_model_save_texton", "model");
    REFUSED(weft_model_save_texton(texton, NULL, 10, &length), "weft_model_save_texton", "text");
    REFUSED(weft_model_save_texton(texton, (char *)bytes, 3, &length), "weft_model_save_texton", "size");
    REFUSED(weft_model_save_texton(texton, NULL, 0, NULL), "weft_model_save_texton", "length");
    assert_refused(weft_model_save_texton(picture, NULL, 0, &length), WEFT_ERROR_UNSUPPORTED, "weft_model_save_texton",
                   "");
    assert_int_equal(length, 12345);
    for (size_t i = 0; i < size; ++i) assert_int_equal(bytes[i], 0xa5);
    free(bytes);
    weft_model_free(NULL);
}

static void model_info_and_parts(void **state)
{
    (void)state;
    weft_model_info info;
    weft_part_info part;
    memset(&info, 0xa5, sizeof info);
    memset(&part, 0xa5, sizeof part);
    info.size = part.size = 0;
    const weft_model_info info_before = info;
    const weft_part_info part_before = part;
    REFUSED(weft_model_get(texton, &info), "weft_model_get", "size");
    REFUSED(weft_model_part(texton, 0, &part), "weft_model_part", "size");
    REFUSED(weft_model_get(NULL, &info), "weft_model_get", "model");
    REFUSED(weft_model_get(texton, NULL), "weft_model_get", "info");
    REFUSED(weft_model_part(NULL, 0, &part), "weft_model_part", "model");
    REFUSED(weft_model_part(texton, 0, NULL), "weft_model_part", "info");
    assert_memory_equal(&info, &info_before, sizeof info);
    assert_memory_equal(&part, &part_before, sizeof part);
    const weft_model_info fresh_info = WEFT_MODEL_INFO_INIT;
    const weft_part_info fresh_part = WEFT_PART_INFO_INIT;
    info = fresh_info;
    part = fresh_part;
    assert_ok(weft_model_get(texton, &info));
    REFUSED(weft_model_part(texton, info.parts, &part), "weft_model_part", "index");
    REFUSED(weft_model_part(texton, UINT32_MAX, &part), "weft_model_part", "index");
    assert_memory_equal(&part, &fresh_part, sizeof part);

    weft_image image = part_of(texton, 0);
    const weft_image good = image;
    fill_bytes(&image, 0xa5);
    REFUSED(weft_model_part_read(NULL, 0, &image), "weft_model_part_read", "model");
    REFUSED(weft_model_part_read(texton, 0, NULL), "weft_model_part_read", "image");
    REFUSED(weft_model_part_read(texton, info.parts, &image), "weft_model_part_read", "index");
    for (int i = 0; i < 6; ++i) {
        weft_image wrong = good;
        const char *word = "";
        switch (i) {
        case 0: wrong.width -= 1, word = "7 x 8"; break;
        case 1: wrong.height -= 1, word = "8 x 7"; break;
        case 2: wrong.channels = 2, word = "channels"; break;
        case 3: wrong.format = WEFT_FORMAT_U16, word = "format"; break;
        case 4: wrong.data = NULL, word = "data"; break;
        default: wrong.stride = 4, word = "stride"; break;
        }
        REFUSED(weft_model_part_read(texton, 0, &wrong), "weft_model_part_read", word);
    }
    assert_true(all_bytes(&good, 0xa5));
    free_image(&image);
}

static void textures(void **state)
{
    (void)state;
    weft_texture *texture;
    const char *function = "weft_texture_create";
    const weft_status argument = WEFT_ERROR_ARGUMENT;
    REFUSED_HANDLE(weft_texture_create(NULL, texton, NULL, &texture), texture, argument, function, "context");
    REFUSED_HANDLE(weft_texture_create(context, NULL, NULL, &texture), texture, argument, function, "model");
    REFUSED(weft_texture_create(context, texton, NULL, NULL), function, "texture");
    const weft_texture_options fresh = WEFT_TEXTURE_OPTIONS_INIT;
    for (int i = 0; i < 14; ++i) {
        weft_texture_options options = fresh;
        const weft_model *model = i >= 12 ? picture : texton;
        const char *word = "";
        switch (i) {
        case 0: options.size = 0, word = "size"; break;
        case 1: options.size = 3, word = "size"; break;
        case 2: options.impacts = NAN, word = "impacts"; break;
        case 3: options.impacts = INFINITY, word = "impacts"; break;
        case 4: options.impacts = -INFINITY, word = "impacts"; break;
        case 5: options.impacts = -1, word = "impacts"; break;
        case 6: options.impacts = 0.999f, word = "impacts"; break;
        case 7: options.impacts = 1000.5f, word = "impacts"; break;
        case 8: options.impacts = FLT_MIN, word = "impacts"; break;
        case 9: options.period_x = (1u << 24) + 1, word = "period_x"; break;
        case 10: options.period_y = (1u << 24) + 1, word = "period_y"; break;
        case 11: options.period_y = UINT32_MAX, word = "period_y"; break;
        case 12: options.period_x = 13, word = "period_x"; break; /* the picture is 12 x 10 */
        default: options.period_y = 12, word = "period_y"; break;
        }
        REFUSED_HANDLE(weft_texture_create(context, model, &options, &texture), texture, argument, function, word);
    }
    weft_texture_free(NULL);
}

static void rendering(void **state)
{
    (void)state;
    const char *function = "weft_texture_render";
    weft_image image = new_image(32, 24, 3, WEFT_FORMAT_F32);
    fill_bytes(&image, 0xa5);
    REFUSED(weft_texture_render(NULL, 0, 0, 0, NULL, NULL, &image), function, "texture");
    REFUSED(weft_texture_render(noise, 0, 0, 0, NULL, NULL, NULL), function, "image");
    REFUSED(weft_texture_render(noise, 0, 0, 31, NULL, NULL, &image), function, "level");
    REFUSED(weft_texture_render(noise, 0, 0, UINT32_MAX, NULL, NULL, &image), function, "level");
    const int64_t edge = INT64_C(1) << 60,
                  far_off[] = {edge, edge - 1, -edge - 1, INT64_MAX, INT64_MIN, INT64_MAX - 16};
    for (size_t i = 0; i < sizeof far_off / sizeof *far_off; ++i) {
        REFUSED(weft_texture_render(noise, far_off[i], 0, 0, NULL, NULL, &image), function, "x");
        REFUSED(weft_texture_render(noise, 0, far_off[i], 0, NULL, NULL, &image), function, "y");
    }
    REFUSED(weft_texture_render(noise, edge >> 30, 0, 30, NULL, NULL, &image), function, "x");
    Bad_view bad[MOST_BAD_VIEWS];
    const uint32_t count = bad_views(&image, bad);
    for (uint32_t i = 0; i < count; ++i) {
        REFUSED(weft_texture_render(noise, 0, 0, 0, NULL, NULL, &bad[i].image), function, bad[i].word);
    }
    weft_image grey = image;
    grey.channels = 1;
    REFUSED(weft_texture_render(noise, 0, 0, 0, NULL, NULL, &grey), function, "channels");
    assert_true(all_bytes(&image, 0xa5));
    free_image(&image);
}

static void sampling(void **state)
{
    (void)state;
    const char *function = "weft_texture_sample";
    const weft_point origin = {0, 0, {0, 0}, {0, 0}};
    float out[3 * 3], before[3 * 3];
    memset(out, 0xa5, sizeof out);
    memcpy(before, out, sizeof out);
    REFUSED(weft_texture_sample(NULL, 1, &origin, out), function, "texture");
    REFUSED(weft_texture_sample(noise, 1, NULL, out), function, "points");
    REFUSED(weft_texture_sample(noise, 1, &origin, NULL), function, "out");
    const double far_off[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, 0x1p52, -0x1p52, DBL_MAX, -DBL_MAX};
    for (size_t i = 0; i < sizeof far_off / sizeof *far_off; ++i)
        for (int axis = 0; axis < 2; ++axis) {
            weft_point points[3] = {origin, origin, origin};
            *(axis ? &points[2].y : &points[2].x) = far_off[i];
            REFUSED(weft_texture_sample(noise, 3, points, out), function, "points[2]");
        }
    const float steep[] = {NAN, INFINITY, -INFINITY};
    for (size_t i = 0; i < sizeof steep / sizeof *steep; ++i)
        for (int k = 0; k < 4; ++k) {
            weft_point points[3] = {origin, origin, origin};
            (k < 2 ? points[2].dx : points[2].dy)[k % 2] = steep[i];
            REFUSED(weft_texture_sample(noise, 3, points, out), function, "points[2]");
        }
    assert_memory_equal(out, before, sizeof out);
    assert_ok(weft_texture_sample(noise, 0, NULL, NULL));
}

static void names_and_version(void **state)
{
    (void)state;
    static const char *const names[] = {
        "WEFT_OK",           "WEFT_ERROR_ARGUMENT",    "WEFT_ERROR_MEMORY", "WEFT_ERROR_CANCELLED",
        "WEFT_ERROR_FORMAT", "WEFT_ERROR_UNSUPPORTED", "WEFT_ERROR_DEVICE", "WEFT_ERROR_INTERNAL"};
    for (int i = 0; i < 8; ++i) assert_string_equal(weft_status_name(-i), names[i]);
    const weft_status unknown[] = {1, -8, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < sizeof unknown / sizeof *unknown; ++i) {
        assert_non_null(weft_status_name(unknown[i]));
        for (int k = 0; k < 8; ++k) assert_string_not_equal(weft_status_name(unknown[i]), names[k]);
    }
    assert_non_null(weft_error_message());
    assert_int_equal(weft_version(), WEFT_VERSION_MAJOR << 16 | WEFT_VERSION_MINOR << 8 | WEFT_VERSION_PATCH);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_and_version),
        cmocka_unit_test(devices),
        cmocka_unit_test(contexts),
        cmocka_unit_test(models),
        cmocka_unit_test(model_info_and_parts),
        cmocka_unit_test(textures),
        cmocka_unit_test(rendering),
        cmocka_unit_test(sampling),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
