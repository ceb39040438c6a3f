/* weft mix: two models -> one between them, or one that goes from one to the other. */
#include "command.h"
#include "file.h"
#include "json.h"
#include "open.h"
#include "options.h"
#include "report.h"

#include <string.h>

static const char notes[] =
    "Both models are of one method and have as many channels. Of wavelet noise --t makes the model that lies T\n"
    "of the way from A to B: 0 is A, 1 is B. Of texton noise --steps makes a model of N textons from A to B,\n"
    "of which `weft render --mix MAP.png` shows each where the map says.";

typedef struct mix_options {
    const char* output;
    float t;        /* below 0: not given */
    uint32_t steps; /* 0: not given */
} mix_options;

static int parse(mix_options* o, arguments* common, int count, char** words)
{
    const option table[] = {
        {"-o", OPTION_TEXT, &o->output, "MODEL", "where the model goes", 0, 0},
        {"--t", OPTION_REAL, &o->t, "T", "of wavelet noise: how far from A to B", 0, 1},
        {"--steps", OPTION_COUNT, &o->steps, "N", "of texton noise: how many textons from A to B", 2, 255},
    };
    const command_line line = {
        "mix", "A B -o MODEL", "Makes a model between two models.", notes, table, sizeof table / sizeof table[0], 2, 2};
    const mix_options none = {NULL, -1, 0};
    *o = none;
    int code = parse_arguments(&line, count, words, common);
    if (code >= 0) return code;
    if (!o->output) return misused("it needs -o MODEL");
    if ((o->t >= 0) == (o->steps > 0)) return misused("it needs either --t T or --steps N");
    return check_stdout(common->json, o->output) ? EXIT_USAGE : -1;
}

/* What was asked for is what the method of both can do. */
static int check_methods(const mix_options* o, weft_method method, weft_method other)
{
    if (method != other) return failed("A is a model of %s, B of %s", method_name(method), method_name(other));
    if (method == WEFT_METHOD_WAVELET && o->t < 0) return misused("models of wavelet noise take --t T");
    if (method == WEFT_METHOD_TEXTON && o->steps == 0) return misused("models of texton noise take --steps N");
    return EXIT_FINE;
}

static void report(const weft_model_info* info, const mix_options* o, const arguments* common)
{
    char size[MODEL_SIZE_ROOM];
    if (common->json) {
        json out = json_begin(stdout);
        json_object(&out, NULL);
        json_text(&out, "model", o->output);
        json_text(&out, "method", method_name(info->method));
        json_unsigned(&out, "channels", info->channels);
        json_unsigned(&out, "parts", info->parts);
        json_unsigned(&out, "bytes", info->bytes);
        json_end(&out);
    } else if (!common->quiet && strcmp(o->output, "-") != 0) {
        printf("%s: %s%s, channels %u", o->output, method_name(info->method), model_size(info, size), info->channels);
        if (o->steps > 0) printf(", %u steps", o->steps);
        putchar('\n');
    }
}

static int mix(const mix_options* o, const arguments* common, weft_context* context)
{
    weft_model *models[2] = {NULL, NULL}, *mixed = NULL;
    weft_model_info info = WEFT_MODEL_INFO_INIT, other = info;
    int code = open_model(context, common->operand[0], &models[0], &info);
    if (code == EXIT_FINE) code = open_model(context, common->operand[1], &models[1], &other);
    if (code == EXIT_FINE) code = check_methods(o, info.method, other.method);
    if (code == EXIT_FINE) {
        weft_status status = weft_model_mix(context, models[0], models[1], o->t < 0 ? 0 : o->t, o->steps, &mixed);
        if (status != WEFT_OK) code = failed_weft(status);
    }
    if (code == EXIT_FINE) code = save_model(mixed, o->output);
    if (code == EXIT_FINE && weft_model_get(mixed, &info) == WEFT_OK) report(&info, o, common);
    weft_model_free(mixed);
    weft_model_free(models[1]);
    weft_model_free(models[0]);
    return code;
}

int command_mix(int count, char** words)
{
    mix_options o;
    arguments common;
    weft_context* context = NULL;
    int code = parse(&o, &common, count, words);
    if (code >= 0) return code;
    code = open_context(&common, &context);
    if (code == EXIT_FINE) code = mix(&o, &common, context);
    weft_context_free(context);
    return code;
}
