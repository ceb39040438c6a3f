/// A program on a device: its tables in buffers, and its windows and spots.
#pragma once
#include "opencl/tables.h"
#include "opencl/workspace.h"
#include <condition_variable>
#include <mutex>
#include <optional>

namespace weft::opencl {

/// Calls at once: while the device works for one, the host prepares the next.
constexpr std::uint32_t concurrency = 2;

class Texture {
public:
    /// `device` and `memory` must outlive the texture, `program` is read until it goes.
    Texture(const Device& device, const weft_program& program, std::pmr::memory_resource* memory);

    /// Any number of threads may call; more than `concurrency` at once wait.
    void render(const weft_window& window);
    void sample(const weft_batch& batch);

private:
    void render_part(Workspace& work, const weft_window& part, std::size_t plane);
    void render_in_place(Workspace& work, const SamplesLayout& samples, const weft_window& part, std::size_t plane);
    void sample_part(Workspace& work, const weft_batch& part);
    void evaluate(Workspace& work, const SamplesLayout& samples, const weft_window* window, cl_mem out,
                  const ResultLayout& result);
    void gather(Workspace& work, const SamplesLayout& samples, weft_u32 index, cl_mem field);
    SumsLayout splat_bands(Workspace& work, weft_u32 index, const weft_window& window);
    cl_mem send(Workspace& work, Scratch& scratch, const void* data, std::size_t bytes);
    bool too_large(const weft_window& window) const;
    Buffer upload(const void* data, std::size_t bytes);

    class Lease;

    const Device& device_;
    Tables tables_;
    Buffer layers_, levels_, lattices_, words_, numbers_, texels_;
    std::optional<Workspace> workspaces_[concurrency];
    std::mutex mutex_;
    std::condition_variable returned_;
    bool taken_[concurrency] = {};
};

} // namespace weft::opencl
