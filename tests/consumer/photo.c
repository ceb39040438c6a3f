/* Writes 256 x 256 RGB pixels of soft noise: the photo that README.md's example reads. */
#include <stdio.h>

int main(void)
{
    unsigned state = 7;
    int i, soft = 128;
    for (i = 0; i < 256 * 256 * 3; ++i) {
        state = state * 1664525u + 1013904223u;
        soft = (3 * soft + (int)(state >> 24)) / 4;
        putchar(soft);
    }
    return 0;
}
