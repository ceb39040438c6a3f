/// The plug-in "simd": the kernels of the instruction sets that this processor has, best first; then those it lacks,
/// each with the sentence why it is refused.
#include "texture.h"

namespace weft {

#if defined(__x86_64__)
namespace avx512 {
extern const Rows rows;
}
namespace avx2 {
extern const Rows rows;
}
#elif defined(__aarch64__)
namespace neon {
extern const Rows rows;
}
#endif

namespace {

struct Level {
    const char* name;
    const char* description;
    const char* refusal;
    const Rows* rows;
    bool (*runs)();
};

#if defined(__x86_64__)
// The very features that the compiler was given; the builtin also asks whether the system keeps the registers.
bool has_avx2()
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2");
}

bool has_avx512()
{
    return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}

constexpr Level levels[] = {
    {"avx512", "AVX-512 F, BW, CD, DQ, VL", "this processor or system lacks AVX-512 (F, BW, CD, DQ and VL)",
     &avx512::rows, has_avx512},
    {"avx2", "AVX2 and FMA", "this processor or system lacks AVX2 or FMA", &avx2::rows, has_avx2},
};
#elif defined(__aarch64__)
bool always() { return true; }

constexpr Level levels[] = {{"neon", "Advanced SIMD", "", &neon::rows, always}};
#endif

constexpr uint32_t level_count = sizeof levels / sizeof levels[0];

/// Those that run, in order, before those that do not.
const Level& level_at(uint32_t index)
{
    constexpr bool order[] = {true, false};
    for (const bool wanted : order)
        for (const Level& level : levels)
            if (level.runs() == wanted && index-- == 0) return level;
    return levels[0];
}

void copy(const char* from, char* to)
{
    while ((*to++ = *from++) != 0) {
    }
}

uint32_t count() noexcept { return level_count; }

void info(uint32_t index, weft_device_info* info) noexcept
{
    const Level& level = level_at(index);
    const bool runs = level.runs();
    info->status = runs ? WEFT_OK : WEFT_ERROR_DEVICE;
    copy(level.name, info->name);
    copy(runs ? level.description : level.refusal, info->description);
    info->exact = runs ? 1 : 0;
}

weft_status open(const weft_host* host, uint32_t index, weft_device_limits* limits,
                 weft_backend_device** device) noexcept
{
    const Level& level = level_at(index);
    if (!level.runs()) {
        host->error(host->self, level.refusal);
        return WEFT_ERROR_DEVICE;
    }
    limits->window_width = 512;
    limits->window_height = 120;
    limits->batch = 4096;
    return device_open(host, *level.rows, device);
}

} // namespace
} // namespace weft

WEFT_BACKEND_EXPORT const weft_backend weft_backend_v0 = {
    WEFT_BACKEND_HEAD("simd"), weft::count,          weft::info,           weft::open,         weft::device_close,
    weft::texture_open,        weft::texture_render, weft::texture_sample, weft::texture_close};
