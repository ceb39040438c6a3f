/* One-line errors. */
#include "report.h"
#include "command.h"
#include "progress.h"

#include <stdarg.h>
#include <stdio.h>

static const char* command_name = NULL;

void report_command(const char* name) { command_name = name; }

static void say(const char* format, va_list values)
{
    progress_clear();
    fputs(command_name ? "weft " : "weft", stderr);
    fputs(command_name ? command_name : "", stderr);
    fputs(": ", stderr);
    vfprintf(stderr, format, values);
}

int failed(const char* format, ...)
{
    va_list values;
    va_start(values, format);
    if (interrupted()) {
        say("cancelled\n", values);
    } else {
        say(format, values);
        fputc('\n', stderr);
    }
    va_end(values);
    return interrupted() ? EXIT_CANCELLED : EXIT_FAILED;
}

int failed_weft(weft_status status)
{
    if (status == WEFT_ERROR_CANCELLED) {
        failed("cancelled");
        return EXIT_CANCELLED;
    }
    return failed("%s", weft_error_message());
}

int misused(const char* format, ...)
{
    va_list values;
    va_start(values, format);
    say(format, values);
    va_end(values);
    fprintf(stderr, "; see weft %s%s--help\n", command_name ? command_name : "", command_name ? " " : "");
    return EXIT_USAGE;
}
