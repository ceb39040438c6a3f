/* Loops that keep the multiply-add units, or the path to memory, as busy as they can be. */
#include "machine.h"

#include <math.h>
#include <string.h>

/* Enough chains to hide the latency of any unit there is (4 or 5 cycles on two ports), few enough for 16 registers. */
enum { CHAINS = 12 };

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#include <immintrin.h>

/* One loop: CHAINS registers of `type`, each multiplied and added to in every round. */
#define MULTIPLY_ADD_LOOP(name, isa, type, set1, step, store, width)                                                   \
    __attribute__((target(isa))) static float name(uint64_t rounds)                                                    \
    {                                                                                                                  \
        type a0 = set1(0.1f), a1 = set1(0.2f), a2 = set1(0.3f), a3 = set1(0.4f), a4 = set1(0.5f), a5 = set1(0.6f);     \
        type a6 = set1(0.7f), a7 = set1(0.8f), a8 = set1(0.9f), a9 = set1(1.0f), a10 = set1(1.1f), a11 = set1(1.2f);   \
        const type f = set1(0.999f), g = set1(0.001f);                                                                 \
        float out[width], sum = 0;                                                                                     \
        for (uint64_t i = 0; i < rounds; i++) {                                                                        \
            a0 = step(a0, f, g), a1 = step(a1, f, g), a2 = step(a2, f, g), a3 = step(a3, f, g);                        \
            a4 = step(a4, f, g), a5 = step(a5, f, g), a6 = step(a6, f, g), a7 = step(a7, f, g);                        \
            a8 = step(a8, f, g), a9 = step(a9, f, g), a10 = step(a10, f, g), a11 = step(a11, f, g);                    \
        }                                                                                                              \
        store(out, step(step(step(a0, a1, a2), a3, step(a4, a5, a6)), a7, step(step(a8, a9, a10), a11, g)));           \
        for (int i = 0; i < width; i++) sum += out[i];                                                                 \
        return sum;                                                                                                    \
    }
#define STEP_SSE(a, b, c) _mm_add_ps(_mm_mul_ps(a, b), c)

MULTIPLY_ADD_LOOP(run_baseline, "sse2", __m128, _mm_set1_ps, STEP_SSE, _mm_storeu_ps, 4)
MULTIPLY_ADD_LOOP(run_avx2, "avx2,fma", __m256, _mm256_set1_ps, _mm256_fmadd_ps, _mm256_storeu_ps, 8)
MULTIPLY_ADD_LOOP(run_avx512, "avx512f", __m512, _mm512_set1_ps, _mm512_fmadd_ps, _mm512_storeu_ps, 16)

multiply_add_loop machine_multiply_add(void)
{
    const multiply_add_loop avx512 = {"avx512", 1, 16 * CHAINS, run_avx512};
    const multiply_add_loop avx2 = {"avx2", 1, 8 * CHAINS, run_avx2};
    const multiply_add_loop baseline = {"sse2", 0, 4 * CHAINS, run_baseline};
    if (__builtin_cpu_supports("avx512f")) return avx512;
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? avx2 : baseline;
}

void machine_store(void* memory, size_t bytes, int non_temporal)
{
    float* target = memory;
    const __m128 value = _mm_set1_ps(1);
    if (!non_temporal) {
        memset(memory, 1, bytes);
        return;
    }
    for (size_t i = 0; i < bytes / sizeof *target; i += 4) _mm_stream_ps(target + i, value);
    _mm_sfence();
}

#else

/* Plain loops that compilers turn into the vectors of the baseline; fused where the baseline has that. */
enum { WIDTH = 4 };

static float run_baseline(uint64_t rounds)
{
    float a[CHAINS][WIDTH], sum = 0;
    const float f = 0.999f, g = 0.001f;
    for (int k = 0; k < CHAINS * WIDTH; k++) a[k / WIDTH][k % WIDTH] = 0.1f * (float)k;
    for (uint64_t i = 0; i < rounds; i++)
        for (int k = 0; k < CHAINS; k++)
            for (int j = 0; j < WIDTH; j++) {
#ifdef FP_FAST_FMAF
                a[k][j] = fmaf(a[k][j], f, g);
#else
                a[k][j] = a[k][j] * f + g;
#endif
            }
    for (int k = 0; k < CHAINS * WIDTH; k++) sum += a[k / WIDTH][k % WIDTH];
    return sum;
}

multiply_add_loop machine_multiply_add(void)
{
#ifdef FP_FAST_FMAF
    const multiply_add_loop baseline = {"baseline", 1, WIDTH * CHAINS, run_baseline};
#else
    const multiply_add_loop baseline = {"baseline", 0, WIDTH * CHAINS, run_baseline};
#endif
    return baseline;
}

void machine_store(void* memory, size_t bytes, int non_temporal)
{
    (void)non_temporal;
    memset(memory, 1, bytes);
}

#endif
