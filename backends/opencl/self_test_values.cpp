/// Prints self_test_values.inc: the fixed programs' values as any exact backend plug-in gives them.
///   weft_opencl_values .../weft_backend_simd.so >self_test_values.inc
#include "opencl/self_test_program.h"
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>

namespace {

using weft::opencl::SelfTestProgram;

void* allocate(void*, std::size_t size, std::size_t alignment) noexcept
{
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}
void deallocate(void*, void* memory, std::size_t, std::size_t) noexcept { std::free(memory); }
void error(void*, const char* sentence) noexcept { std::fputs(sentence, stderr); }

void write(const float* values)
{
    for (std::size_t i = 0; i < SelfTestProgram::value_count; ++i) {
        std::uint32_t bits;
        std::memcpy(&bits, values + i, sizeof bits);
        char text[16] = "0x";
        char* end = std::to_chars(text + 2, text + sizeof text - 3, bits, 16).ptr;
        *end++ = ',';
        *end++ = i % 10 == 9 ? '\n' : ' ';
        std::fwrite(text, 1, static_cast<std::size_t>(end - text), stdout);
    }
    std::fputs("\n", stdout);
}

} // namespace

int main(int count, char** arguments)
{
    void* plugin = count == 2 ? dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL) : nullptr;
    const auto* backend = plugin ? static_cast<const weft_backend*>(dlsym(plugin, "weft_backend_v0")) : nullptr;
    weft_host host = {sizeof(weft_host), WEFT_BACKEND_MINOR, nullptr, allocate, deallocate, error};
    weft_device_limits limits = {sizeof(weft_device_limits), 0, 0, 0, 0};
    weft_backend_device* device = nullptr;
    if (!backend || backend->device_open(&host, 0, &limits, &device) != WEFT_OK) return 1;
    static float values[SelfTestProgram::value_count];
    float* end = values;
    weft_status status = WEFT_OK;
    for (const weft_use use : SelfTestProgram::uses) {
        const SelfTestProgram fixed(use);
        weft_backend_texture* texture = nullptr;
        if (backend->texture_open(device, &fixed.program, &texture) != WEFT_OK) return 1;
        const auto keep = [&](weft_status next) { status = status == WEFT_OK ? next : status; };
        if (use == WEFT_USE_WINDOW)
            SelfTestProgram::look([&](const weft_window& window) { keep(backend->texture_render(texture, &window)); },
                                  end);
        else
            SelfTestProgram::look_at_spots(
                use, [&](const weft_batch& batch) { keep(backend->texture_sample(texture, &batch)); }, end);
        backend->texture_close(texture);
    }
    backend->device_close(device);
    if (status == WEFT_OK) write(values);
    return status != WEFT_OK;
}
