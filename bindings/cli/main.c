/* The program `weft`: chooses the command. */
#include "command.h"
#include "options.h"
#include "progress.h"
#include "report.h"

#include <stdio.h>
#include <string.h>

typedef struct command {
    const char* name;
    int (*run)(int count, char** words);
    const char* summary;
} command;

static const command commands[] = {
    {"analyze", command_analyze, "learn a model from a photo"},
    {"render", command_render, "make pixels of a model's texture"},
    {"info", command_info, "say what a model holds"},
    {"export", command_export, "write a model's parts as PNG, text and JSON"},
    {"import", command_import, "make a model of a .texton or .json file"},
    {"describe", command_describe, "say what a photo is like and which method suits it"},
    {"tile", command_tile, "make a tile that repeats unseen of a photo"},
    {"preview", command_preview, "draw how a photo splits into structure and noise"},
    {"apply", command_apply, "make the tile of another map of a tiled surface"},
    {"mix", command_mix, "make a model between two models"},
    {"sheet", command_sheet, "draw a model, its texture and how close this is to the photo"},
    {"compare", command_compare, "measure how close an output is to its exemplar"},
    {"devices", command_devices, "list the devices"},
    {"bench", command_bench, "measure speed beside the machine's limits"},
};
enum { COMMAND_COUNT = sizeof commands / sizeof commands[0] };

static void print_usage(FILE* file)
{
    fputs("usage: weft COMMAND ...\n"
          "Textures by example: a photo becomes a model, a model an endless texture.\n\n",
          file);
    for (size_t i = 0; i < COMMAND_COUNT; i++) fprintf(file, "  %-10s %s\n", commands[i].name, commands[i].summary);
    fputs("\n`weft COMMAND --help` says more, `weft --version` which version this is.\n"
          "A file named - is standard input or output.\n"
          "exit codes: 0 fine, 1 the work failed, 2 wrong usage, 3 cancelled\n",
          file);
}

static const command* find_command(const char* name)
{
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        if (strcmp(commands[i].name, name) == 0) return &commands[i];
    return NULL;
}

static int run(int count, char** words)
{
    if (count < 2) {
        print_usage(stderr);
        return EXIT_USAGE;
    }
    if (strcmp(words[1], "--help") == 0 || strcmp(words[1], "help") == 0) {
        print_usage(stdout);
        return EXIT_FINE;
    }
    if (strcmp(words[1], "--version") == 0) {
        print_version();
        return EXIT_FINE;
    }
    const command* chosen = find_command(words[1]);
    if (!chosen) return misused("there is no command %s", words[1]);
    report_command(chosen->name);
    return chosen->run(count - 2, words + 2);
}

int main(int count, char** words)
{
    progress_listen();
    int code = run(count, words);
    progress_clear();
    int bad = ferror(stdout) | fflush(stdout);
    return code == EXIT_FINE && bad ? failed("standard output could not be written") : code;
}
