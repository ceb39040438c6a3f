/// The only door between C and C++: runs a body, and turns whatever it throws into a status and a sentence.
#pragma once
#include "base/error.h"
#include "base/float_environment.h"
#include <new>
#include <string_view>

namespace weft {

/// Sentences from layers that do not know which function was called get its name in front.
inline weft_status fail(weft_status status, const char* function, const char* sentence) noexcept
{
    if (std::string_view(sentence).substr(0, 5) == "weft_") return set_last_message(status, sentence);
    return set_last_message(status, Sentence(function, ": ", sentence).c_str());
}

template <class Body> weft_status guard(const char* function, Body&& body) noexcept
{
    try {
        const Float_environment defaults;
        body();
        return WEFT_OK;
    } catch (const Error& error) {
        return fail(error.status(), function, error.what());
    } catch (const std::bad_alloc&) {
        return fail(WEFT_ERROR_MEMORY, function, "out of memory");
    } catch (const std::exception& error) {
        return fail(WEFT_ERROR_INTERNAL, function, error.what());
    } catch (...) {
        return fail(WEFT_ERROR_INTERNAL, function, "an unknown exception");
    }
}

} // namespace weft
