/// What the plug-in asks of libweft, in C++: memory, and the sentence that explains a failure.
#pragma once
#include <charconv>
#include <cstring>
#include <exception>
#include <memory_resource>
#include <new>
#include <string_view>
#include <type_traits>
#include <weft/backend.h>

namespace weft::opencl {

/// A status and a sentence of at most 255 bytes. Thrown inside the plug-in; never crosses its border.
class Failure : public std::exception {
public:
    template <class... Parts> explicit Failure(weft_status status, const Parts&... parts) noexcept : status_(status)
    {
        (append(parts), ...);
    }
    weft_status status() const noexcept { return status_; }
    const char* what() const noexcept override { return text_; }

private:
    void append(std::string_view part) noexcept
    {
        const std::size_t count = part.size() < room() ? part.size() : room();
        std::memcpy(text_ + length_, part.data(), count);
        length_ += count;
    }
    template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>> void append(Number number) noexcept
    {
        const auto end = std::to_chars(text_ + length_, text_ + length_ + room(), number);
        if (end.ec == std::errc()) length_ = static_cast<std::size_t>(end.ptr - text_);
    }
    std::size_t room() const noexcept { return sizeof text_ - 1 - length_; }

    weft_status status_;
    char text_[256] = {};
    std::size_t length_ = 0;
};

/// The host's allocator.
class Memory final : public std::pmr::memory_resource {
public:
    explicit Memory(const weft_host* host) noexcept : host_(host) {}

private:
    void* do_allocate(std::size_t bytes, std::size_t alignment) override
    {
        if (void* memory = host_->allocate(host_->self, bytes, alignment)) return memory;
        throw std::bad_alloc();
    }
    void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override
    {
        host_->deallocate(host_->self, memory, bytes, alignment);
    }
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }

    const weft_host* host_;
};

} // namespace weft::opencl
