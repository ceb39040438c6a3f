/* JSON as RFC 8259 has it. */
#include "json.h"

#include <inttypes.h>
#include <math.h>

json json_begin(FILE* file)
{
    json out = {file, 0, {0}, {0}};
    return out;
}

/* Length of the well-formed UTF-8 sequence at `text`, 0 if there is none. */
static int sequence_length(const unsigned char* text)
{
    static const unsigned least[5] = {0, 0, 0x80, 0x800, 0x10000};
    int length = text[0] < 0x80 ? 1 : text[0] >> 5 == 6 ? 2 : text[0] >> 4 == 14 ? 3 : text[0] >> 3 == 30 ? 4 : 0;
    if (length < 2) return length;
    unsigned code = text[0] & (0xffu >> (length + 1));
    for (int i = 1; i < length; i++) {
        if ((text[i] & 0xc0) != 0x80) return 0;
        code = code << 6 | (text[i] & 0x3fu);
    }
    return code < least[length] || code > 0x10ffff || code >> 11 == 0x1b ? 0 : length;
}

static void put_text(json* out, const char* value)
{
    const unsigned char* text = (const unsigned char*)value;
    fputc('"', out->file);
    while (*text) {
        int length = sequence_length(text);
        if (length == 0)
            fputs("\\ufffd", out->file);
        else if (*text == '"' || *text == '\\')
            fprintf(out->file, "\\%c", *text);
        else if (*text < 0x20)
            fprintf(out->file, "\\u%04x", *text);
        else
            fwrite(text, 1, (size_t)length, out->file);
        text += length ? length : 1;
    }
    fputc('"', out->file);
}

/* What stands before a value: comma, line, indentation, key. */
static void lead(json* out, const char* key)
{
    if (out->depth > 0) {
        fputs(out->count[out->depth - 1]++ ? ",\n" : "\n", out->file);
        fprintf(out->file, "%*s", 2 * out->depth, "");
    }
    if (key) {
        put_text(out, key);
        fputs(": ", out->file);
    }
}

static void open_level(json* out, const char* key, char open, char close)
{
    lead(out, key);
    fputc(open, out->file);
    out->close[out->depth] = close;
    out->count[out->depth++] = 0;
}

void json_object(json* out, const char* key) { open_level(out, key, '{', '}'); }

void json_array(json* out, const char* key) { open_level(out, key, '[', ']'); }

void json_end(json* out)
{
    out->depth--;
    if (out->count[out->depth]) fprintf(out->file, "\n%*s", 2 * out->depth, "");
    fputc(out->close[out->depth], out->file);
    if (out->depth == 0) fputc('\n', out->file);
}

void json_text(json* out, const char* key, const char* value)
{
    lead(out, key);
    put_text(out, value);
}

void json_integer(json* out, const char* key, int64_t value)
{
    lead(out, key);
    fprintf(out->file, "%" PRId64, value);
}

void json_unsigned(json* out, const char* key, uint64_t value)
{
    lead(out, key);
    fprintf(out->file, "%" PRIu64, value);
}

void json_real(json* out, const char* key, double value)
{
    lead(out, key);
    if (isfinite(value))
        fprintf(out->file, "%.9g", value);
    else
        fputs("null", out->file);
}

void json_truth(json* out, const char* key, int value)
{
    lead(out, key);
    fputs(value ? "true" : "false", out->file);
}

void json_null(json* out, const char* key)
{
    lead(out, key);
    fputs("null", out->file);
}
