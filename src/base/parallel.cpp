/// Fork and join: exceptions brought home, float environment set, pool made anew after a fork.
#include "base/parallel.h"
#include "base/float_environment.h"
#include "base/pool.h"
#include <exception>
#include <memory>
#include <mutex>
#include <sched.h>
#include <unistd.h>

namespace weft {

std::uint32_t available_threads() noexcept
{
#ifdef __linux__
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0 && CPU_COUNT(&set) > 0)
        return static_cast<std::uint32_t>(CPU_COUNT(&set));
#endif
    const long online = sysconf(_SC_NPROCESSORS_ONLN);
    return online > 0 ? static_cast<std::uint32_t>(online) : 1;
}

namespace {

struct Bodies {
    explicit Bodies(const std::function<void(std::uint32_t)>& each) noexcept : body(each) {}

    const std::function<void(std::uint32_t)>& body;
    std::atomic<bool> failed{false};
    std::mutex mutex;
    std::exception_ptr first;

    static void run(void* self, std::uint32_t i) noexcept
    {
        auto& bodies = *static_cast<Bodies*>(self);
        if (bodies.failed.load(std::memory_order_relaxed)) return;
        try {
            const Float_environment defaults;
            bodies.body(i);
        } catch (...) {
            const std::lock_guard lock(bodies.mutex);
            if (!bodies.failed.exchange(true, std::memory_order_relaxed)) bodies.first = std::current_exception();
        }
    }
};

/// What weft_executor's C type wants; the table's own functions throw nothing.
void run_body(void* argument, std::uint32_t i) { Bodies::run(argument, i); }

} // namespace

Parallel::Parallel(std::uint32_t threads, const weft_executor* executor) noexcept
    : threads_(threads ? threads : available_threads())
{
    if (executor) executor_ = *executor;
}

Parallel::~Parallel()
{
    Pool* pool = pool_.load(std::memory_order_acquire);
    if (pool && pool->process() == getpid()) delete pool;
}

/// A child of fork() has none of its parent's threads, and perhaps a locked mutex: the parent's pool is left alone.
Pool* Parallel::pool()
{
    Pool* current = pool_.load(std::memory_order_acquire);
    while (!current || current->process() != getpid()) {
        auto fresh = std::make_unique<Pool>(threads_);
        if (pool_.compare_exchange_strong(current, fresh.get(), std::memory_order_acq_rel)) return fresh.release();
    }
    return current;
}

void Parallel::for_each_index(std::uint32_t count, const std::function<void(std::uint32_t)>& body)
{
    if (count == 0) return;
    Bodies bodies{body};
    if (executor_.run && count > 1)
        executor_.run(executor_.user, count, run_body, &bodies);
    else if (!executor_.run && threads_ > 1 && count > 1)
        pool()->run(count, Bodies::run, &bodies);
    else
        for (std::uint32_t i = 0; i < count; ++i) Bodies::run(&bodies, i);
    if (bodies.first) std::rethrow_exception(bodies.first);
}

} // namespace weft
