/// What one call at a time needs: a queue, kernels with their arguments, buffers that are kept from call to call.
#pragma once
#include "opencl/device.h"
#include "opencl/handle.h"
#include "opencl/impacts.h"
#include <cstddef>

namespace weft::opencl {

/// A buffer that grows and is never copied: its contents last for one call.
class Scratch {
public:
    cl_mem get(cl_context context, std::size_t bytes);

private:
    Buffer buffer_;
    std::size_t bytes_ = 0;
};

/// A kernel of the device's program; its arguments are one thread's at a time.
class Task {
public:
    Task(cl_program program, const char* name);

    /// Sets all arguments and enqueues `global` work-items in groups of `local` along the first axis.
    template <class... Arguments>
    void enqueue(cl_command_queue queue, const std::size_t (&global)[3], std::size_t local,
                 const Arguments&... arguments)
    {
        cl_uint index = 0;
        (check(clSetKernelArg(kernel_.get(), index++, sizeof arguments, &arguments), "clSetKernelArg"), ...);
        const std::size_t group[3] = {local, 1, 1};
        check(clEnqueueNDRangeKernel(queue, kernel_.get(), 3, nullptr, global, group, 0, nullptr, nullptr),
              "clEnqueueNDRangeKernel");
    }

private:
    Kernel kernel_;
};

struct Workspace {
    Workspace(const Device& device, std::pmr::memory_resource* memory);

    Queue queue;
    Task splat_gather, tile_gather, tile_composed, surface_gather, lattice_gather, lattice_solid, lattice_pyramid,
        layer_sum;
    Task splat_bands[4]; ///< of 1, 2, 4 and 6 taps
    Scratch field, sums, lists, bands, spots, frames, out;
    Impacts impacts;
};

} // namespace weft::opencl
