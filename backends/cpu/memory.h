/// Memory from the host, owned. Nothing is constructed: for plain data only.
#pragma once
#include <weft/backend.h>

namespace weft {

template <class T> class Buffer {
public:
    Buffer() = default;
    explicit Buffer(const weft_host* host) : host_(host) {}
    ~Buffer() { release(); }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    void use(const weft_host* host) { host_ = host; }
    T* data() const { return data_; }
    size_t size() const { return size_; }

    /// At least `size` elements, contents unspecified; false: no memory, and the old ones are kept.
    bool reserve(size_t size)
    {
        if (size <= size_) return true;
        T* data = allocate(size);
        if (!data) return false;
        release();
        data_ = data;
        size_ = size;
        return true;
    }

    /// The same, but the first `kept` elements stay.
    bool grow(size_t size, size_t kept)
    {
        T* data = allocate(size);
        if (!data) return false;
        for (size_t i = 0; i < kept; ++i) data[i] = data_[i];
        release();
        data_ = data;
        size_ = size;
        return true;
    }

private:
    static constexpr size_t alignment = 64;

    T* allocate(size_t size) const
    {
        if (size > SIZE_MAX / 2 / sizeof(T)) return nullptr;
        return static_cast<T*>(host_->allocate(host_->self, size * sizeof(T), alignment));
    }

    void release()
    {
        if (data_) host_->deallocate(host_->self, data_, size_ * sizeof(T), alignment);
        data_ = nullptr;
        size_ = 0;
    }

    const weft_host* host_ = nullptr;
    T* data_ = nullptr;
    size_t size_ = 0;
};

} // namespace weft
