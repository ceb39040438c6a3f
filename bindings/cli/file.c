/* Files: reading whole ones, and writing beside the target with a rename at the end. */
#include "file.h"
#include "command.h"
#include "report.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int is_standard(const char* path) { return strcmp(path, "-") == 0; }

FILE* input_open(const char* path)
{
    struct stat status;
    if (is_standard(path)) return stdin;
    if (stat(path, &status) == 0 && S_ISDIR(status.st_mode)) {
        failed("%s: is a directory", path);
        return NULL;
    }
    FILE* file = fopen(path, "rb");
    if (!file) failed("%s: %s", path, strerror(errno));
    return file;
}

void input_close(FILE* file)
{
    if (file && file != stdin) fclose(file);
}

static int read_all(FILE* file, const char* path, char** bytes, size_t* size)
{
    size_t room = 65536, used = 0;
    char* memory = malloc(room);
    while (memory) {
        used += fread(memory + used, 1, room - used, file);
        if (used < room) break;
        char* larger = room > SIZE_MAX / 2 ? NULL : realloc(memory, room * 2);
        if (!larger) free(memory);
        memory = larger;
        room *= 2;
    }
    if (!memory) return failed("%s: out of memory", path);
    if (ferror(file)) {
        free(memory);
        return failed("%s: %s", path, strerror(errno));
    }
    *bytes = memory;
    *size = used;
    return EXIT_FINE;
}

int read_file(const char* path, char** bytes, size_t* size)
{
    FILE* file = input_open(path);
    if (!file) return EXIT_FAILED;
    int code = read_all(file, path, bytes, size);
    input_close(file);
    return code;
}

/* Opens a temporary file beside out->target with the permissions that a new file would get. */
static int open_beside(output_file* out)
{
    size_t length = strlen(out->target) + sizeof ".XXXXXX";
    out->temporary = malloc(length);
    if (!out->temporary) return failed("%s: out of memory", out->path);
    snprintf(out->temporary, length, "%s.XXXXXX", out->target);
    int descriptor = mkstemp(out->temporary);
    if (descriptor < 0) {
        int code = failed("%s: %s", out->path, strerror(errno));
        free(out->temporary);
        out->temporary = NULL;
        return code;
    }
    mode_t mask = umask(0);
    umask(mask);
    struct stat status;
    mode_t mode = stat(out->target, &status) == 0 ? status.st_mode & 0777 : 0666 & ~mask;
    if (fchmod(descriptor, mode) != 0 || !(out->file = fdopen(descriptor, "wb"))) {
        close(descriptor);
        return failed("%s: %s", out->path, strerror(errno));
    }
    return EXIT_FINE;
}

static int open_output(output_file* out)
{
    struct stat status;
    int exists = stat(out->path, &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) return failed("%s: is a directory", out->path);
    if (exists && !S_ISREG(status.st_mode)) { /* a device or a pipe is written in place */
        out->file = fopen(out->path, "wb");
        return out->file ? EXIT_FINE : failed("%s: %s", out->path, strerror(errno));
    }
    if (exists && access(out->path, W_OK) != 0) return failed("%s: %s", out->path, strerror(errno));
    out->target = exists ? realpath(out->path, NULL) : strdup(out->path); /* a link stays a link */
    return out->target ? open_beside(out) : failed("%s: %s", out->path, strerror(errno));
}

int output_open(output_file* out, const char* path)
{
    memset(out, 0, sizeof *out);
    out->path = path;
    if (is_standard(path)) {
        if (isatty(STDOUT_FILENO)) return failed("standard output is a terminal");
        out->path = "standard output";
        out->file = stdout;
        return EXIT_FINE;
    }
    int code = open_output(out);
    if (code != EXIT_FINE) output_discard(out);
    return code;
}

int output_commit(output_file* out)
{
    int bad = ferror(out->file) | fflush(out->file);
    if (out->file != stdout) bad |= fclose(out->file);
    out->file = NULL;
    if (bad || (out->target && rename(out->temporary, out->target) != 0)) {
        int code = failed("%s: %s", out->path, strerror(errno));
        output_discard(out);
        return code;
    }
    free(out->temporary);
    out->temporary = NULL;
    output_discard(out);
    return EXIT_FINE;
}

void output_discard(output_file* out)
{
    if (out->file && out->file != stdout) fclose(out->file);
    if (out->temporary) unlink(out->temporary);
    free(out->temporary);
    free(out->target);
    memset(out, 0, sizeof *out);
}

int write_file(const char* path, const void* bytes, size_t size)
{
    output_file out;
    int code = output_open(&out, path);
    if (code != EXIT_FINE) return code;
    if (fwrite(bytes, 1, size, out.file) != size) {
        code = failed("%s: %s", out.path, strerror(errno));
        output_discard(&out);
        return code;
    }
    return output_commit(&out);
}

int check_stdout(int json, const char* path)
{
    return json && is_standard(path) ? misused("--json and '-' both want standard output") : EXIT_FINE;
}
