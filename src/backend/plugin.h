/// Path -> checked table, or an Error whose sentence says why it was refused.
#pragma once
#include <string>
#include <weft/backend.h>

namespace weft {

/// `name` of ".../weft_backend_<name>.so"; empty if the file is called otherwise.
std::string plugin_name(const std::string& path);

/// Loads the file, for ever, and judges it. Nothing of it but its constructors has run when this returns.
weft_backend load_plugin(const std::string& path);

/// A table, checked: unknown tail cut off, absent tail zero, every required entry present.
weft_backend adopt(const weft_backend& theirs, const std::string& name);

} // namespace weft
