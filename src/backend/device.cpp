/// Calls into a backend: one at a time where the contract says so, statuses turned into errors.
#include "backend/device.h"
#include "base/error.h"

namespace weft {

namespace {

void check(weft_status status, const char* function, const weft_device_info& device)
{
    if (status == WEFT_OK) return;
    const char* sentence = backend_sentence();
    if (!*sentence) sentence = status_name(status);
    const bool known = status < 0 && status >= WEFT_ERROR_INTERNAL;
    throw Error(known ? status : WEFT_ERROR_INTERNAL, function, ": the device ", device.name, " failed: ", sentence);
}

} // namespace

Device::Device(Memory& memory, const Device_choice& choice, const char* function) : choice_(choice), host_(memory)
{
    limits_.size = sizeof limits_;
    clear_backend_sentence();
    check(choice_.backend.device_open(host_.table(), choice_.index, &limits_, &handle_), function, choice_.info);
}

Device::~Device()
{
    if (handle_) choice_.backend.device_close(handle_);
}

void Device::enter() noexcept
{
    if (limits_.concurrency == 0) return;
    std::unique_lock lock(mutex_);
    left_.wait(lock, [&] { return calls_ < limits_.concurrency; });
    ++calls_;
}

void Device::leave() noexcept
{
    if (limits_.concurrency == 0) return;
    {
        const std::lock_guard lock(mutex_);
        --calls_;
    }
    left_.notify_one();
}

Opened::~Opened()
{
    if (!handle_) return;
    const std::lock_guard lock(device_->opening_);
    device_->choice_.backend.texture_close(handle_);
}

bool Opened::open(Device& device, const weft_program& program, const char* function)
{
    const std::lock_guard lock(device.opening_);
    clear_backend_sentence();
    const weft_status status = device.choice_.backend.texture_open(device.handle_, &program, &handle_);
    if (status != WEFT_OK) handle_ = nullptr;
    if (status == WEFT_ERROR_UNSUPPORTED) return false;
    check(status, function, device.info());
    device_ = &device;
    return true;
}

void Opened::render(const weft_window& window, const char* function) const
{
    clear_backend_sentence();
    device_->enter();
    const weft_status status = device_->choice_.backend.texture_render(handle_, &window);
    device_->leave();
    check(status, function, device_->info());
}

void Opened::sample(const weft_batch& batch, const char* function) const
{
    clear_backend_sentence();
    device_->enter();
    const weft_status status = device_->choice_.backend.texture_sample(handle_, &batch);
    device_->leave();
    check(status, function, device_->info());
}

} // namespace weft
