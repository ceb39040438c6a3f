/* weft export: a model's parts as files for people and other programs. */
#include "bilayer_parts.h"
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
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static const char notes[] =
    "DIR gets a 16-bit PNG of every part, model.json, and of a texton with 1 or 3 channels texton.texton, the\n"
    "text format of texton noise's authors, or of wavelet noise wavelet.json, all its parameters, both of which\n"
    "`weft import` reads. A value of a part is low + (high -\n"
    "low) * pixel / 65535 with the low and high that model.json records. A part of more than 4 channels gives\n"
    "a grey PNG per channel. A bi-layer model gives also a power spectrum for each texton, log10 of its power with\n"
    "frequency 0 in the middle; its patches are told apart by colours, and contents.csv says in a line for each\n"
    "content which patch may show it, where its corner lies in the structure, its rotation and scale.";

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

static int is_table(const weft_part_info* part) { return strcmp(part->name, "contents") == 0; }

/* Names the file, or the files with %d for the channel, that a part goes to. */
static void name_files(const weft_part_info* part, char name[64])
{
    snprintf(name, 64, "%s%s.%s", part->name, part->channels > 4 ? "-%d" : "", is_table(part) ? "csv" : "png");
    for (char* c = name; *c; c++)
        if (*c == ' ') *c = '-';
}

/* DIR/NAME of a part; the caller frees it. */
static char* part_path(const char* folder, const weft_part_info* part)
{
    char name[64];
    name_files(part, name);
    return join(folder, name);
}

static int write_pixels(const char* folder, const weft_part_info* part, const weft_image* image)
{
    static const uint32_t singles[16] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    int several = image->channels > 4;
    char* path = part_path(folder, part);
    if (!path) return failed("out of memory");
    int code = maps_write(path, image, several ? singles : &image->channels, several ? (int)image->channels : 1);
    free(path);
    return code;
}

static int write_values(const char* folder, const weft_part_info* part, const weft_image* values)
{
    const size_t count = (size_t)part->width * part->height * part->channels;
    uint16_t* pixels = malloc(count * sizeof *pixels);
    const weft_image image = {pixels,         (int64_t)(sizeof *pixels * part->width * part->channels),
                              part->width,    part->height,
                              part->channels, WEFT_FORMAT_U16};
    if (!pixels) return failed("out of memory");
    scale(values->data, pixels, count, part);
    int code = write_pixels(folder, part, &image);
    free(pixels);
    return code;
}

static int write_spectrum(const char* folder, weft_part_info* part, const weft_image* texton)
{
    weft_image spectrum;
    int code = spectrum_of(texton, part, &spectrum);
    if (code == EXIT_FINE) code = write_values(folder, part, &spectrum);
    free(spectrum.data);
    return code;
}

static int write_patches(const char* folder, const weft_part_info* part, const weft_image* patches)
{
    weft_image colours;
    int code = colours_of(patches, &colours);
    colours.stride = (int64_t)3 * colours.width;
    if (code == EXIT_FINE) code = write_pixels(folder, part, &colours);
    free(colours.data);
    return code;
}

static int write_contents(const char* folder, const weft_part_info* part, const weft_image* contents)
{
    output_file file;
    char* path = part_path(folder, part);
    int code = path ? output_open(&file, path) : failed("out of memory");
    if (code == EXIT_FINE) {
        fputs("patch,x,y,degrees,scale\n", file.file);
        for (uint32_t i = 0; i < part->height; i++) {
            const float* row = (const float*)contents->data + (size_t)i * part->width;
            fprintf(file.file, "%.0f,%.0f,%.0f,%.0f,%.9g\n", (double)row[0], (double)row[1], (double)row[2],
                    (double)row[3], (double)row[4]);
        }
        code = output_commit(&file);
        output_discard(&file);
    }
    free(path);
    return code;
}

static int write_part(const weft_model* model, const weft_model_info* info, uint32_t index, const char* folder)
{
    weft_part_info part;
    weft_image values;
    int code = read_part(model, index, &part, &values);
    if (code == EXIT_FINE && is_table(&part))
        code = write_contents(folder, &part, &values);
    else if (code == EXIT_FINE && strcmp(part.name, "patches") == 0)
        code = write_patches(folder, &part, &values);
    else if (code == EXIT_FINE)
        code = write_values(folder, &part, &values);
    if (code == EXIT_FINE && has_spectrum(info, &part)) code = write_spectrum(folder, &part, &values);
    free(values.data);
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

static void describe_part(json* out, const weft_part_info* part)
{
    char name[64];
    json_object(out, NULL);
    json_part(out, part);
    name_files(part, name);
    json_text(out, "file", name);
    json_end(out);
}

static int describe_spectrum(json* out, const weft_model* model, uint32_t index)
{
    weft_part_info part;
    weft_image texton, spectrum = {NULL, 0, 0, 0, 0, 0};
    int code = read_part(model, index, &part, &texton);
    if (code == EXIT_FINE) code = spectrum_of(&texton, &part, &spectrum);
    if (code == EXIT_FINE) describe_part(out, &part);
    free(spectrum.data);
    free(texton.data);
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
        weft_status status = weft_model_part(model, i, &part);
        if (status != WEFT_OK) return failed_weft(status);
        describe_part(out, &part);
        if (has_spectrum(info, &part) && describe_spectrum(out, model, i) != EXIT_FINE) return EXIT_FAILED;
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
    for (uint32_t i = 0; i < info->parts && code == EXIT_FINE; i++) code = write_part(model, info, i, folder);
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
