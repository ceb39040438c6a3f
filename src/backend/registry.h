/// The process's list of backends and their devices, usable ones and refused ones.
#pragma once
#include <deque>
#include <mutex>
#include <string>
#include <weft/backend.h>

namespace weft {

/// A device that can be opened.
struct Device_choice {
    weft_backend backend{};
    std::uint32_t index = 0;
    weft_device_info info{};
};

class Registry {
public:
    static Registry& instance(); ///< found and judged once, at the first call

    std::uint32_t device_count();
    weft_device_info device(std::uint32_t index);
    void load(const std::string& path); ///< throws why it is refused; it is listed all the same

    /// "simd:avx2": that one; "simd": its best; NULL: the best exact device of the CPU. Errors begin with `function`.
    Device_choice choose(const char* name, const char* function);
    Device_choice scalar();

private:
    struct Backend {
        std::string name, path;
        weft_backend table{}; ///< all zero if refused
        weft_status status = WEFT_OK;
        std::string sentence; ///< why it was refused
        std::uint32_t devices = 0;
        bool counted = false;
    };
    Registry();
    void add(const std::string& path);
    Backend* find(const std::string& name);
    static std::uint32_t count(Backend& backend);
    static weft_device_info info(Backend& backend, std::uint32_t index);
    static bool first_usable(Backend& backend, bool exact, Device_choice& choice);
    [[noreturn]] void fail(const char* name, const char* function);

    std::mutex mutex_;
    std::deque<Backend> backends_;
};

} // namespace weft
