/* Executors of the tests: one after another, from the last to the first, and on threads of their own. */
#ifndef WEFT_TESTS_EXECUTORS_H
#define WEFT_TESTS_EXECUTORS_H

#include <weft/weft.h>

extern const weft_executor serial_executor, reversed_executor;
extern const weft_executor threads_executor; /* a few new threads for each call; the caller only waits */

/* How many threads this process has now. */
int thread_count(void);

#endif
