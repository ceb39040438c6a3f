/* The commands of the program `weft` and what they answer. */
#ifndef WEFT_CLI_COMMAND_H
#define WEFT_CLI_COMMAND_H

enum {
    EXIT_FINE = 0,
    EXIT_FAILED = 1,   /* the work failed */
    EXIT_USAGE = 2,    /* the command line is wrong */
    EXIT_CANCELLED = 3 /* by an interrupt */
};

/* Each takes the words after its name and answers with one of the codes above. */
int command_analyze(int count, char** words);
int command_render(int count, char** words);
int command_info(int count, char** words);
int command_export(int count, char** words);
int command_import(int count, char** words);
int command_describe(int count, char** words);
int command_tile(int count, char** words);
int command_apply(int count, char** words);
int command_mix(int count, char** words);
int command_preview(int count, char** words);
int command_sheet(int count, char** words);
int command_compare(int count, char** words);
int command_devices(int count, char** words);
int command_bench(int count, char** words);

#endif
