/// Queues, kernels and buffers.
#include "opencl/workspace.h"

namespace weft::opencl {

cl_mem Scratch::get(cl_context context, std::size_t bytes)
{
    if (bytes <= bytes_) return buffer_.get();
    buffer_ = Buffer();
    bytes_ = 0;
    cl_int code = CL_SUCCESS;
    buffer_ = Buffer(clCreateBuffer(context, CL_MEM_READ_WRITE, bytes, nullptr, &code));
    check(code, "clCreateBuffer");
    bytes_ = bytes;
    return buffer_.get();
}

Task::Task(cl_program program, const char* name)
{
    cl_int code = CL_SUCCESS;
    kernel_ = Kernel(clCreateKernel(program, name, &code));
    check(code, "clCreateKernel");
}

namespace {

Queue new_queue(const Device& device)
{
    cl_int code = CL_SUCCESS;
    Queue queue(clCreateCommandQueue(device.context, device.id, 0, &code)); // in order
    check(code, "clCreateCommandQueue");
    return queue;
}

} // namespace

Workspace::Workspace(const Device& device, std::pmr::memory_resource* memory)
    : queue(new_queue(device)), splat_gather(device.program, "splat_gather"),
      tile_gather(device.program, "tile_gather"), tile_composed(device.program, "tile_composed"),
      surface_gather(device.program, "surface_gather"), lattice_gather(device.program, "lattice_gather"),
      lattice_solid(device.program, "lattice_solid"), lattice_pyramid(device.program, "lattice_pyramid"),
      layer_sum(device.program, "layer_sum"), splat_bands{Task(device.program, "splat_bands_1"),
                                                          Task(device.program, "splat_bands_2"),
                                                          Task(device.program, "splat_bands_4"),
                                                          Task(device.program, "splat_bands_6")},
      impacts(memory)
{
}

} // namespace weft::opencl
