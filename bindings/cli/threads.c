/* Fork and join over POSIX threads. */
#define _GNU_SOURCE 1 /* sched_getaffinity */
#include "threads.h"

#include <pthread.h>
#include <sched.h>
#include <unistd.h>

typedef struct share {
    void (*work)(void* argument, uint32_t i, uint32_t count);
    void* argument;
    uint32_t i, count;
} share;

uint32_t available_threads(void)
{
#ifdef __linux__
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) == 0) return (uint32_t)CPU_COUNT(&set);
#endif
    long online = sysconf(_SC_NPROCESSORS_ONLN);
    return online > 0 ? (uint32_t)online : 1;
}

static void* run_share(void* argument)
{
    share* s = argument;
    s->work(s->argument, s->i, s->count);
    return NULL;
}

int run_threads(uint32_t count, void (*work)(void* argument, uint32_t i, uint32_t count), void* argument)
{
    pthread_t threads[MOST_THREADS];
    share shares[MOST_THREADS];
    uint32_t started = 1;
    if (count > MOST_THREADS) return -1;
    for (uint32_t i = 0; i < count; i++) shares[i] = (share){work, argument, i, count};
    while (started < count && pthread_create(&threads[started], NULL, run_share, &shares[started]) == 0) started++;
    run_share(&shares[0]);
    for (uint32_t i = 1; i < started; i++) pthread_join(threads[i], NULL);
    return started == count ? 0 : -1;
}
