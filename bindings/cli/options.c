/* The parser of command lines and the printer of their help. */
#include "options.h"
#include "command.h"
#include "numbers.h"
#include "report.h"

#include <stdio.h>
#include <string.h>
#include <weft/weft.h>

typedef struct common_options {
    option table[6];
    int help, version;
} common_options;

static void describe_common(common_options* common, arguments* result)
{
    const option table[6] = {
        {"--device", OPTION_TEXT, &result->device, "NAME", "device to work on, as `weft devices` lists them", 0, 0},
        {"--threads", OPTION_COUNT, &result->threads, "N", "threads of this program; default one per CPU", 1, 1024},
        {"--json", OPTION_FLAG, &result->json, NULL, "print results as JSON", 0, 0},
        {"--quiet", OPTION_FLAG, &result->quiet, NULL, "no progress bar and no remarks", 0, 0},
        {"--help", OPTION_FLAG, &common->help, NULL, "this text", 0, 0},
        {"--version", OPTION_FLAG, &common->version, NULL, "versions of the program and of the library", 0, 0},
    };
    memcpy(common->table, table, sizeof table);
    common->help = common->version = 0;
}

void print_version(void)
{
    uint32_t library = weft_version();
    printf("weft %d.%d.%d, libweft %u.%u.%u\n", WEFT_VERSION_MAJOR, WEFT_VERSION_MINOR, WEFT_VERSION_PATCH,
           library >> 16, library >> 8 & 255, library & 255);
}

static void print_options(const option* options, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        char left[48];
        const char* shape = options[i].shape;
        snprintf(left, sizeof left, "%s%s%s", options[i].name, shape ? " " : "", shape ? shape : "");
        printf("  %-28s %s\n", left, options[i].help);
    }
}

static void print_help(const command_line* line, const common_options* common)
{
    printf("usage: weft %s %s%s[options]\n%s\n\n", line->name, line->operands, *line->operands ? " " : "",
           line->summary);
    print_options(line->options, line->option_count);
    print_options(common->table, sizeof common->table / sizeof common->table[0]);
    if (line->notes) printf("\n%s\n", line->notes);
    puts("\nexit codes: 0 fine, 1 the work failed, 2 wrong usage, 3 cancelled");
}

/* The index of `word` among the words of "a|b|c", or -1. */
static int find_choice(const char* choices, const char* word)
{
    size_t length = strlen(word);
    for (int index = 0;; index++) {
        size_t here = strcspn(choices, "|");
        if (here == length && memcmp(choices, word, here) == 0) return index;
        if (choices[here] == '\0') return -1;
        choices += here + 1;
    }
}

static int within(const option* o, double value) { return value >= o->low && value <= o->high; }

/* Stores the value that `text` gives `o`; 0 if it is none. */
static int store(const option* o, const char* text)
{
    uint64_t whole = 0;
    double real = 0;
    int choice = 0;
    switch (o->kind) {
    case OPTION_FLAG:
        *(int*)o->value = 1;
        return 1;
    case OPTION_TEXT:
        *(const char**)o->value = text;
        return *text != '\0';
    case OPTION_SEED:
        return parse_unsigned(text, o->value);
    case OPTION_POSITION:
        return parse_position(text, o->value);
    case OPTION_COUNT:
        if (!parse_unsigned(text, &whole) || !within(o, (double)whole)) return 0;
        *(uint32_t*)o->value = (uint32_t)whole;
        return 1;
    case OPTION_REAL:
        if (!parse_real(text, &real) || !within(o, real)) return 0;
        *(float*)o->value = (float)real;
        return 1;
    case OPTION_EXTENT:
        return parse_extent(text, o->value) && within(o, ((extent*)o->value)->width) &&
               within(o, ((extent*)o->value)->height);
    case OPTION_CHOICE:
        if ((choice = find_choice(o->shape, text)) < 0) return 0;
        *(uint32_t*)o->value = (uint32_t)choice;
        return 1;
    }
    return 0;
}

static int refuse_value(const option* o, const char* text)
{
    if (o->kind == OPTION_COUNT || o->kind == OPTION_REAL || o->kind == OPTION_EXTENT)
        return misused("%s takes %s from %g to %g, not '%s'", o->name, o->shape, o->low, o->high, text);
    return misused("%s takes %s, not '%s'", o->name, o->shape, text);
}

static const option* find(const option* options, size_t count, const char* word, size_t length)
{
    for (size_t i = 0; i < count; i++)
        if (strlen(options[i].name) == length && memcmp(options[i].name, word, length) == 0) return &options[i];
    return NULL;
}

/* Takes the option at words[*i], and the next word if that is its value. */
static int take_option(const command_line* line, const common_options* common, int count, char** words, int* i)
{
    const char* word = words[*i];
    size_t length = strcspn(word, "=");
    const option* o = find(line->options, line->option_count, word, length);
    if (!o) o = find(common->table, sizeof common->table / sizeof common->table[0], word, length);
    if (!o) return misused("there is no option %s", word);
    const char* text = word[length] == '=' ? word + length + 1 : NULL;
    if (o->kind == OPTION_FLAG && text) return misused("%s takes no value", o->name);
    if (o->kind != OPTION_FLAG && !text) {
        if (*i + 1 >= count) return misused("%s needs a value, %s", o->name, o->shape);
        text = words[++*i];
    }
    return store(o, text) ? -1 : refuse_value(o, text);
}

int parse_arguments(const command_line* line, int count, char** words, arguments* result)
{
    common_options common;
    int options_end = 0;
    memset(result, 0, sizeof *result);
    describe_common(&common, result);
    for (int i = 0; i < count; i++) {
        if (!options_end && strcmp(words[i], "--") == 0) {
            options_end = 1;
        } else if (options_end || words[i][0] != '-' || words[i][1] == '\0') {
            if (result->operands == line->most) return misused("'%s' is one operand too many", words[i]);
            result->operand[result->operands++] = words[i];
        } else {
            int answer = take_option(line, &common, count, words, &i);
            if (answer >= 0) return answer;
        }
    }
    if (common.help) print_help(line, &common);
    if (common.version && !common.help) print_version();
    if (common.help || common.version) return EXIT_FINE;
    if (result->operands < line->least) return misused("it takes %s", line->operands);
    return -1;
}
