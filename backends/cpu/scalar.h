/// The built-in backend "scalar": the reference that every exact device equals.
#pragma once
#include <weft/backend.h>

namespace weft {

const weft_backend& scalar_backend() noexcept;

} // namespace weft
