/* The two clocks: time that passes, and processor time that this process takes. */
#ifndef WEFT_CLI_CLOCK_H
#define WEFT_CLI_CLOCK_H

#include <time.h>

static inline double clock_seconds(clockid_t clock)
{
    struct timespec now = {0, 0};
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static inline double wall_seconds(void) { return clock_seconds(CLOCK_MONOTONIC); }

/* Of all threads together. */
static inline double processor_seconds(void) { return clock_seconds(CLOCK_PROCESS_CPUTIME_ID); }

#endif
