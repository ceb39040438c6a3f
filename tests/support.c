/* Checks, random numbers, files and devices for the tests. */
#include "support.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void check_ok(weft_status status, const char *call, const char *file, int line)
{
    if (status == WEFT_OK) return;
    print_error("%s\n  is %s: %s\n", call, weft_status_name(status), weft_error_message());
    _fail(file, line);
}

void check_refused(weft_status status, const char *call, weft_status expected, const char *function, const char *word,
                   const char *file, int line)
{
    const char *sentence = weft_error_message();
    if (status == expected && strncmp(sentence, function, strlen(function)) == 0 && strstr(sentence, word)) return;
    print_error("%s\n  is %s, should be %s; sentence should begin with '%s' and have '%s': '%s'\n", call,
                weft_status_name(status), weft_status_name(expected), function, word, sentence);
    _fail(file, line);
}

uint32_t scaled(uint32_t full, uint32_t quick)
{
#ifdef WEFT_TEST_QUICK
    (void)full;
    return quick;
#else
    return getenv("WEFT_TEST_QUICK") ? quick : full;
#endif
}

uint64_t random_bits(Random *random)
{
    uint64_t z = random->state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

uint32_t random_below(Random *random, uint32_t bound)
{
    return (uint32_t)(((random_bits(random) >> 32) * bound) >> 32);
}

double random_unit(Random *random) { return (double)(random_bits(random) >> 11) * 0x1p-53; }

double random_normal(Random *random)
{
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += random_unit(random);
    return sum;
}

uint32_t usable_devices(char names[MOST_DEVICES][64], int exact_only)
{
    uint32_t count = 0, used = 0;
    assert_ok(weft_device_count(&count));
    for (uint32_t i = 0; i < count && used < MOST_DEVICES; ++i) {
        weft_device_info info = WEFT_DEVICE_INFO_INIT;
        assert_ok(weft_device_get(i, &info));
        if (info.status != WEFT_OK || (exact_only && !info.exact)) continue;
        memcpy(names[used++], info.name, sizeof info.name);
    }
    return used;
}

uint64_t checksum(const void *bytes, size_t size)
{
    const unsigned char *byte = bytes;
    uint64_t sum = UINT64_C(0xcbf29ce484222325);
    for (size_t i = 0; i < size; ++i) sum = (sum ^ byte[i]) * UINT64_C(0x100000001b3);
    return sum;
}

void *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (!file) return NULL;
    char *bytes = NULL;
    long length = -1;
    if (fseek(file, 0, SEEK_END) == 0 && (length = ftell(file)) >= 0 && fseek(file, 0, SEEK_SET) == 0) {
        bytes = malloc((size_t)length + 1);
        if (bytes && fread(bytes, 1, (size_t)length, file) == (size_t)length) *size = (size_t)length;
    }
    fclose(file);
    return bytes;
}
