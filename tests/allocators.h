/* Allocators of the tests: they count what is held and fail when told. Thread-safe. */
#ifndef WEFT_TESTS_ALLOCATORS_H
#define WEFT_TESTS_ALLOCATORS_H

#include <pthread.h>
#include <weft/weft.h>

typedef struct Ledger {
    pthread_mutex_t lock;
    uint64_t held, peak; /* bytes */
    uint64_t blocks;     /* held now */
    uint64_t calls;      /* of allocate, so far */
    uint64_t fail_at;    /* this call fails (counted from 1); 0: none */
    int fail_from_there; /* and all after it */
    int broken;          /* a block came back with another size or alignment, or twice */
} Ledger;

void ledger_open(Ledger *ledger, uint64_t fail_at);
void ledger_close(Ledger *ledger); /* asserts that nothing is held and nothing was broken */
weft_allocator ledger_allocator(Ledger *ledger);

#endif
