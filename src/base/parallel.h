/// Fork and join over an index: libweft's own pool, or the caller's executor, or the calling thread alone.
#pragma once
#include <weft/weft.h>
#include <cstdint>
#include <functional>
#include <memory>

namespace weft {

/// How many threads this process may run on (its affinity mask, not the machine's count).
std::uint32_t available_threads() noexcept;

class Parallel {
public:
    Parallel(std::uint32_t threads, const weft_executor* executor); ///< 0: available_threads(); NULL: own pool
    ~Parallel();
    Parallel(const Parallel&) = delete;
    Parallel& operator=(const Parallel&) = delete;

    /// How many bodies may run at once; a hint for cutting up work that never changes a result.
    std::uint32_t width() const noexcept;

    /// Runs body(i) once for every i < count and returns when all are done. The first exception is thrown here, on the
    /// calling thread; bodies not yet begun are then skipped. Calls may nest and may come from several threads at once.
    void for_each_index(std::uint32_t count, const std::function<void(std::uint32_t)>& body);

private:
    struct Pool;
    std::unique_ptr<Pool> pool_; ///< its threads start at the first call that has work for them; anew after fork()
    weft_executor executor_{};
    std::uint32_t threads_;
};

} // namespace weft
