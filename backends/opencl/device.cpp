/// Finding devices, compiling the program for them, and asking them what `exact` needs.
#include "opencl/device.h"
#include "opencl/handle.h"
#include "opencl/self_test.h"
#include <algorithm>
#include <mutex>

namespace weft::opencl {

extern const unsigned program_parts; // made by embed.cmake
extern const char* program_source[]; // not constant, since clCreateProgramWithSource could change it

namespace {

constexpr cl_uint most_devices = 16;

// Static storage without destructors: nothing of this runs when the process ends.
std::once_flag found;
cl_uint found_count = 0;
Device devices[most_devices];
std::once_flag prepared[most_devices];

void find_devices(cl_device_type type)
{
    cl_platform_id platforms[most_devices];
    cl_uint platform_count = 0;
    if (clGetPlatformIDs(most_devices, platforms, &platform_count) != CL_SUCCESS) return;
    platform_count = std::min(platform_count, most_devices);
    for (cl_uint i = 0; i < platform_count; ++i) {
        cl_device_id ids[most_devices];
        cl_uint count = 0;
        if (clGetDeviceIDs(platforms[i], type, most_devices, ids, &count) != CL_SUCCESS) continue;
        count = std::min(count, most_devices);
        for (cl_uint j = 0; j < count && found_count < most_devices; ++j) {
            devices[found_count].id = ids[j];
            devices[found_count].cpu = type == CL_DEVICE_TYPE_CPU;
            ++found_count;
        }
    }
}

template <class Value> Value property(cl_device_id id, cl_device_info name)
{
    Value value = {};
    clGetDeviceInfo(id, name, sizeof value, &value, nullptr); // an unknown property stays zero
    return value;
}

void set_description(Device& device, std::string_view text) noexcept
{
    device.description[text.copy(device.description, sizeof device.description - 1)] = '\0';
}

void describe(Device& device, const char* remark) noexcept
{
    char name[96] = "?";
    clGetDeviceInfo(device.id, CL_DEVICE_NAME, sizeof name - 1, name, nullptr);
    const Failure text(WEFT_OK, std::string_view(name), ", ", property<cl_uint>(device.id, CL_DEVICE_MAX_COMPUTE_UNITS),
                       " compute units", remark);
    set_description(device, text.what());
}

void compile(Device& device, bool correctly_rounded)
{
    cl_int code = CL_SUCCESS;
    device.context = clCreateContext(nullptr, 1, &device.id, nullptr, nullptr, &code);
    check(code, "clCreateContext");
    device.program = clCreateProgramWithSource(device.context, program_parts, program_source, nullptr, &code);
    check(code, "clCreateProgramWithSource");
    // No definitions: caches of compiled programs need not see them. No licence to change the arithmetic either.
    // -w: some compilers print that functions are not used.
    const char* options =
        correctly_rounded ? "-w -cl-std=CL1.2 -cl-fp32-correctly-rounded-divide-sqrt" : "-w -cl-std=CL1.2";
    check(clBuildProgram(device.program, 1, &device.id, options, nullptr, nullptr), "clBuildProgram");
}

void prepare(Device& device) noexcept
{
    try {
        if (!property<cl_bool>(device.id, CL_DEVICE_AVAILABLE) ||
            !property<cl_bool>(device.id, CL_DEVICE_COMPILER_AVAILABLE) ||
            !property<cl_bool>(device.id, CL_DEVICE_ENDIAN_LITTLE))
            throw Failure(WEFT_ERROR_UNSUPPORTED,
                          "opencl: the device is not available, has no compiler or is big-endian");
        const auto arithmetic = property<cl_device_fp_config>(device.id, CL_DEVICE_SINGLE_FP_CONFIG);
        constexpr cl_device_fp_config needed =
            CL_FP_ROUND_TO_NEAREST | CL_FP_DENORM | CL_FP_FMA | CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT;
        device.largest_buffer = property<cl_ulong>(device.id, CL_DEVICE_MAX_MEM_ALLOC_SIZE);
        compile(device, (arithmetic & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) != 0);
        const float difference = largest_difference(device);
        device.exact = difference == 0.0f && (arithmetic & needed) == needed;
        if (device.exact)
            describe(device, "");
        else
            describe(device, Failure(WEFT_OK, "; differs by up to ", difference).what());
    } catch (const Failure& failure) {
        device.status = failure.status();
        set_description(device, failure.what());
    } catch (const std::exception&) {
        device.status = WEFT_ERROR_MEMORY;
        describe(device, ": no memory");
    }
}

} // namespace

std::uint32_t device_count() noexcept
{
    std::call_once(found, [] {
        constexpr cl_device_type best_first[] = {CL_DEVICE_TYPE_GPU, CL_DEVICE_TYPE_ACCELERATOR, CL_DEVICE_TYPE_CPU};
        for (const cl_device_type type : best_first) find_devices(type);
    });
    return found_count;
}

const Device& device(std::uint32_t index) noexcept
{
    std::call_once(prepared[index], [index] { prepare(devices[index]); });
    return devices[index];
}

} // namespace weft::opencl
