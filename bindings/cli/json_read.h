/* A strict reader of JSON for files whose layout is known: the caller asks for what must come next, so that nothing is
 * deeper than the caller goes. Functions answer 0 after an error, and from then on; the first one is kept. */
#ifndef WEFT_CLI_JSON_READ_H
#define WEFT_CLI_JSON_READ_H

#include <stddef.h>

typedef struct json_reader {
    const char *at, *end;
    int fresh;     /* the object or array has had no value yet */
    unsigned line; /* from 1 on */
    char error[96];
} json_reader;

enum { JSON_KEY_ROOM = 24 };

json_reader json_read_begin(const char* text, size_t size);

/* Whether no error has been met. */
int json_read_fine(const json_reader* in);

/* Notes an error at the present line, as printf would, unless there is one; answers 0. */
int json_read_refuse(json_reader* in, const char* format, ...) __attribute__((format(printf, 2, 3)));

int json_read_open(json_reader* in, char bracket); /* { or [ */

/* Whether the open array has a further value, which must be read next; at its end it is closed. */
int json_read_value(json_reader* in);

/* Whether the open object has a further member, and its key: its value must be read next. At its end it is closed.
 * What is no printable ASCII is ? in a key. */
int json_read_member(json_reader* in, char key[JSON_KEY_ROOM]);

int json_read_text(json_reader* in, char* text, size_t room);

/* A number within float's range, nearest to what is written if that has up to 9 digits, as the digits of floats do. */
int json_read_float(json_reader* in, float* value);

/* Nothing but blanks may follow. */
int json_read_end(json_reader* in);

#endif
