/* The same work on several threads at once. */
#ifndef WEFT_CLI_THREADS_H
#define WEFT_CLI_THREADS_H

#include <stdint.h>

enum { MOST_THREADS = 1024 };

/* Threads that this process may run at once. */
uint32_t available_threads(void);

/* Calls work(argument, i, count) for each i < count, each on a thread of its own, and waits. 0 on success. */
int run_threads(uint32_t count, void (*work)(void* argument, uint32_t i, uint32_t count), void* argument);

#endif
