/* A writer of JSON: keys in objects, NULL for the key in arrays and at the top. */
#ifndef WEFT_CLI_JSON_H
#define WEFT_CLI_JSON_H

#include <stdint.h>
#include <stdio.h>

enum { JSON_DEPTH = 16 };

typedef struct json {
    FILE* file;
    int depth;
    char close[JSON_DEPTH]; /* the bracket that ends each open level */
    int count[JSON_DEPTH];  /* the values in it so far */
} json;

json json_begin(FILE* file);
void json_object(json* out, const char* key);
void json_array(json* out, const char* key);
void json_end(json* out); /* of the innermost object or array */

void json_text(json* out, const char* key, const char* value); /* bytes that are no UTF-8 become U+FFFD */
void json_integer(json* out, const char* key, int64_t value);
void json_unsigned(json* out, const char* key, uint64_t value);
void json_real(json* out, const char* key, double value); /* null if not finite; float's digits are kept */
void json_truth(json* out, const char* key, int value);
void json_null(json* out, const char* key);

#endif
