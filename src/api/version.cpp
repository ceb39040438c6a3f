/// weft_version, weft_status_name, weft_error_message.
#include "base/error.h"

uint32_t weft_version(void) noexcept { return WEFT_VERSION_MAJOR << 16 | WEFT_VERSION_MINOR << 8 | WEFT_VERSION_PATCH; }

const char* weft_status_name(weft_status status) noexcept { return weft::status_name(status); }

const char* weft_error_message(void) noexcept { return weft::last_message(); }
