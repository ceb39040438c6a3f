/// Where plug-ins lie.
#pragma once
#include <string>
#include <vector>

namespace weft {

/// Paths to load, in order: every weft_backend_*.so of weft-<major>/ beside libweft, or, if WEFT_BACKEND_PATH is set
/// (and the process not privileged), of the directories that it lists instead, separated by colons. A directory that is
/// not absolute is handed back as it is, to be refused.
std::vector<std::string> find_plugins();

} // namespace weft
