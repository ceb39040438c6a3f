/// This thread's last sentence.
#include "base/error.h"

namespace weft {

namespace {
thread_local char message[256] = "no error"; // a plain array: nothing to destroy when a thread ends
}

const char* status_name(weft_status status) noexcept
{
    static constexpr const char* names[] = {
        "WEFT_OK",           "WEFT_ERROR_ARGUMENT",    "WEFT_ERROR_MEMORY", "WEFT_ERROR_CANCELLED",
        "WEFT_ERROR_FORMAT", "WEFT_ERROR_UNSUPPORTED", "WEFT_ERROR_DEVICE", "WEFT_ERROR_INTERNAL"};
    return status <= 0 && status >= WEFT_ERROR_INTERNAL ? names[-status] : "no status of libweft";
}

const char* last_message() noexcept { return message; }

weft_status set_last_message(weft_status status, const char* sentence) noexcept
{
    std::size_t n = 0;
    while (n < sizeof message - 1 && sentence[n]) {
        message[n] = sentence[n];
        ++n;
    }
    message[n] = 0;
    return status;
}

} // namespace weft
