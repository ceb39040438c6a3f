/// An opened device, and programs opened on it: RAII and errors over a backend's table.
#pragma once
#include "backend/host.h"
#include "backend/registry.h"
#include <condition_variable>
#include <mutex>

namespace weft {

class Device {
public:
    Device(Memory& memory, const Device_choice& choice, const char* function);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    const weft_device_info& info() const noexcept { return choice_.info; }
    const weft_device_limits& limits() const noexcept { return limits_; }

private:
    friend class Opened;
    void enter() noexcept; ///< waits until fewer than `concurrency` calls are under way
    void leave() noexcept;

    Device_choice choice_;
    Host host_;
    weft_device_limits limits_{};
    weft_backend_device* handle_ = nullptr;
    std::mutex opening_; ///< of textures: one call at a time

    std::mutex mutex_;
    std::condition_variable left_;
    std::uint32_t calls_ = 0; ///< under way; counted only if there is a limit
};

/// A program opened on a device, which outlives it, as does the program.
class Opened {
public:
    Opened() = default;
    ~Opened();
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;

    /// False: the device answers UNSUPPORTED. Any other failure is thrown, behind `function`.
    bool open(Device& device, const weft_program& program, const char* function);
    const Device& device() const noexcept { return *device_; }

    void render(const weft_window& window, const char* function) const;
    void sample(const weft_batch& batch, const char* function) const;

private:
    Device* device_ = nullptr;
    weft_backend_texture* handle_ = nullptr;
};

} // namespace weft
