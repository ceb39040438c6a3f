/* What this machine can do at most: multiply-adds and stores. */
#ifndef WEFT_CLI_MACHINE_H
#define WEFT_CLI_MACHINE_H

#include <stddef.h>
#include <stdint.h>

/* A loop of independent multiply-adds in registers, in one instruction set. */
typedef struct multiply_add_loop {
    const char* name; /* "avx2", "avx512", "neon", "baseline" */
    int fused;        /* 0: a multiplication and an addition */
    double lanes;     /* multiply-adds that one round does */
    float (*run)(uint64_t rounds);
} multiply_add_loop;

/* The widest that this processor has; it is not always the fastest, but the one that kernels would use. */
multiply_add_loop machine_multiply_add(void);

/* Loops that fill memory: by-passing the caches where the machine can (non_temporal), and in the plain way. `bytes` is
 * a multiple of 64, `memory` aligned to 64. */
void machine_store(void* memory, size_t bytes, int non_temporal);

#endif
