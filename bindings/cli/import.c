/* weft import: the .texton text of texton noise's authors, or the JSON of wavelet noise -> model. */
#include "command.h"
#include "file.h"
#include "json.h"
#include "open.h"
#include "options.h"
#include "report.h"
#include "wavelet_json.h"

#include <stdlib.h>
#include <string.h>

static void report(const weft_model_info* info, const char* output, const arguments* common)
{
    if (common->json) {
        json out = json_begin(stdout);
        json_object(&out, NULL);
        json_text(&out, "model", output);
        json_text(&out, "method", method_name(info->method));
        json_unsigned(&out, "channels", info->channels);
        json_unsigned(&out, "width", info->width);
        json_unsigned(&out, "height", info->height);
        json_unsigned(&out, "bytes", info->bytes);
        json_end(&out);
    } else if (!common->quiet && strcmp(output, "-") != 0) {
        char size[MODEL_SIZE_ROOM];
        printf("%s: %s%s, channels %u\n", output, method_name(info->method), model_size(info, size), info->channels);
    }
}

/* A JSON object by its name or by how it begins; a .texton begins with a number. */
static int is_json(const char* path, const char* text, size_t size)
{
    size_t length = strlen(path), i = 0;
    if (length > 5 && strcmp(path + length - 5, ".json") == 0) return 1;
    while (i < size && (text[i] == ' ' || text[i] == '\t' || text[i] == '\r' || text[i] == '\n')) i++;
    return i < size && text[i] == '{';
}

static int make(weft_context* context, const char* path, const char* text, size_t size, weft_model** model)
{
    weft_wavelet wavelet;
    weft_status status = WEFT_OK;
    if (is_json(path, text, size)) {
        int code = read_wavelet(path, text, size, &wavelet);
        if (code != EXIT_FINE) return code;
        status = weft_model_from_wavelet(context, &wavelet, model);
    } else {
        status = weft_model_load_texton(context, text, size, model);
    }
    return status == WEFT_OK ? EXIT_FINE : failed("%s: %s", path, weft_error_message());
}

static int load(weft_context* context, const char* path, weft_model** model)
{
    char* text = NULL;
    size_t size = 0;
    int code = read_file(path, &text, &size);
    if (code != EXIT_FINE) return code;
    code = make(context, path, text, size, model);
    free(text);
    return code;
}

int command_import(int count, char** words)
{
    const char* output = NULL;
    const option table[] = {{"-o", OPTION_TEXT, &output, "MODEL", "where the model goes", 0, 0}};
    static const char notes[] =
        "A .texton is the text of texton noise's authors. A .json holds the parameters of wavelet noise as `weft\n"
        "export` writes them: \"method\": \"wavelet\", \"mean\" by channel, \"axes\" a row of channels for every\n"
        "principal axis, \"weights\" a row of bands, finest first, for every axis, and \"tone\" the curves' knots\n"
        "\"x\", \"y\", \"slope\" for every axis, or [] for none. It can be edited or written without any photo.";
    const command_line line = {
        "import", "FILE -o MODEL", "Makes a model of a .texton or .json file.", notes, table, 1, 1, 1};
    arguments common;
    weft_context* context = NULL;
    weft_model* model = NULL;
    weft_model_info info = WEFT_MODEL_INFO_INIT;
    int code = parse_arguments(&line, count, words, &common);
    if (code >= 0) return code;
    if (!output) return misused("it needs -o MODEL");
    if (check_stdout(common.json, output)) return EXIT_USAGE;
    code = open_context(&common, &context);
    if (code == EXIT_FINE) code = load(context, common.operand[0], &model);
    if (code == EXIT_FINE) code = save_model(model, output);
    if (code == EXIT_FINE && weft_model_get(model, &info) == WEFT_OK) report(&info, output, &common);
    weft_model_free(model);
    weft_context_free(context);
    return code;
}
