/* JSON as RFC 8259 has it, read without the locale. */
#include "json_read.h"

#include <float.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

json_reader json_read_begin(const char* text, size_t size)
{
    json_reader in = {text, text + size, 1, 1, ""};
    return in;
}

int json_read_fine(const json_reader* in) { return in->error[0] == '\0'; }

int json_read_refuse(json_reader* in, const char* format, ...)
{
    va_list values;
    va_start(values, format);
    if (json_read_fine(in)) vsnprintf(in->error, sizeof in->error, format, values);
    va_end(values);
    return 0;
}

/* The next character, 0 at the end: a NUL in the text is as little JSON as its end. */
static char peek(const json_reader* in) { return in->at < in->end ? *in->at : '\0'; }

static void skip_blanks(json_reader* in)
{
    for (; in->at < in->end && strchr(" \t\r\n", *in->at) && *in->at; in->at++) in->line += *in->at == '\n';
}

/* Takes one character if it comes next, after blanks. */
static int take(json_reader* in, char wanted)
{
    skip_blanks(in);
    if (!json_read_fine(in) || peek(in) != wanted) return 0;
    in->at++;
    return 1;
}

int json_read_open(json_reader* in, char bracket)
{
    in->fresh = 1;
    return take(in, bracket) || json_read_refuse(in, "a %c is expected here", bracket);
}

/* Whether something further comes before the closing bracket. */
static int take_separator(json_reader* in, char bracket)
{
    if (!json_read_fine(in)) return 0;
    int fresh = in->fresh;
    in->fresh = 0;
    if (take(in, bracket)) return 0;
    return fresh || take(in, ',') || json_read_refuse(in, "a comma or %c is expected here", bracket);
}

int json_read_value(json_reader* in) { return take_separator(in, ']'); }

int json_read_member(json_reader* in, char key[JSON_KEY_ROOM])
{
    if (!take_separator(in, '}') || !json_read_text(in, key, JSON_KEY_ROOM)) return 0;
    return take(in, ':') || json_read_refuse(in, "a : is expected after \"%s\"", key);
}

static int hexadecimal(char c)
{
    if (c >= '0' && c <= '9') return c - '0';
    return c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/* The character that an escape stands for, as keys have it; its backslash is taken. */
static char take_escape(json_reader* in)
{
    static const char letters[] = "\"\\/bfnrt", meanings[] = "\"\\/\?\?\?\?\?";
    char letter = peek(in);
    const char* known = letter ? strchr(letters, letter) : NULL;
    int code = 0;
    if (letter) in->at++;
    if (known) return meanings[known - letters];
    for (int i = 0; i < 4 && letter == 'u'; i++, in->at++) {
        int digit = hexadecimal(peek(in));
        if (digit < 0) letter = '\0';
        if (digit < 0) break;
        code = code * 16 + digit;
    }
    if (letter != 'u') json_read_refuse(in, "an unknown escape in a text");
    return code >= 0x20 && code < 0x7f ? (char)code : '?';
}

int json_read_text(json_reader* in, char* text, size_t room)
{
    size_t length = 0;
    if (!take(in, '"')) return json_read_refuse(in, "a text in \" is expected here");
    while (json_read_fine(in) && peek(in) != '"') {
        unsigned char c = (unsigned char)peek(in);
        if (c < 0x20) return json_read_refuse(in, "a text does not end");
        if (length + 1 == room) return json_read_refuse(in, "a text is too long");
        in->at++;
        text[length++] = c == '\\' ? take_escape(in) : c < 0x7f ? (char)c : '?';
    }
    if (!json_read_fine(in)) return 0;
    in->at++;
    text[length] = '\0';
    return 1;
}

static int is_digit(char c) { return c >= '0' && c <= '9'; }

/* Digits that count, and the power of ten that stands by them. */
typedef struct decimal {
    uint64_t digits;
    int exponent;
} decimal;

/* Reads one or more digits; answers how many there are. */
static int take_digits(json_reader* in, decimal* number, int step)
{
    const char* begin = in->at;
    for (; is_digit(peek(in)); in->at++) {
        int counts = number->digits < UINT64_MAX / 10 - 1;
        if (counts) number->digits = number->digits * 10 + (uint64_t)(*in->at - '0');
        number->exponent += counts ? step : step + 1;
    }
    return in->at > begin;
}

static int take_exponent(json_reader* in, int* exponent)
{
    int negative = peek(in) == '-', size = 0;
    if (negative || peek(in) == '+') in->at++;
    if (!is_digit(peek(in))) return 0;
    for (; is_digit(peek(in)); in->at++)
        if (size < 100000) size = size * 10 + (*in->at - '0');
    *exponent += negative ? -size : size;
    return 1;
}

/* The grammar of numbers: no +, no leading zero, digits on both sides of the point. */
static int take_decimal(json_reader* in, decimal* number)
{
    const char* begin = in->at;
    if (!take_digits(in, number, 0) || (*begin == '0' && in->at - begin > 1)) return 0;
    if (peek(in) == '.') {
        in->at++;
        if (!take_digits(in, number, -1)) return 0;
    }
    if (peek(in) != 'e' && peek(in) != 'E') return 1;
    in->at++;
    return take_exponent(in, &number->exponent);
}

/* Few roundings of a double, far from the half way between two floats that 9 digits leave alone. */
static double scaled(const decimal* number)
{
    double value = (double)number->digits, power = 1;
    int size = number->exponent < 0 ? -number->exponent : number->exponent;
    if (number->digits == 0) return 0;
    if (size > 300) return number->exponent < 0 ? 0 : DBL_MAX;
    for (double ten = 10; size > 0; size >>= 1, ten = size ? ten * ten : ten)
        if (size & 1) power *= ten;
    return number->exponent < 0 ? value / power : value * power;
}

int json_read_float(json_reader* in, float* value)
{
    decimal number = {0, 0};
    int negative = take(in, '-');
    if (!negative) skip_blanks(in);
    if (!json_read_fine(in)) return 0;
    if (!take_decimal(in, &number)) return json_read_refuse(in, "a number is expected here");
    double size = scaled(&number);
    if (size > (double)FLT_MAX) return json_read_refuse(in, "the number is too large");
    *value = (float)(negative ? -size : size);
    return 1;
}

int json_read_end(json_reader* in)
{
    skip_blanks(in);
    return json_read_fine(in) && (in->at == in->end || json_read_refuse(in, "something follows the end"));
}
