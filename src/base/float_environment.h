/// Round to nearest, denormals kept, no traps: whatever the host program has set, while this object lives.
#pragma once
#if defined(__SSE__) || defined(__x86_64__)
#include <xmmintrin.h>
#elif !defined(__aarch64__)
#include <cfenv>
#endif
#include <cstdint>

namespace weft {

/// The arithmetic contract is one of IEEE 754's defaults; a host linked with fast-math objects flushes denormals.
class Float_environment {
public:
    Float_environment(const Float_environment&) = delete;
    Float_environment& operator=(const Float_environment&) = delete;

#if defined(__SSE__) || defined(__x86_64__)
    Float_environment() noexcept : before_(_mm_getcsr()) { _mm_setcsr(all_masked); }
    ~Float_environment() { _mm_setcsr(before_); }

private:
    static constexpr unsigned all_masked = 0x1f80; ///< the value at reset: nearest, no FTZ, no DAZ, every trap masked
    unsigned before_;
#elif defined(__aarch64__)
    Float_environment() noexcept
    {
        __asm__ volatile("mrs %0, fpcr" : "=r"(before_));
        __asm__ volatile("msr fpcr, %0" : : "r"(std::uint64_t{0}));
    }
    ~Float_environment() { __asm__ volatile("msr fpcr, %0" : : "r"(before_)); }

private:
    std::uint64_t before_;
#else
    Float_environment() noexcept
    {
        std::fegetenv(&before_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~Float_environment() { std::fesetenv(&before_); }

private:
    std::fenv_t before_;
#endif
};

} // namespace weft
