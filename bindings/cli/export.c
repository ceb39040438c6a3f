/* weft export: a model's parts as files for people and other programs. */
#include "command.h"
#include "file.h"
#include "info.h"
#include "maps.h"
#include "open.h"
#include "options.h"
#include "report.h"
#include "wavelet_json.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static const char notes[] =
    "DIR gets a 16-bit PNG of every part, model.json, and of a texton with 1 or 3 channels texton.texton, the\n"
    "text format of texton noise's authors, or of wavelet noise wavelet.json, all its parameters, both of which\n"
    "`weft import` reads. A value of a part is low + (high -\n"
    "low) * pixel / 65535 with the low and high that model.json records. A part of more than 4 channels gives\n"
    "a grey PNG per channel.";

/* DIR/NAME; the caller frees it. */
static char* join(const char* folder, const char* name)
{
    size_t room = strlen(folder) + strlen(name) + 2;
    char* path = malloc(room);
    if (path) snprintf(path, room, "%s/%s", folder, name);
    return path;
}

static void scale(const float* values, uint16_t* pixels, size_t count, const weft_part_info* part)
{
    double range = (double)part->high - (double)part->low;
    double factor = range > 0 ? 65535 / range : 0;
    for (size_t i = 0; i < count; i++) pixels[i] = (uint16_t)lround(((double)values[i] - (double)part->low) * factor);
}

/* Names the file, or the files with %d for the channel, that a part goes to. */
static void name_files(const weft_part_info* part, char name[64])
{
    snprintf(name, 64, "%s%s.png", part->name, part->channels > 4 ? "-%d" : "");
    for (char* c = name; *c; c++)
        if (*c == ' ') *c = '-';
}

static int write_pixels(const char* folder, const weft_part_info* part, const weft_image* image)
{
    static const uint32_t singles[16] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    char name[64];
    map_files maps;
    int several = part->channels > 4;
    name_files(part, name);
    char* path = join(folder, name);
    if (!path) return failed("out of memory");
    int code = maps_open(&maps, path, several ? singles : &part->channels, several ? (int)part->channels : 1, image);
    if (code == EXIT_FINE) code = maps_rows(&maps, image);
    if (code == EXIT_FINE) code = maps_commit(&maps);
    maps_discard(&maps);
    free(path);
    return code;
}

static int write_part(const weft_model* model, uint32_t index, const char* folder)
{
    weft_part_info part = WEFT_PART_INFO_INIT;
    weft_status status = weft_model_part(model, index, &part);
    if (status != WEFT_OK) return failed_weft(status);
    size_t count = (size_t)part.width * part.height * part.channels;
    float* values = malloc(count * sizeof *values);
    uint16_t* pixels = malloc(count * sizeof *pixels);
    weft_image image = {values, 0, part.width, part.height, part.channels, WEFT_FORMAT_F32};
    int code = values && pixels ? EXIT_FINE : failed("out of memory");
    if (code == EXIT_FINE && (status = weft_model_part_read(model, index, &image)) != WEFT_OK)
        code = failed_weft(status);
    if (code == EXIT_FINE) {
        scale(values, pixels, count, &part);
        image.data = pixels;
        image.format = WEFT_FORMAT_U16;
        image.stride = (int64_t)(sizeof *pixels * part.width * part.channels);
        code = write_pixels(folder, &part, &image);
    }
    free(pixels);
    free(values);
    return code;
}

/* The authors' text where the model has one; *written says whether. */
static int write_text(const weft_model* model, const char* folder, int* written)
{
    size_t length = 0;
    weft_status status = weft_model_save_texton(model, NULL, 0, &length);
    *written = status == WEFT_OK;
    if (status == WEFT_ERROR_UNSUPPORTED) return EXIT_FINE;
    if (status != WEFT_OK) return failed_weft(status);
    char* text = malloc(length);
    char* path = join(folder, "texton.texton");
    int code = text && path ? EXIT_FINE : failed("out of memory");
    if (code == EXIT_FINE && (status = weft_model_save_texton(model, text, length, &length)) != WEFT_OK)
        code = failed_weft(status);
    if (code == EXIT_FINE) code = write_file(path, text, length);
    free(path);
    free(text);
    return code;
}

static int describe(json* out, const weft_model* model, const weft_model_info* info, int text)
{
    json_object(out, NULL);
    json_model(out, info);
    if (text)
        json_text(out, "text", "texton.texton");
    else if (info->method == WEFT_METHOD_WAVELET)
        json_text(out, "text", "wavelet.json");
    else
        json_null(out, "text");
    json_array(out, "parts");
    for (uint32_t i = 0; i < info->parts; i++) {
        weft_part_info part = WEFT_PART_INFO_INIT;
        char name[64];
        weft_status status = weft_model_part(model, i, &part);
        if (status != WEFT_OK) return failed_weft(status);
        json_object(out, NULL);
        json_part(out, &part);
        name_files(&part, name);
        json_text(out, "file", name);
        json_end(out);
    }
    json_end(out);
    json_end(out);
    return EXIT_FINE;
}

static int write_description(const weft_model* model, const weft_model_info* info, const char* folder, int text)
{
    output_file file;
    char* path = join(folder, "model.json");
    if (!path) return failed("out of memory");
    int code = output_open(&file, path);
    if (code == EXIT_FINE) {
        json out = json_begin(file.file);
        code = describe(&out, model, info, text);
        if (code == EXIT_FINE) code = output_commit(&file);
        output_discard(&file);
    }
    free(path);
    return code;
}

static int write_wavelet(const weft_model* model, const char* folder)
{
    weft_wavelet wavelet;
    output_file file;
    char* path = join(folder, "wavelet.json");
    int code = path ? get_wavelet(model, &wavelet) : failed("out of memory");
    if (code == EXIT_FINE) code = output_open(&file, path);
    if (code == EXIT_FINE) {
        json out = json_begin(file.file);
        json_wavelet(&out, NULL, &wavelet);
        code = output_commit(&file);
    }
    free(path);
    return code;
}

static int write_all(const weft_model* model, const weft_model_info* info, const char* folder, int as_json)
{
    int text = 0;
    int code = mkdir(folder, 0777) == 0 || errno == EEXIST ? EXIT_FINE : failed("%s: %s", folder, strerror(errno));
    for (uint32_t i = 0; i < info->parts && code == EXIT_FINE; i++) code = write_part(model, i, folder);
    if (code == EXIT_FINE) code = write_text(model, folder, &text);
    if (code == EXIT_FINE && info->method == WEFT_METHOD_WAVELET) code = write_wavelet(model, folder);
    if (code == EXIT_FINE) code = write_description(model, info, folder, text);
    if (code == EXIT_FINE && as_json) {
        json out = json_begin(stdout);
        code = describe(&out, model, info, text);
    }
    return code;
}

int command_export(int count, char** words)
{
    const command_line line = {
        "export", "MODEL DIR", "Writes a model's parts as PNG, text and JSON.", notes, NULL, 0, 2, 2};
    arguments common;
    weft_context* context = NULL;
    weft_model* model = NULL;
    weft_model_info info;
    int code = parse_arguments(&line, count, words, &common);
    if (code >= 0) return code;
    code = open_context(&common, &context);
    if (code == EXIT_FINE) code = open_model(context, common.operand[0], &model, &info);
    if (code == EXIT_FINE) code = write_all(model, &info, common.operand[1], common.json);
    weft_model_free(model);
    weft_context_free(context);
    return code;
}
