/// The backend "scalar": plain loops for the baseline instruction set, and once more with fused multiply-add where the
/// processor has it. Both give the same bits.
#include "scalar.h"
#include "texture.h"

namespace weft {

namespace scalar {
extern const Rows rows;
}
#if defined(WEFT_HAVE_SCALAR_FMA)
namespace scalar_fma {
extern const Rows rows;
}
#endif

namespace {

const Rows& best_rows()
{
#if defined(WEFT_HAVE_SCALAR_FMA)
    if (__builtin_cpu_supports("fma") && __builtin_cpu_supports("avx")) return scalar_fma::rows;
#endif
    return scalar::rows;
}

constexpr char description[] = "plain loops, the reference";

uint32_t count() noexcept { return 1; }

void info(uint32_t, weft_device_info* info) noexcept
{
    info->status = WEFT_OK;
    info->name[0] = 0;
    for (size_t i = 0; i < sizeof description; ++i) info->description[i] = description[i];
    info->exact = 1;
}

weft_status open(const weft_host* host, uint32_t, weft_device_limits* limits, weft_backend_device** device) noexcept
{
    limits->window_width = 256;
    limits->window_height = 64;
    limits->batch = 1024;
    return device_open(host, best_rows(), device);
}

constexpr weft_backend table = {WEFT_BACKEND_HEAD("scalar"),
                                count,
                                info,
                                open,
                                device_close,
                                texture_open,
                                texture_render,
                                texture_sample,
                                texture_close};

} // namespace

const weft_backend& scalar_backend() noexcept { return table; }

} // namespace weft
