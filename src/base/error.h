/// The one exception of libweft: a status and a sentence that names the function, the argument and the number.
#pragma once
#include <charconv>
#include <cstdint>
#include <cstring>
#include <exception>
#include <string_view>
#include <type_traits>
#include <weft/weft.h>

namespace weft {

/// A sentence of at most 255 bytes, put together without allocation and without regard to the locale.
class Sentence {
public:
    template <class... Parts> explicit Sentence(const Parts&... parts) noexcept { (append(parts), ...); }
    const char* c_str() const noexcept { return text_; }

private:
    void append(std::string_view part) noexcept
    {
        const std::size_t n = part.size() < room() ? part.size() : room();
        std::memcpy(text_ + length_, part.data(), n);
        length_ += n;
    }
    template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>> void append(Number number) noexcept
    {
        const auto end = std::to_chars(text_ + length_, text_ + length_ + room(), number);
        if (end.ec == std::errc()) length_ = static_cast<std::size_t>(end.ptr - text_);
    }
    std::size_t room() const noexcept { return sizeof text_ - 1 - length_; }

    char text_[256] = {};
    std::size_t length_ = 0;
};

class Error : public std::exception {
public:
    template <class... Parts>
    explicit Error(weft_status status, const Parts&... parts) noexcept : status_(status), sentence_(parts...)
    {
    }
    weft_status status() const noexcept { return status_; }
    const char* what() const noexcept override { return sentence_.c_str(); }

private:
    weft_status status_;
    Sentence sentence_;
};

/// Throws WEFT_ERROR_ARGUMENT with the sentence that the parts make, unless `good`.
template <class... Parts> void require(bool good, const Parts&... parts)
{
    if (!good) throw Error(WEFT_ERROR_ARGUMENT, parts...);
}

const char* status_name(weft_status status) noexcept; ///< "WEFT_OK", ...

/// This thread's last sentence, for weft_error_message.
const char* last_message() noexcept;
weft_status set_last_message(weft_status status, const char* sentence) noexcept; ///< returns `status`

} // namespace weft
