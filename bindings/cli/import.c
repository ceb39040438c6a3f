/* weft import: the .texton text of texton noise's authors -> model. */
#include "command.h"
#include "file.h"
#include "json.h"
#include "open.h"
#include "options.h"
#include "report.h"

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
        printf("%s: texton of %u x %u, channels %u\n", output, info->width, info->height, info->channels);
    }
}

static int load(weft_context* context, const char* path, weft_model** model)
{
    char* text = NULL;
    size_t size = 0;
    int code = read_file(path, &text, &size);
    if (code != EXIT_FINE) return code;
    weft_status status = weft_model_load_texton(context, text, size, model);
    free(text);
    return status == WEFT_OK ? EXIT_FINE : failed("%s: %s", path, weft_error_message());
}

int command_import(int count, char** words)
{
    const char* output = NULL;
    const option table[] = {{"-o", OPTION_TEXT, &output, "MODEL", "where the model goes", 0, 0}};
    const command_line line = {"import", "FILE.texton -o MODEL", "Makes a model of a .texton file.", NULL, table, 1, 1,
                               1};
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
