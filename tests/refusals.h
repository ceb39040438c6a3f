/* What the tests of arguments share: macros for refusals, and views of images that no function may accept. */
#ifndef WEFT_TESTS_REFUSALS_H
#define WEFT_TESTS_REFUSALS_H

#include "support.h"

#define REFUSED(call, function, word) assert_refused(call, WEFT_ERROR_ARGUMENT, function, word)

/* A call that would write a handle into `out`, and must not. */
static char elsewhere;
#define UNTOUCHED ((void *)&elsewhere)
#define REFUSED_HANDLE(call, out, status, function, word)                                                              \
    do {                                                                                                               \
        (out) = UNTOUCHED;                                                                                             \
        assert_refused(call, status, function, word);                                                                  \
        assert_ptr_equal(out, UNTOUCHED);                                                                              \
    } while (0)

/* A wrong view and the word that the sentence must have. */
typedef struct Bad_view {
    weft_image image;
    const char *word;
} Bad_view;
#define MOST_BAD_VIEWS 32

/* Ways to spoil `good`, a packed RGB F32 image 32 pixels wide. Returns their number. */
static inline uint32_t bad_views(const weft_image *good, Bad_view bad[MOST_BAD_VIEWS])
{
    uint32_t n = 0;
    for (int i = 0; i < 18; ++i) {
        weft_image image = *good;
        const char *word = "";
        switch (i) {
        case 0: image.data = NULL, word = "data"; break;
        case 1: image.width = 0, word = "width"; break;
        case 2: image.width = 65537, word = "width"; break;
        case 3: image.width = UINT32_MAX, word = "width"; break;
        case 4: image.height = 0, word = "height"; break;
        case 5: image.height = 65537, word = "height"; break;
        case 6: image.height = UINT32_MAX, word = "height"; break;
        case 7: image.channels = 0, word = "channels"; break;
        case 8: image.channels = 17, word = "channels"; break;
        case 9: image.channels = UINT32_MAX, word = "channels"; break;
        case 10: image.format = 0, word = "format"; break;
        case 11: image.format = 4, word = "format"; break;
        case 12: image.format = -1, word = "format"; break;
        case 13: image.stride = 32 * 3 * 4 - 4, word = "stride"; break;
        case 14: image.stride = -(32 * 3 * 4 - 4), word = "stride"; break;
        case 15: image.stride = 32 * 3 * 4 + 2, word = "stride"; break;
        case 16: image.stride = 1, word = "stride"; break;
        default: image.format = WEFT_FORMAT_U16, image.stride = 32 * 3 * 2 + 1, word = "stride"; break;
        }
        bad[n].image = image;
        bad[n++].word = word;
    }
    return n;
}

#endif
