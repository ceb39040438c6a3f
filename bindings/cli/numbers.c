/* Parsing of numbers, without the leniencies of strtoull (blanks, signs, rests). */
#include "numbers.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>

/* Reads digits (or 0x and hexadecimal digits) from *text on and leaves *text behind them. */
static int take_unsigned(const char** text, uint64_t* value)
{
    if (!isdigit((unsigned char)**text)) return 0;
    int base = (*text)[0] == '0' && ((*text)[1] == 'x' || (*text)[1] == 'X') ? 16 : 10;
    char* end = NULL;
    errno = 0;
    unsigned long long number = strtoull(*text, &end, base);
    if (errno != 0 || end == *text) return 0;
    *text = end;
    *value = number;
    return 1;
}

static int take_signed(const char** text, int64_t* value)
{
    int negative = **text == '-';
    if (negative || **text == '+') ++*text;
    uint64_t size = 0;
    if (!take_unsigned(text, &size) || size > (uint64_t)INT64_MAX + (uint64_t)negative) return 0;
    *value = negative ? -1 - (int64_t)(size - 1) : (int64_t)size;
    if (negative && size == 0) *value = 0;
    return 1;
}

static int take_word32(const char** text, uint32_t* value)
{
    uint64_t number = 0;
    if (!take_unsigned(text, &number) || number > UINT32_MAX) return 0;
    *value = (uint32_t)number;
    return 1;
}

int parse_unsigned(const char* text, uint64_t* value) { return take_unsigned(&text, value) && *text == '\0'; }

int parse_real(const char* text, double* value)
{
    char* end = NULL;
    if (!isdigit((unsigned char)*text) && *text != '.' && *text != '-') return 0;
    *value = strtod(text, &end);
    return end != text && *end == '\0' && isfinite(*value);
}

/* Decimal only: the x between the two numbers would be taken for that of 0x. */
int parse_extent(const char* text, extent* value)
{
    uint32_t* sides[2] = {&value->width, &value->height};
    for (int i = 0; i < 2; i++) {
        uint64_t number = 0;
        if (!isdigit((unsigned char)*text)) return 0;
        for (; isdigit((unsigned char)*text); text++) {
            number = number * 10 + (uint64_t)(*text - '0');
            if (number > UINT32_MAX) return 0;
        }
        *sides[i] = (uint32_t)number;
        if (i == 0 && *text++ != 'x') return 0;
    }
    return *text == '\0';
}

int parse_position(const char* text, position* value)
{
    if (!take_signed(&text, &value->x) || *text++ != ',') return 0;
    return take_signed(&text, &value->y) && *text == '\0';
}

int parse_counts(const char* text, uint32_t* values, int most)
{
    for (int n = 0; n < most; n++) {
        if (!take_word32(&text, &values[n]) || values[n] < 1 || values[n] > 16) return 0;
        if (*text == '\0') return n + 1;
        if (*text++ != ',') return 0;
    }
    return 0;
}
