/// Arrays of plain numbers, 64-byte aligned, in a memory resource; and the planar pictures made of them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <type_traits>
#include <utility>

namespace weft {

/// A fixed-size array of trivial elements; movable, not copyable; zeroed unless asked otherwise.
template <class T> class Array {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
    enum Fill { zeroed, unset };
    Array() = default;
    Array(std::pmr::memory_resource* memory, std::size_t size, Fill fill = zeroed)
        : memory_(memory), size_(size),
          data_(size ? static_cast<T*>(memory->allocate(bytes_of(size), alignment)) : nullptr)
    {
        if (fill == zeroed)
            for (std::size_t i = 0; i < size; ++i) data_[i] = T{};
    }
    Array(Array&& other) noexcept
        : memory_(other.memory_), size_(std::exchange(other.size_, 0)), data_(std::exchange(other.data_, nullptr))
    {
    }
    Array& operator=(Array&& other) noexcept
    {
        std::swap(memory_, other.memory_);
        std::swap(size_, other.size_);
        std::swap(data_, other.data_);
        return *this;
    }
    ~Array()
    {
        if (data_) memory_->deallocate(data_, bytes_of(size_), alignment);
    }

    T* data() noexcept { return data_; }
    const T* data() const noexcept { return data_; }
    std::size_t size() const noexcept { return size_; }
    bool empty() const noexcept { return size_ == 0; }
    T& operator[](std::size_t i) noexcept { return data_[i]; }
    const T& operator[](std::size_t i) const noexcept { return data_[i]; }
    T* begin() noexcept { return data_; }
    T* end() noexcept { return data_ + size_; }
    const T* begin() const noexcept { return data_; }
    const T* end() const noexcept { return data_ + size_; }

private:
    static constexpr std::size_t alignment = 64;
    static std::size_t bytes_of(std::size_t size); ///< checked: throws Error(WEFT_ERROR_MEMORY) beyond 2^62

    std::pmr::memory_resource* memory_ = nullptr;
    std::size_t size_ = 0;
    T* data_ = nullptr;
};

[[noreturn]] void fail_array_size();

template <class T> std::size_t Array<T>::bytes_of(std::size_t size)
{
    if (size > (std::size_t{1} << 62) / sizeof(T)) fail_array_size();
    return size * sizeof(T);
}

/// `count` planes of height * width floats, one after another, rows packed.
struct Planes {
    std::uint32_t width = 0, height = 0, count = 0;
    Array<float> values;

    Planes() = default;
    Planes(std::pmr::memory_resource* memory, std::uint32_t w, std::uint32_t h, std::uint32_t n,
           Array<float>::Fill fill = Array<float>::zeroed)
        : width(w), height(h), count(n), values(memory, std::size_t{w} * h * n, fill)
    {
    }

    std::size_t area() const noexcept { return std::size_t{width} * height; }
    float* plane(std::size_t c) noexcept { return values.data() + c * area(); }
    const float* plane(std::size_t c) const noexcept { return values.data() + c * area(); }
    float* row(std::size_t c, std::size_t y) noexcept { return plane(c) + y * width; }
    const float* row(std::size_t c, std::size_t y) const noexcept { return plane(c) + y * width; }
};

} // namespace weft
