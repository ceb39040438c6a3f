/* The executors, and the count of this process's threads. */
#include "executors.h"
#include <dirent.h>
#include <pthread.h>

typedef void (*Task)(void *argument, uint32_t i);

static void run_serial(void *user, uint32_t count, Task task, void *argument)
{
    (void)user;
    for (uint32_t i = 0; i < count; ++i) task(argument, i);
}

static void run_reversed(void *user, uint32_t count, Task task, void *argument)
{
    (void)user;
    for (uint32_t i = count; i-- > 0;) task(argument, i);
}

#define CREW 3

typedef struct Share {
    Task task;
    void *argument;
    uint32_t first, count;
} Share;

static void *work(void *share_of_work)
{
    const Share *share = share_of_work;
    for (uint32_t i = share->first; i < share->count; i += CREW) share->task(share->argument, i);
    return NULL;
}

static void run_threads(void *user, uint32_t count, Task task, void *argument)
{
    pthread_t thread[CREW];
    Share share[CREW];
    int started[CREW];
    (void)user;
    for (uint32_t t = 0; t < CREW; ++t) {
        const Share part = {task, argument, t, count};
        share[t] = part;
        started[t] = pthread_create(&thread[t], NULL, work, &share[t]) == 0;
        if (!started[t]) work(&share[t]);
    }
    for (uint32_t t = 0; t < CREW; ++t)
        if (started[t]) pthread_join(thread[t], NULL);
}

const weft_executor serial_executor = {run_serial, NULL};
const weft_executor reversed_executor = {run_reversed, NULL};
const weft_executor threads_executor = {run_threads, NULL};

int thread_count(void)
{
    DIR *tasks = opendir("/proc/self/task");
    int count = 0;
    if (!tasks) return -1;
    for (const struct dirent *entry; (entry = readdir(tasks));) count += entry->d_name[0] != '.';
    closedir(tasks);
    return count;
}
