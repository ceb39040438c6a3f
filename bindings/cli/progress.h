/* Progress of long work: a bar on a terminal, and cancellation by interrupt everywhere. */
#ifndef WEFT_CLI_PROGRESS_H
#define WEFT_CLI_PROGRESS_H

#include <stdint.h>

/* From now on SIGINT, SIGTERM and SIGHUP ask the work to stop; a second one ends the program at once. */
void progress_listen(void);

/* Whether one of those signals has come. */
int interrupted(void);

/* Shows a bar from now on, unless quiet or stderr is no terminal. */
void progress_begin(int quiet);

/* What is written behind the bar from the next step on. */
void progress_note(const char* text);

/* The part of the whole work, from `from` to `to` of 0..1, that one call to the library does. */
typedef struct progress_span {
    double from, to;
} progress_span;

/* A weft_progress whose user is a progress_span. */
int32_t progress_step(void* span, float done);

/* Removes the bar and its note, so that a line can be written in its place. */
void progress_clear(void);

#endif
