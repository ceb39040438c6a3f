/// libweft's own threads: one fork-join job at a time, on which the caller works too.
#pragma once
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <sys/types.h>
#include <thread>

namespace weft {

class Pool {
public:
    using Task = void (*)(void* argument, std::uint32_t i) noexcept;

    explicit Pool(std::uint32_t threads); ///< `threads` counts the caller; starts no thread yet
    ~Pool();                              ///< joins; only in the process that made it, and while no job runs
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    pid_t process() const noexcept { return process_; }

    /// Runs task(argument, i) for all i < count. If another job is under way (another caller's, or the one that this
    /// call is nested in), runs them all on the calling thread: so there is no queue, and nothing can wait in a circle.
    void run(std::uint32_t count, Task task, void* argument) noexcept;

private:
    static constexpr std::uint32_t most_threads = 1024;
    struct Job;
    void start() noexcept;
    void serve() noexcept;

    const pid_t process_;
    const std::uint32_t wanted_;
    std::atomic<bool> busy_{false};
    bool started_ = false; ///< guarded by busy_

    std::mutex mutex_;
    std::condition_variable work_, done_;
    Job* job_ = nullptr;        ///< guarded by mutex_, like the rest
    std::uint64_t number_ = 0;  ///< of the job: a thread never takes one twice
    std::uint32_t working_ = 0; ///< threads inside the job
    bool stop_ = false;

    std::uint32_t count_ = 0;
    std::thread* threads_ = nullptr;
};

} // namespace weft
