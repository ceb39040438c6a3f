/* Where samples are, and where what is computed of them goes. field.h, layout.h and walk.h come before all kernels. */

#pragma OPENCL FP_CONTRACT OFF

typedef struct Position {
    weft_i64 x, y, z;
    weft_i32 fraction_x, fraction_y, fraction_z;
    float level;
} Position;

/* Pixel i of a window of level L is at (i + 1/2) * 2^L. */
static Position window_position(SamplesLayout samples, weft_u32 column, weft_u32 row)
{
    const weft_i64 unit = (weft_i64)1 << samples.level;
    const weft_i64 half_unit = unit >> 1;
    Position at;
    at.x = (samples.x + column) * unit + half_unit;
    at.y = (samples.y + row) * unit + half_unit;
    at.z = 0;
    at.fraction_x = at.fraction_y = samples.level == 0 ? WEFT_FRACTION_HALF : 0;
    at.fraction_z = 0;
    at.level = (float)samples.level;
    return at;
}

static Position position_of(SamplesLayout samples, global const SpotLayout* spots, weft_u32 column, weft_u32 row)
{
    if (samples.spots) {
        Position at;
        at.x = spots[column].cell[0];
        at.y = spots[column].cell[1];
        at.z = spots[column].cell[2];
        at.fraction_x = (weft_i32)spots[column].fraction[0];
        at.fraction_y = (weft_i32)spots[column].fraction[1];
        at.fraction_z = (weft_i32)spots[column].fraction[2];
        at.level = spots[column].level;
        return at;
    }
    return window_position(samples, column, row);
}

static float4 lerp4(float4 a, float4 b, float t) { return t * (b - a) + a; }

/* A plane's tone curve. */
static float tone(float v, global const weft_u32* words, global const float* numbers, weft_u32 tones, weft_u32 channel)
{
    const weft_u32 count = words[tones + channel * 2];
    global const float* curve = numbers + words[tones + channel * 2 + 1];
    global const float* piece = curve + 2;
    v = weft_clamp(v, curve[0], curve[1]);
    for (weft_u32 k = 1; k < count && v >= piece[5]; ++k) piece += 5;
    return weft_piece_at(v - piece[0], piece[1], piece[2], piece[3], piece[4]);
}

/* Four planes of a sample into the field. */
static void store_group(global float* field, global const LayerLayout* layer, SamplesLayout samples, weft_u32 column,
                        weft_u32 row, weft_u32 group, float4 f)
{
    const float values[4] = {f.x, f.y, f.z, f.w};
    global float* to =
        field + (size_t)(layer->plane_slot + group * 4) * samples.pitch + (size_t)row * samples.stride + column;
    for (weft_u32 p = 0; p < 4 && group * 4 + p < layer->planes; ++p) to[(size_t)p * samples.pitch] = values[p];
}
