/// The loader of plug-ins: what is checked, in which order, and what is said.
#include "backend/plugin.h"
#include "base/error.h"
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <dlfcn.h>

namespace weft {

namespace {

constexpr char prefix[] = "weft_backend_", suffix[] = ".so";
constexpr char symbol[] = "weft_backend_v0";
static_assert(WEFT_BACKEND_MAJOR == 0, "the symbol's number is the major version");

[[noreturn]] void refuse(const char* sentence) { throw Error(WEFT_ERROR_DEVICE, sentence); }

bool is_name(const std::string& name)
{
    const auto good = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
    return !name.empty() && name.size() <= 31 && std::all_of(name.begin(), name.end(), good);
}

bool has_hole(const weft_backend& table)
{
    return !table.device_count || !table.device_info || !table.device_open || !table.device_close ||
           !table.texture_open || !table.texture_render || !table.texture_sample || !table.texture_close;
}

} // namespace

std::string plugin_name(const std::string& path)
{
    const std::string file = path.substr(path.rfind('/') + 1);
    const std::size_t around = sizeof prefix - 1 + sizeof suffix - 1;
    if (file.size() <= around || file.compare(0, sizeof prefix - 1, prefix) != 0 ||
        file.compare(file.size() - (sizeof suffix - 1), std::string::npos, suffix) != 0)
        return {};
    std::string name = file.substr(sizeof prefix - 1, file.size() - around);
    if (!is_name(name)) name.clear();
    return name;
}

weft_backend adopt(const weft_backend& theirs, const std::string& name)
{
    // magic, size, major and minor sit at the same place in every version there will ever be.
    if (theirs.magic != WEFT_BACKEND_MAGIC) refuse("its table does not begin with the magic number");
    if (theirs.major != WEFT_BACKEND_MAJOR)
        throw Error(WEFT_ERROR_UNSUPPORTED, "it speaks ABI ", theirs.major, ", this libweft speaks ",
                    WEFT_BACKEND_MAJOR);
    constexpr std::size_t first_release = offsetof(weft_backend, texture_close) + sizeof theirs.texture_close;
    if (theirs.size < first_release)
        throw Error(WEFT_ERROR_DEVICE, "its table is ", theirs.size, " bytes, shorter than ABI ", WEFT_BACKEND_MAJOR,
                    ".1");
    weft_backend ours{};
    std::memcpy(&ours, &theirs, std::min<std::size_t>(theirs.size, sizeof ours));
    ours.size = sizeof ours;
    if (!ours.name || name != ours.name) refuse("its name is not that of its file");
    if (has_hole(ours)) refuse("its table has a hole");
    return ours;
}

weft_backend load_plugin(const std::string& path)
{
    if (path.empty() || path[0] != '/') refuse("its path is not absolute");
    const std::string name = plugin_name(path);
    if (name.empty()) refuse("its file is not called weft_backend_<name>.so");
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!library) {
        const char* why = dlerror();
        refuse(why ? why : "it cannot be loaded");
    }
    const void* table = dlsym(library, symbol);
    if (!table) throw Error(WEFT_ERROR_DEVICE, "it exports no ", symbol);
    return adopt(*static_cast<const weft_backend*>(table), name);
}

} // namespace weft
