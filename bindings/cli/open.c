/* Contexts, photographs and models of the command line. */
#include "open.h"
#include "command.h"
#include "file.h"
#include "png.h"
#include "report.h"

#include <stdlib.h>
#include <string.h>

int open_context(const arguments* common, weft_context** context)
{
    weft_context_options options = WEFT_CONTEXT_OPTIONS_INIT;
    options.device = common->device;
    options.threads = common->threads;
    weft_status status = weft_context_create(&options, context);
    return status == WEFT_OK ? EXIT_FINE : failed_weft(status);
}

static int open_photo(const char* path, weft_image* image)
{
    pngfile_reason why;
    FILE* file = input_open(path);
    if (!file) return EXIT_FAILED;
    int bad = pngfile_read(file, image, &why);
    input_close(file);
    return bad ? failed("%s: %s", path, why.text) : EXIT_FINE;
}

static size_t value_bytes(const weft_image* image) { return image->format == WEFT_FORMAT_U16 ? 2 : 1; }

/* Copies one map into its channels of the stack; 8 bits become 16 without loss, v * 257. */
static void copy_channels(const weft_image* map, const weft_image* stack, uint32_t first)
{
    size_t from = value_bytes(map), to = value_bytes(stack);
    for (uint32_t y = 0; y < map->height; y++) {
        const unsigned char* source = (const unsigned char*)map->data + (size_t)map->stride * y;
        unsigned char* target = (unsigned char*)stack->data + (size_t)stack->stride * y + to * first;
        for (uint32_t x = 0; x < map->width; x++, target += to * stack->channels)
            for (uint32_t c = 0; c < map->channels; c++, source += from) {
                target[to * c] = source[0];
                if (to == 2) target[to * c + 1] = source[from - 1];
            }
    }
}

static int stack_photos(const weft_image* maps, int count, weft_image* stack)
{
    *stack = maps[0];
    for (int i = 1; i < count; i++) {
        stack->channels += maps[i].channels;
        if (maps[i].format == WEFT_FORMAT_U16) stack->format = WEFT_FORMAT_U16;
    }
    if (stack->channels > 16) return failed("the photos have %u channels together, the most is 16", stack->channels);
    stack->stride = (int64_t)(value_bytes(stack) * stack->channels * stack->width);
    stack->data = malloc((size_t)stack->stride * stack->height);
    if (!stack->data) return failed("out of memory");
    uint32_t first = 0;
    for (int i = 0; i < count; i++) {
        copy_channels(&maps[i], stack, first);
        first += maps[i].channels;
    }
    return EXIT_FINE;
}

static int open_each(const char* const* paths, int count, weft_image* maps)
{
    for (int i = 0; i < count; i++) {
        int code = open_photo(paths[i], &maps[i]);
        if (code != EXIT_FINE) return code;
        if (maps[i].width != maps[0].width || maps[i].height != maps[0].height)
            return failed("%s is %u x %u pixels, %s is %u x %u: maps of one surface have one size", paths[i],
                          maps[i].width, maps[i].height, paths[0], maps[0].width, maps[0].height);
    }
    return EXIT_FINE;
}

int open_maps(const char* const* paths, int count, weft_image* image, uint32_t* groups)
{
    weft_image maps[MOST_OPERANDS];
    memset(maps, 0, sizeof maps);
    int code = open_each(paths, count, maps);
    for (int i = 0; i < count; i++) groups[i] = maps[i].channels;
    if (count == 1) {
        *image = maps[0];
        return code;
    }
    if (code == EXIT_FINE) code = stack_photos(maps, count, image);
    for (int i = 0; i < count; i++) free(maps[i].data);
    return code;
}

int open_photos(const char* const* paths, int count, weft_image* image)
{
    uint32_t groups[MOST_OPERANDS];
    return open_maps(paths, count, image, groups);
}

int open_model(weft_context* context, const char* path, weft_model** model, weft_model_info* info)
{
    const weft_model_info start = WEFT_MODEL_INFO_INIT;
    char* bytes = NULL;
    size_t size = 0;
    int code = read_file(path, &bytes, &size);
    if (code != EXIT_FINE) return code;
    weft_status status = weft_model_load(context, bytes, size, model);
    free(bytes);
    if (status != WEFT_OK) return failed("%s: %s", path, weft_error_message());
    *info = start;
    status = weft_model_get(*model, info);
    if (status == WEFT_OK) return EXIT_FINE;
    weft_model_free(*model);
    *model = NULL;
    return failed_weft(status);
}

int save_model(const weft_model* model, const char* path)
{
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    weft_status status = weft_model_get(model, &info);
    if (status != WEFT_OK) return failed_weft(status);
    void* bytes = malloc((size_t)info.bytes);
    if (!bytes) return failed("out of memory");
    status = weft_model_save(model, bytes, (size_t)info.bytes);
    int code = status == WEFT_OK ? write_file(path, bytes, (size_t)info.bytes) : failed_weft(status);
    free(bytes);
    return code;
}

const char* method_name(weft_method method)
{
    switch (method) {
    case WEFT_METHOD_TEXTON:
        return "texton";
    case WEFT_METHOD_WAVELET:
        return "wavelet";
    case WEFT_METHOD_BILAYER:
        return "bilayer";
    case WEFT_METHOD_STATIONARY:
        return "stationary";
    case WEFT_METHOD_PICTURE:
        return "picture";
    default:
        return "unknown";
    }
}

const char* model_size(const weft_model_info* info, char text[MODEL_SIZE_ROOM])
{
    text[0] = '\0';
    if (info->width > 0) snprintf(text, MODEL_SIZE_ROOM, " of %u x %u", info->width, info->height);
    return text;
}

int interpolation_order(weft_interpolation interpolation)
{
    switch (interpolation) {
    case WEFT_INTERPOLATION_NEAREST:
        return 0;
    case WEFT_INTERPOLATION_LINEAR:
        return 1;
    case WEFT_INTERPOLATION_CUBIC:
        return 3;
    case WEFT_INTERPOLATION_QUINTIC:
        return 5;
    default:
        return -1;
    }
}
