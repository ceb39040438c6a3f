/* Numbers as people write them on a command line. Each function takes the whole text or refuses it: 1 is success. */
#ifndef WEFT_CLI_NUMBERS_H
#define WEFT_CLI_NUMBERS_H

#include <stdint.h>

typedef struct extent {
    uint32_t width, height;
} extent;

typedef struct position {
    int64_t x, y;
} position;

int parse_unsigned(const char* text, uint64_t* value);          /* 0 .. 2^64 - 1; 0x.. is hexadecimal */
int parse_real(const char* text, double* value);                /* finite */
int parse_extent(const char* text, extent* value);              /* WxH */
int parse_position(const char* text, position* value);          /* X,Y with signs */
int parse_counts(const char* text, uint32_t* values, int most); /* 3,3,1: how many, or 0; each is 1..16 */

#endif
