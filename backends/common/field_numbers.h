/* Arithmetic, hashes and levels of field.h: what all kinds of layers share. */
#ifndef WEFT_FIELD_NUMBERS_H
#define WEFT_FIELD_NUMBERS_H

#if defined(__OPENCL_C_VERSION__) || defined(__OPENCL_VERSION__)
#pragma OPENCL FP_CONTRACT OFF
typedef int weft_i32;
typedef uint weft_u32;
typedef long weft_i64;
typedef ulong weft_u64;
#else
#include <stdint.h>
typedef int32_t weft_i32;
typedef uint32_t weft_u32;
typedef int64_t weft_i64;
typedef uint64_t weft_u64;
#endif

#define WEFT_FRACTION_BITS 24       /* of a position within its pixel */
#define WEFT_FRACTION_HALF 0x800000 /* the centre of a pixel */
#define WEFT_FRACTION_MASK 0xffffff
#define WEFT_FRACTION_UNIT (1.0f / 16777216.0f)

/* Multiply-add with one rounding -------------------------------------------------------------------------------- */

#if defined(__OPENCL_C_VERSION__) || defined(__OPENCL_VERSION__)
#define weft_fma(a, b, c) fma((a), (b), (c))
#elif defined(__FMA__) || defined(__aarch64__)
static inline float weft_fma(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
#else
/* The product is exact in binary64. The sum is rounded to odd: its last bit is set if anything was lost, and then the
 * second rounding, to binary32, is that of the exact value (Boldo and Melquiond 2008). */
static inline float weft_fma(float a, float b, float c)
{
    const double product = (double)a * (double)b;
    const double addend = (double)c;
    double sum = product + addend;
    const double part = sum - product;
    const double lost = (product - (sum - part)) + (addend - part);
    weft_u64 bits;
    __builtin_memcpy(&bits, &sum, sizeof bits);
    if ((lost < 0 || lost > 0) && (bits & 1) == 0) bits += (lost > 0) == (sum > 0) ? (weft_u64)1 : ~(weft_u64)0;
    __builtin_memcpy(&sum, &bits, sizeof sum);
    return (float)sum;
}
#endif

/* b from a by t. Where a rule says "if t > 0", it is weft_lerp_if: that decides the sign of zero. */
static inline float weft_lerp(float a, float b, float t) { return t * (b - a) + a; }
static inline float weft_lerp_if(float a, float b, float t) { return t > 0.0f ? t * (b - a) + a : a; }

static inline float weft_clamp(float v, float low, float high)
{
    v = v < low ? low : v;
    return v > high ? high : v;
}

/* Largest integer not above s, for |s| < 2^31. */
static inline weft_i32 weft_floor(float s)
{
    const weft_i32 k = (weft_i32)s;
    return k - (s < (float)k ? 1 : 0);
}

/* Largest integer not above n / d; n below 2^63 in size. */
static inline weft_i64 weft_divide_down(weft_i64 n, weft_u32 d)
{
    const weft_i64 q = n / (weft_i64)d;
    return q - (n - q * (weft_i64)d < 0 ? 1 : 0);
}

/* Random numbers: counter-based, 64 bits (the finaliser of splitmix64) --------------------------------------- */

#define WEFT_GOLDEN ((weft_u64)0x9e3779b97f4a7c15)

/* Tags of keys: what a hash is for. */
#define WEFT_TAG_IMPACTS 3

static inline weft_u64 weft_mix(weft_u64 z)
{
    z = (z ^ (z >> 30)) * (weft_u64)0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * (weft_u64)0x94d049bb133111eb;
    return z ^ (z >> 31);
}

static inline weft_u64 weft_absorb(weft_u64 h, weft_u64 v) { return weft_mix((h ^ v) + WEFT_GOLDEN); }

/* The i-th number of a key's sequence. */
static inline weft_u64 weft_draw(weft_u64 key, weft_u32 i) { return weft_mix(key + ((weft_u64)i + 1) * WEFT_GOLDEN); }

/* key(tag, v...) = absorb(... absorb(weft_key(seed, stream, tag), v) ...). */
static inline weft_u64 weft_key(weft_u64 seed, weft_u32 stream, weft_u32 tag)
{
    return weft_absorb(weft_absorb(seed, stream), tag);
}

static inline weft_u32 weft_low(weft_u64 z) { return (weft_u32)(z & (weft_u64)0xffffffff); }
static inline weft_u32 weft_high(weft_u64 z) { return (weft_u32)(z >> 32); }

/* Levels ----------------------------------------------------------------------------------------------------------- */

/* A level between two of a mip chain: the chain's level `whole`, and if t > 0 the next one by lerp. */
typedef struct weft_between {
    weft_i32 whole;
    float t;
} weft_between;

/* SPLAT, where f is 0 from level `levels` on. */
static inline weft_between weft_level(float level)
{
    weft_between at;
    at.whole = (weft_i32)level;
    at.t = level - (float)at.whole;
    return at;
}

#endif
