/// Fork and join over an index: libweft's own pool, or the caller's executor, or the calling thread alone.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <weft/weft.h>

namespace weft {

/// How many threads this process may run on (its affinity mask, not the machine's count).
std::uint32_t available_threads() noexcept;

class Pool;

class Parallel {
public:
    Parallel(std::uint32_t threads, const weft_executor* executor) noexcept; ///< 0: available_threads(); NULL: own pool
    ~Parallel();
    Parallel(const Parallel&) = delete;
    Parallel& operator=(const Parallel&) = delete;

    /// How many bodies may run at once; a hint for cutting up work that never changes a result.
    std::uint32_t width() const noexcept { return threads_; }

    /// Runs body(i) once for every i < count and returns when all are done. The first exception is thrown here, on the
    /// calling thread; bodies not yet begun are then skipped. Calls may nest and may come from several threads at once.
    /// Bodies run in the default float environment, wherever they run.
    void for_each_index(std::uint32_t count, const std::function<void(std::uint32_t)>& body);

private:
    Pool* pool();

    std::atomic<Pool*> pool_{nullptr}; ///< made by the first call that has work for it; anew after fork()
    weft_executor executor_{};
    std::uint32_t threads_;
};

} // namespace weft
