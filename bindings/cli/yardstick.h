/* Texton noise as the paper's fragment shader evaluates it, pixel by pixel: the yardstick for faster forms. */
#ifndef WEFT_CLI_YARDSTICK_H
#define WEFT_CLI_YARDSTICK_H

#include <stdint.h>
#include <weft/weft.h>

typedef struct yardstick {
    float* texton; /* (height + 2) x (width + 2) texels, framed by zeros, as a GPU's border is */
    uint32_t width, height, channels;
    uint32_t fours;          /* a texel is that many times four floats, as a GPU's is RGBA */
    float mean[16], sum[16]; /* of the noise; of the texton's coefficients */
    float impacts;
} yardstick;

/* Copies the texton from a model of texton noise; 0 on success. Free with yardstick_free. */
int yardstick_open(yardstick* y, const weft_model* model, const weft_model_info* info, float impacts);
void yardstick_free(yardstick* y);

/* The noise at one point: `channels` floats. */
void yardstick_pixel(const yardstick* y, float x_at, float y_at, float* out);

#endif
