/* PNG files over libpng: read whole into a weft_image, written row by row.
 *
 * Nothing here prints, exits or jumps out: a function answers 0 on success and otherwise another number, with a
 * sentence in `why`. */
#ifndef WEFT_CLI_PNG_H
#define WEFT_CLI_PNG_H

#include <stdio.h>
#include <weft/weft.h>

typedef struct pngfile_reason {
    char text[160];
} pngfile_reason;

/* Reads a PNG of any colour type and depth, interlaced or not. Depths up to 8 give U8 (of 0..255), 16 gives U16 in
 * native byte order. A palette gives its colours. Transparency, be it a channel, a palette's or one colour's, is the
 * last channel; where every pixel is opaque it is left out. So 1 channel is grey, 2 grey and alpha, 3 RGB, 4 RGBA.
 * Gamma and colour profiles are not applied. The caller frees image->data with free(). */
int pngfile_read(FILE* file, weft_image* image, pngfile_reason* why);

typedef struct pngfile_writer pngfile_writer;

/* Begins a PNG of 1 to 4 channels, meaning as above, in U8 or U16. On success *writer must be ended. */
int pngfile_begin(FILE* file, uint32_t width, uint32_t height, uint32_t channels, weft_format format,
                  pngfile_writer** writer, pngfile_reason* why);

/* Appends rows from memory, `stride` bytes apart, in native byte order. */
int pngfile_rows(pngfile_writer* writer, const void* rows, size_t stride, uint32_t count, pngfile_reason* why);

/* Completes the file if all rows were written, and frees the writer in any case. The FILE stays open. */
int pngfile_end(pngfile_writer* writer, pngfile_reason* why);

#endif
