/* Text on a canvas, in a font of our own: 6 x 10 pixels a character, printable ASCII. */
#ifndef WEFT_CLI_FONT_H
#define WEFT_CLI_FONT_H

#include "canvas.h"

enum { FONT_ADVANCE = 6, FONT_HEIGHT = 7 }; /* from one character to the next; of a capital letter */

/* Scale 1, 2 or 4: what is enlarged gets smooth diagonals. (x, y) is the upper left corner of the first capital. */
void font_text(canvas* c, uint32_t x, uint32_t y, uint32_t scale, uint32_t colour, const char* text);

uint32_t font_width(const char* text, uint32_t scale);

#endif
