/* weft info: what a model holds. */
#include "info.h"
#include "command.h"
#include "open.h"
#include "options.h"
#include "report.h"
#include "wavelet_json.h"

#include <string.h>

static void json_values(json* out, const char* key, const float* values, uint32_t count)
{
    json_array(out, key);
    for (uint32_t i = 0; i < count; i++) json_real(out, NULL, (double)values[i]);
    json_end(out);
}

void json_model(json* out, const weft_model_info* info)
{
    int order = interpolation_order(info->interpolation);
    json_text(out, "method", method_name(info->method));
    json_unsigned(out, "channels", info->channels);
    json_unsigned(out, "width", info->width);
    json_unsigned(out, "height", info->height);
    if (order < 0)
        json_null(out, "interpolation");
    else
        json_integer(out, "interpolation", order);
    if (info->model_error < 0)
        json_null(out, "model_error");
    else
        json_real(out, "model_error", (double)info->model_error);
    json_values(out, "mean", info->mean, info->channels);
    json_values(out, "deviation", info->deviation, info->channels);
    json_unsigned(out, "bytes", info->bytes);
}

void json_part(json* out, const weft_part_info* part)
{
    json_text(out, "name", part->name);
    json_unsigned(out, "width", part->width);
    json_unsigned(out, "height", part->height);
    json_unsigned(out, "channels", part->channels);
    json_real(out, "low", (double)part->low);
    json_real(out, "high", (double)part->high);
}

static int write_json(const weft_model* model, const weft_model_info* info)
{
    json out = json_begin(stdout);
    weft_wavelet wavelet;
    if (info->method == WEFT_METHOD_WAVELET && get_wavelet(model, &wavelet) != EXIT_FINE) return EXIT_FAILED;
    json_object(&out, NULL);
    json_model(&out, info);
    if (info->method == WEFT_METHOD_WAVELET) json_wavelet(&out, "wavelet", &wavelet);
    json_array(&out, "parts");
    for (uint32_t i = 0; i < info->parts; i++) {
        weft_part_info part = WEFT_PART_INFO_INIT;
        weft_status status = weft_model_part(model, i, &part);
        if (status != WEFT_OK) return failed_weft(status);
        json_object(&out, NULL);
        json_part(&out, &part);
        json_end(&out);
    }
    json_end(&out);
    json_end(&out);
    return EXIT_FINE;
}

static void print_values(const char* name, const float* values, uint32_t count)
{
    printf("%-14s", name);
    for (uint32_t i = 0; i < count; i++) printf(" %.4f", (double)values[i]);
    putchar('\n');
}

static int print_wavelet(const weft_model* model)
{
    weft_wavelet wavelet;
    if (get_wavelet(model, &wavelet) != EXIT_FINE) return EXIT_FAILED;
    printf("%-14s %u\n", "bands", wavelet.bands);
    if (wavelet.knots > 0)
        printf("%-14s %u\n", "tone knots", wavelet.knots);
    else
        printf("%-14s none\n", "tone knots");
    for (uint32_t p = 0; p < wavelet.channels; p++) {
        float weights[16];
        char name[16];
        for (uint32_t b = 0; b < wavelet.bands; b++) weights[b] = wavelet.weight[b][p];
        snprintf(name, sizeof name, "axis %u", p + 1);
        print_values(name, wavelet.axes[p], wavelet.channels);
        print_values("  weights", weights, wavelet.bands);
    }
    return EXIT_FINE;
}

static int write_text(const weft_model* model, const weft_model_info* info)
{
    int order = interpolation_order(info->interpolation);
    printf("%-14s %s\n", "method", method_name(info->method));
    if (info->width > 0) printf("%-14s %u x %u\n", "size", info->width, info->height);
    printf("%-14s %u\n", "channels", info->channels);
    if (order >= 0) printf("%-14s %d\n", "interpolation", order);
    if (info->model_error >= 0) printf("%-14s %.4f, 0 is best\n", "model error", (double)info->model_error);
    print_values("mean", info->mean, info->channels);
    print_values("deviation", info->deviation, info->channels);
    printf("%-14s %llu\n", "bytes", (unsigned long long)info->bytes);
    if (info->method == WEFT_METHOD_WAVELET && print_wavelet(model) != EXIT_FINE) return EXIT_FAILED;
    for (uint32_t i = 0; i < info->parts; i++) {
        weft_part_info part = WEFT_PART_INFO_INIT;
        weft_status status = weft_model_part(model, i, &part);
        if (status != WEFT_OK) return failed_weft(status);
        printf("%-14s %s, %u x %u, channels %u, %g .. %g\n", "part", part.name, part.width, part.height, part.channels,
               (double)part.low, (double)part.high);
    }
    return EXIT_FINE;
}

int command_info(int count, char** words)
{
    static const char notes[] =
        "The model error is the relative model error against the periodogram of the photo (Xia et al. 2014). A\n"
        "smooth spectrum cannot come below about 0.48 against a raw periodogram unless the texton is nearly as\n"
        "large as the photo. The weights of wavelet noise are of its bands, finest first; `weft export` writes all\n"
        "its parameters.";
    const command_line line = {"info", "MODEL", "Says what a model holds.", notes, NULL, 0, 1, 1};
    arguments common;
    weft_context* context = NULL;
    weft_model* model = NULL;
    weft_model_info info;
    int code = parse_arguments(&line, count, words, &common);
    if (code >= 0) return code;
    code = open_context(&common, &context);
    if (code == EXIT_FINE) code = open_model(context, common.operand[0], &model, &info);
    if (code == EXIT_FINE) code = common.json ? write_json(model, &info) : write_text(model, &info);
    weft_model_free(model);
    weft_context_free(context);
    return code;
}
