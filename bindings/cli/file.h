/* Whole files in, and output files that appear only when they are complete. "-" is standard input or output. */
#ifndef WEFT_CLI_FILE_H
#define WEFT_CLI_FILE_H

#include <stddef.h>
#include <stdio.h>

/* Opens a file for reading; NULL after having said why not. Close with input_close. */
FILE* input_open(const char* path);
void input_close(FILE* file);

/* Reads all of a file into memory that the caller frees. Answers with an exit code, having said what failed. */
int read_file(const char* path, char** bytes, size_t* size);

typedef struct output_file {
    FILE* file;
    char* target;    /* where the file is to be; NULL: written in place */
    char* temporary; /* where it is until output_commit */
    const char* path;
} output_file;

/* Opens a file for writing beside its place; what already lies there stays until output_commit. */
int output_open(output_file* out, const char* path);

/* Puts the complete file in its place. */
int output_commit(output_file* out);

/* Forgets the file, whatever was written. Does nothing after output_commit, or on zeros. */
void output_discard(output_file* out);

/* The three in one. */
int write_file(const char* path, const void* bytes, size_t size);

/* Says so and answers EXIT_USAGE if JSON and an output both want standard output. */
int check_stdout(int json, const char* path);

#endif
