/* A picture that is drawn on: 8 bits of red, green and blue, white at first, growing downwards. What lies outside is
 * not drawn. */
#ifndef WEFT_CLI_CANVAS_H
#define WEFT_CLI_CANVAS_H

#include <weft/weft.h>

typedef struct canvas {
    uint8_t* rgb;
    uint32_t width, height, room; /* room: rows that the memory has */
} canvas;

typedef struct rectangle {
    uint32_t x, y, width, height;
} rectangle;

/* A colour is 0xRRGGBB. */
enum { COLOUR_INK = 0x202428, COLOUR_FAINT = 0x70767c, COLOUR_GRID = 0xe2e5e8, COLOUR_PAPER = 0xffffff };

/* Makes it at least that high; an exit code. A canvas begins as { NULL, width, 0, 0 } and ends with canvas_free. */
int canvas_grow(canvas* c, uint32_t height);
void canvas_free(canvas* c);

/* Mixes a colour into one pixel: opacity 1 replaces it. */
void canvas_blend(canvas* c, int64_t x, int64_t y, uint32_t colour, float opacity);

void canvas_fill(canvas* c, rectangle area, uint32_t colour, float opacity);

/* A line with round ends, smooth at its edges. */
void canvas_line(canvas* c, float x0, float y0, float x1, float y1, float thickness, uint32_t colour);

/* Values of an image that are shown as black and white; everything between is linear. */
typedef struct tones {
    float low, high;
} tones;

/* The middle of an image in the area, each pixel `scale` by `scale` times. One or two channels are grey, of more the
 * first three are red, green and blue. */
void canvas_image(canvas* c, rectangle area, const weft_image* image, uint32_t scale, tones range);

/* Writes a PNG; an exit code. */
int canvas_write(const canvas* c, const char* path);

#endif
