/* The counting and failing allocator: a header before each block remembers what was asked for. */
#include "allocators.h"
#include "support.h"
#include <stdlib.h>

#define BLOCK_MARK UINT64_C(0x5ca1ab1e0ddba115)

typedef struct Header {
    uint64_t mark;
    size_t size, alignment;
    void *memory;
} Header;

static void *ledger_allocate(void *user, size_t size, size_t alignment)
{
    Ledger *ledger = user;
    pthread_mutex_lock(&ledger->lock);
    const uint64_t call = ++ledger->calls;
    const int fail = ledger->fail_at && (ledger->fail_from_there ? call >= ledger->fail_at : call == ledger->fail_at);
    if ((alignment & (alignment - 1)) != 0 || alignment == 0) ledger->broken = 1;
    pthread_mutex_unlock(&ledger->lock);
    if (fail || size > SIZE_MAX - alignment - sizeof(Header)) return NULL;

    char *memory = malloc(size + alignment + sizeof(Header));
    if (!memory) return NULL;
    const uintptr_t start = ((uintptr_t)memory + sizeof(Header) + alignment - 1) & ~(uintptr_t)(alignment - 1);
    const Header header = {BLOCK_MARK, size, alignment, memory};
    __builtin_memcpy((char *)start - sizeof header, &header, sizeof header);
    pthread_mutex_lock(&ledger->lock);
    ledger->held += size;
    ledger->blocks += 1;
    if (ledger->held > ledger->peak) ledger->peak = ledger->held;
    pthread_mutex_unlock(&ledger->lock);
    return (void *)start;
}

static void ledger_deallocate(void *user, void *memory, size_t size, size_t alignment)
{
    Ledger *ledger = user;
    Header header;
    if (!memory) return;
    __builtin_memcpy(&header, (char *)memory - sizeof header, sizeof header);
    pthread_mutex_lock(&ledger->lock);
    if (header.mark != BLOCK_MARK || header.size != size || header.alignment != alignment) ledger->broken = 1;
    ledger->held -= header.size;
    ledger->blocks -= 1;
    pthread_mutex_unlock(&ledger->lock);
    header.mark = 0;
    __builtin_memcpy((char *)memory - sizeof header, &header, sizeof header);
    free(header.memory);
}

void ledger_open(Ledger *ledger, uint64_t fail_at)
{
    const Ledger empty = {PTHREAD_MUTEX_INITIALIZER, 0, 0, 0, 0, fail_at, 0, 0};
    *ledger = empty;
}

void ledger_close(Ledger *ledger)
{
    assert_int_equal(ledger->broken, 0);
    assert_int_equal(ledger->blocks, 0);
    assert_int_equal(ledger->held, 0);
}

weft_allocator ledger_allocator(Ledger *ledger)
{
    const weft_allocator allocator = {ledger_allocate, ledger_deallocate, ledger};
    return allocator;
}
