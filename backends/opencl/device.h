/// The OpenCL devices of this process: found, compiled for and tested once, then kept until the process ends.
#pragma once
#include <CL/cl.h>
#include <cstdint>
#include <weft/backend.h>

namespace weft::opencl {

/// One device with its program. Never released: at process exit the OpenCL libraries may be gone before we are.
struct Device {
    cl_device_id id = nullptr;
    cl_context context = nullptr;
    cl_program program = nullptr;
    cl_ulong largest_buffer = 0; ///< bytes
    bool cpu = false;            ///< windows by rows of blocks; else pixel by pixel
    bool exact = false;
    weft_status status = WEFT_OK;
    char description[128] = {}; ///< of the device, or why it cannot be used
};

/// 0 without a loader's ICD, a platform or a device.
std::uint32_t device_count() noexcept;

/// The first call for an index compiles its program and runs the self-test; `index` < device_count().
const Device& device(std::uint32_t index) noexcept;

} // namespace weft::opencl
