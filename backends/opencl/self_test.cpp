/// The fixed programs, as windows and as spots, against stored values.
#include "opencl/self_test.h"
#include "opencl/self_test_program.h"
#include "opencl/texture.h"
#include <cfloat>
#include <cmath>

namespace weft::opencl {

namespace {

constexpr weft_u32 expected[] = {
#include "opencl/self_test_values.inc"
};

} // namespace

float largest_difference(const Device& device)
{
    static_assert(sizeof expected / sizeof *expected == SelfTestProgram::value_count);
    float values[SelfTestProgram::value_count];
    float* end = values;
    // Small and the same for everyone: not a caller's memory, since no caller asked.
    std::pmr::memory_resource* memory = std::pmr::new_delete_resource();
    for (const weft_use use : SelfTestProgram::uses) {
        const SelfTestProgram fixed(use);
        Texture texture(device, fixed.program, memory);
        if (use == WEFT_USE_WINDOW)
            SelfTestProgram::look([&](const weft_window& window) { texture.render(window); }, end);
        else
            SelfTestProgram::look_at_spots(
                use, [&](const weft_batch& batch) { texture.sample(batch); }, end);
    }
    float largest = 0.0f;
    for (std::size_t i = 0; i < SelfTestProgram::value_count; ++i) {
        float good;
        std::memcpy(&good, &expected[i], sizeof good);
        if (std::memcmp(&good, &values[i], sizeof good) == 0) continue;
        const float difference = std::isfinite(values[i]) ? std::fabs(values[i] - good) : FLT_MAX;
        largest = std::fmax(largest, std::fmax(difference, FLT_MIN)); // two zeros differ too
    }
    return largest;
}

} // namespace weft::opencl
