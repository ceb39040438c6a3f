/// OpenCL objects that are released when their owner goes, and errors that name the call and its code.
#pragma once
#include "opencl/host.h"
#include <CL/cl.h>
#include <utility>

namespace weft::opencl {

inline void check(cl_int code, const char* call)
{
    if (code != CL_SUCCESS) throw Failure(WEFT_ERROR_DEVICE, "opencl: ", call, " failed with code ", code);
}

template <class Object, cl_int(CL_API_CALL* release)(Object)> class Handle {
public:
    Handle() = default;
    explicit Handle(Object object) noexcept : object_(object) {}
    Handle(Handle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
    Handle& operator=(Handle&& other) noexcept
    {
        std::swap(object_, other.object_);
        return *this;
    }
    ~Handle()
    {
        if (object_) release(object_);
    }
    Object get() const noexcept { return object_; }

private:
    Object object_ = nullptr;
};

using Queue = Handle<cl_command_queue, clReleaseCommandQueue>;
using Kernel = Handle<cl_kernel, clReleaseKernel>;
using Buffer = Handle<cl_mem, clReleaseMemObject>;

} // namespace weft::opencl
