/// The directories of plug-ins: never the working directory, never one that another variable names.
#include "backend/search.h"
#include <algorithm>
#include <cstdlib>
#include <dirent.h>
#include <dlfcn.h>
#include <memory>
#include <weft/weft.h>

namespace weft {

namespace {

struct Free {
    void operator()(char* memory) const noexcept { std::free(memory); }
    void operator()(DIR* directory) const noexcept { closedir(directory); }
};

std::string real_path(const char* path)
{
    const std::unique_ptr<char, Free> real(realpath(path, nullptr));
    return real ? real.get() : "";
}

/// The directory of the object that holds this function: libweft.so, or the program that it is linked into.
std::string own_directory()
{
    Dl_info info;
    if (dladdr(reinterpret_cast<const void*>(&find_plugins), &info) == 0 || !info.dli_fname) return {};
    const bool absolute = info.dli_fname[0] == '/';
    // A name that is not absolute is how the program was called, which need not be where it lies.
    const std::string file = real_path(absolute ? info.dli_fname : "/proc/self/exe");
    return file.substr(0, file.rfind('/') + 1);
}

void list(const std::string& directory, std::vector<std::string>& paths)
{
    const std::unique_ptr<DIR, Free> open(opendir(directory.c_str()));
    if (!open) return;
    std::vector<std::string> found;
    while (const dirent* entry = readdir(open.get())) {
        const std::string file = entry->d_name;
        if (file.compare(0, 13, "weft_backend_") == 0 && file.size() > 3 &&
            file.compare(file.size() - 3, 3, ".so") == 0)
            found.push_back(directory + (directory.back() == '/' ? "" : "/") + file);
    }
    std::sort(found.begin(), found.end());
    paths.insert(paths.end(), found.begin(), found.end());
}

#define WEFT_TEXT_OF(number) #number
#define WEFT_TEXT(number) WEFT_TEXT_OF(number)
constexpr char plugin_directory[] = "weft-" WEFT_TEXT(WEFT_VERSION_MAJOR);

} // namespace

std::vector<std::string> find_plugins()
{
    std::vector<std::string> paths;
    const char* instead = secure_getenv("WEFT_BACKEND_PATH");
    if (!instead) {
        const std::string own = own_directory();
        if (!own.empty()) list(own + plugin_directory, paths);
        return paths;
    }
    const std::string directories = instead;
    for (std::size_t begin = 0; begin < directories.size();) {
        const std::size_t end = std::min(directories.find(':', begin), directories.size());
        const std::string directory = directories.substr(begin, end - begin);
        if (!directory.empty() && directory[0] == '/')
            list(directory, paths);
        else if (!directory.empty())
            paths.push_back(directory);
        begin = end + 1;
    }
    return paths;
}

} // namespace weft
