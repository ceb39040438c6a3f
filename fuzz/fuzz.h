/* What the fuzz targets share: a context with a small memory limit, and a check that stops the fuzzer. */
#ifndef WEFT_FUZZ_H
#define WEFT_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <weft/weft.h>

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size);

#define FUZZ_CHECK(good)                                                                                               \
    do {                                                                                                               \
        if (!(good)) {                                                                                                 \
            fprintf(stderr, "%s:%d: not true: %s; %s\n", __FILE__, __LINE__, #good, weft_error_message());             \
            abort();                                                                                                   \
        }                                                                                                              \
    } while (0)

/* A context for `device`, of one thread and at most 64 MiB; made at its first use and kept. */
weft_context* fuzz_context(const char* device);

/* An error must be one of the named ones, and say something. */
void fuzz_check_error(weft_status status);

/* Takes `count` bytes off the front of the input into `value`; missing bytes are zero. */
void fuzz_take(const uint8_t** bytes, size_t* size, void* value, size_t count);

/* What holds for every model: its info is sane, and its bytes are canonical. */
void fuzz_check_model(weft_context* context, const weft_model* model);

/* Makes the checksums and the size of a model file right, so that mutations are judged by what lies behind them. */
void fuzz_repair(uint8_t* bytes, size_t size);

#endif
