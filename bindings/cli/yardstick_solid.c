/* Cook and DeRose, "Wavelet Noise" (2005), section 3.3 and its appendix: the quadratic B-spline of a cube of 128
 * coefficients a side, repeated for ever: 27 of them are weighted one by one, their indices taken modulo the side. */
#include "yardstick_solid.h"

#include <math.h>
#include <stdlib.h>

enum { SIDE = 128 };

static int wrapped(int index)
{
    int rest = index % SIDE;
    return rest < 0 ? rest + SIDE : rest;
}

/* The coefficient nearest to p, and the weights of it and its neighbours. */
static int spline_at(float p, float w[3])
{
    float centre = ceilf(p - 0.5f), t = centre - (p - 0.5f);
    w[0] = t * t / 2;
    w[2] = (1 - t) * (1 - t) / 2;
    w[1] = 1 - w[0] - w[2];
    return (int)centre;
}

static float octave(const float* tile, const float p[3])
{
    float w[3][3], sum = 0;
    int centre[3];
    for (int axis = 0; axis < 3; axis++) centre[axis] = spline_at(p[axis], w[axis]);
    for (int z = 0; z < 3; z++)
        for (int y = 0; y < 3; y++)
            for (int x = 0; x < 3; x++) {
                int column = wrapped(centre[0] + x - 1), row = wrapped(centre[1] + y - 1),
                    slice = wrapped(centre[2] + z - 1);
                sum += w[0][x] * w[1][y] * w[2][z] * tile[(slice * SIDE + row) * SIDE + column];
            }
    return sum;
}

float solid_value(const solid_noise* noise, uint32_t bands, const double* position)
{
    float sum = 0;
    for (uint32_t band = 0; band < bands; band++) {
        double unit = 1.0 / (double)(1u << band);
        const float p[3] = {(float)(position[0] * unit), (float)(position[1] * unit), (float)(position[2] * unit)};
        sum += octave(noise->tile, p);
    }
    return sum;
}

int solid_open(solid_noise* noise)
{
    uint32_t state = 1;
    noise->tile = malloc(sizeof *noise->tile * SIDE * SIDE * SIDE);
    if (!noise->tile) return -1;
    for (int i = 0; i < SIDE * SIDE * SIDE; i++) {
        state = state * 1664525u + 1013904223u; /* Knuth and Lewis */
        noise->tile[i] = (float)(int32_t)state * 0x1p-31f;
    }
    return 0;
}

void solid_free(solid_noise* noise)
{
    free(noise->tile);
    noise->tile = NULL;
}
