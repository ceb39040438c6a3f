/// The threads of the pool.
#include "base/pool.h"
#include <atomic>
#include <csignal>
#include <new>
#include <system_error>
#include <unistd.h>

namespace weft {

struct Pool::Job {
    std::uint32_t count;
    Task task;
    void* argument;
    std::atomic<std::uint32_t> next{0};

    void work() noexcept
    {
        for (;;) {
            const std::uint32_t i = next.fetch_add(1, std::memory_order_relaxed);
            if (i >= count) return;
            task(argument, i);
        }
    }
};

Pool::Pool(std::uint32_t threads) : process_(getpid()), wanted_((threads < most_threads ? threads : most_threads) - 1)
{
}

Pool::~Pool()
{
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    work_.notify_all();
    for (std::uint32_t i = 0; i < count_; ++i) threads_[i].join();
    delete[] threads_;
}

/// As many threads as can be had; none is no error, since the caller works too. They take no signals.
void Pool::start() noexcept
{
    started_ = true;
    threads_ = new (std::nothrow) std::thread[wanted_];
    if (!threads_) return;
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    try {
        while (count_ < wanted_) {
            threads_[count_] = std::thread([this] { serve(); });
            ++count_;
        }
    } catch (const std::system_error&) {
    } catch (const std::bad_alloc&) {
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

void Pool::serve() noexcept
{
    std::uint64_t seen = 0;
    std::unique_lock lock(mutex_);
    for (;;) {
        work_.wait(lock, [&] { return stop_ || (job_ && number_ != seen); });
        if (stop_) return;
        seen = number_;
        Job& job = *job_;
        ++working_;
        lock.unlock();
        job.work();
        lock.lock();
        if (--working_ == 0) done_.notify_one();
    }
}

void Pool::run(std::uint32_t count, Task task, void* argument) noexcept
{
    Job job{count, task, argument};
    if (count < 2 || busy_.exchange(true, std::memory_order_acquire)) {
        job.work();
        return;
    }
    if (!started_) start();
    {
        const std::lock_guard lock(mutex_);
        job_ = &job;
        ++number_;
    }
    if (count - 1 < count_)
        for (std::uint32_t i = 1; i < count; ++i) work_.notify_one();
    else
        work_.notify_all();
    job.work();
    {
        std::unique_lock lock(mutex_);
        job_ = nullptr; // nobody enters any more
        done_.wait(lock, [&] { return working_ == 0; });
    }
    busy_.store(false, std::memory_order_release);
}

} // namespace weft
