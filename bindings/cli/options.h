/* Command lines: each command describes its options in a table, from which they are parsed and its help is printed. */
#ifndef WEFT_CLI_OPTIONS_H
#define WEFT_CLI_OPTIONS_H

#include <stddef.h>
#include <stdint.h>

typedef enum option_kind {
    OPTION_FLAG,     /* int, set to 1 */
    OPTION_TEXT,     /* const char* */
    OPTION_COUNT,    /* uint32_t, low..high */
    OPTION_SEED,     /* uint64_t */
    OPTION_REAL,     /* float, low..high */
    OPTION_EXTENT,   /* extent, both low..high */
    OPTION_POSITION, /* position */
    OPTION_CHOICE    /* uint32_t, the index of one of the words of `shape`, which are set apart by | */
} option_kind;

typedef struct option {
    const char* name; /* "--size" */
    option_kind kind;
    void* value;
    const char* shape; /* of the value, in the help: "WxH" */
    const char* help;
    double low, high;
} option;

typedef struct command_line {
    const char* name;
    const char* operands; /* in the help: "PHOTO... -o MODEL" */
    const char* summary;
    const char* notes; /* paragraphs that follow the options in the help; may be NULL */
    const option* options;
    size_t option_count;
    int least, most; /* number of operands */
} command_line;

enum { MOST_OPERANDS = 16 };

/* What every command understands, and the operands. */
typedef struct arguments {
    const char* device; /* NULL: the default */
    uint32_t threads;   /* 0: all */
    int json, quiet;
    const char* operand[MOST_OPERANDS];
    int operands;
} arguments;

/* Fills the values. Answers -1 if the command is to go on, otherwise with the exit code: help or version were asked for
 * and are printed, or something is wrong and is said. */
int parse_arguments(const command_line* line, int count, char** words, arguments* result);

/* "weft 0.1.0" and the library's version. */
void print_version(void);

#endif
