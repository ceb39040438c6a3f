/* How the program speaks of failures: one line on stderr, and the exit code that goes with it. */
#ifndef WEFT_CLI_REPORT_H
#define WEFT_CLI_REPORT_H

#include <weft/weft.h>

/* The command that the lines name: "weft render: ...". */
void report_command(const char* name);

/* Says why the work failed, as printf would. Answers EXIT_FAILED, or EXIT_CANCELLED after an interrupt, when the
 * failure is only a consequence. */
int failed(const char* format, ...) __attribute__((format(printf, 1, 2)));

/* Says the library's sentence about the error it just returned. */
int failed_weft(weft_status status);

/* Says what is wrong with the command line and where to read on. Answers EXIT_USAGE. */
int misused(const char* format, ...) __attribute__((format(printf, 1, 2)));

#endif
