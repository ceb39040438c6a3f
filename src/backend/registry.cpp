/// The list of backends. Devices are counted only when asked for: some take a while to count theirs.
#include "backend/registry.h"
#include "backend/plugin.h"
#include "backend/search.h"
#include "base/error.h"
#include "cpu/scalar.h"
#include <algorithm>
#include <atomic>
#include <cstring>
#include <memory>

namespace weft {

namespace {

std::atomic<Registry*> registry{nullptr}; // never destroyed: plug-ins are never unloaded, and threads may outlive main
std::mutex making;

void copy_text(char* to, std::size_t size, const std::string& text)
{
    const std::size_t n = std::min(size - 1, text.size());
    std::memcpy(to, text.data(), n);
    to[n] = 0;
}

} // namespace

Registry& Registry::instance()
{
    if (Registry* made = registry.load(std::memory_order_acquire)) return *made;
    const std::lock_guard lock(making);
    if (!registry.load(std::memory_order_relaxed))
        registry.store(std::unique_ptr<Registry>(new Registry).release(), std::memory_order_release);
    return *registry.load(std::memory_order_relaxed);
}

Registry::Registry()
{
    Backend& scalar = backends_.emplace_back();
    scalar.name = "scalar";
    scalar.table = adopt(scalar_backend(), scalar.name);
    for (const std::string& path : find_plugins()) {
        try {
            add(path);
        } catch (const Error&) { // listed with its sentence
        }
    }
}

Registry::Backend* Registry::find(const std::string& name)
{
    for (Backend& backend : backends_)
        if (backend.name == name && backend.status == WEFT_OK) return &backend;
    return nullptr;
}

void Registry::add(const std::string& path)
{
    Backend fresh;
    fresh.path = path;
    fresh.name = plugin_name(path);
    if (fresh.name.empty()) fresh.name = path.substr(path.rfind('/') + 1);
    const Backend* same = find(fresh.name);
    if (same && same->path == path) return;
    try {
        if (same) throw Error(WEFT_ERROR_DEVICE, "a backend of its name is there already");
        fresh.table = load_plugin(path);
    } catch (const Error& error) {
        fresh.status = error.status();
        fresh.sentence = error.what();
    }
    const auto before =
        std::find_if(backends_.begin(), backends_.end(), [&](const Backend& b) { return b.path == path; });
    Backend& listed = before == backends_.end() ? backends_.emplace_back() : *before;
    listed = std::move(fresh);
    if (listed.status != WEFT_OK)
        throw Error(listed.status, "refused ", path.substr(path.rfind('/') + 1), ": ", listed.sentence);
}

std::uint32_t Registry::count(Backend& backend)
{
    if (backend.status != WEFT_OK) return 1; // the entry that says why
    if (!backend.counted) {
        backend.devices = backend.table.device_count();
        backend.counted = true;
    }
    return backend.devices;
}

weft_device_info Registry::info(Backend& backend, std::uint32_t index)
{
    weft_device_info info{};
    info.size = sizeof info;
    if (backend.status != WEFT_OK) {
        info.status = backend.status;
        copy_text(info.name, sizeof info.name, backend.name);
        copy_text(info.description, sizeof info.description, backend.sentence);
        return info;
    }
    backend.table.device_info(index, &info);
    info.size = sizeof info;
    info.name[sizeof info.name - 1] = 0;
    info.description[sizeof info.description - 1] = 0;
    const std::string part = info.name;
    copy_text(info.name, sizeof info.name, part.empty() ? backend.name : backend.name + ":" + part);
    return info;
}

std::uint32_t Registry::device_count()
{
    const std::lock_guard lock(mutex_);
    std::uint32_t sum = 0;
    for (Backend& backend : backends_) sum += count(backend);
    return sum;
}

weft_device_info Registry::device(std::uint32_t index)
{
    const std::lock_guard lock(mutex_);
    std::uint32_t before = 0;
    for (Backend& backend : backends_) {
        const std::uint32_t own = count(backend);
        if (index - before < own) return info(backend, index - before);
        before += own;
    }
    throw Error(WEFT_ERROR_ARGUMENT, "weft_device_get: index is ", index, ", there are ", before, " devices");
}

void Registry::load(const std::string& path)
{
    require(!path.empty() && path[0] == '/', "weft_backend_load: path is \"", path, "\", which is not absolute");
    const std::lock_guard lock(mutex_);
    add(path);
}

bool Registry::first_usable(Backend& backend, bool exact, Device_choice& choice)
{
    for (std::uint32_t i = 0; i < count(backend); ++i) {
        choice = {backend.table, i, info(backend, i)};
        if (choice.info.status == WEFT_OK && (choice.info.exact == 1 || !exact)) return true;
    }
    return false;
}

Device_choice Registry::scalar() { return choose("scalar", "scalar"); }

Device_choice Registry::choose(const char* name, const char* function)
{
    const std::lock_guard lock(mutex_);
    Device_choice choice;
    if (!name) {
        for (const char* cpu : {"simd", "scalar"})
            if (Backend* backend = find(cpu); backend && first_usable(*backend, true, choice)) return choice;
        fail("scalar", function);
    }
    const std::string full = name, wanted = full.substr(0, full.find(':'));
    Backend* backend = find(wanted);
    if (!backend) fail(name, function);
    if (wanted == full) {
        if (first_usable(*backend, false, choice)) return choice;
        fail(name, function);
    }
    for (std::uint32_t i = 0; i < count(*backend); ++i) {
        choice = {backend->table, i, info(*backend, i)};
        if (full != choice.info.name) continue;
        if (choice.info.status == WEFT_OK) return choice;
        throw Error(WEFT_ERROR_DEVICE, function, ": options->device \"", name,
                    "\" cannot be used: ", choice.info.description);
    }
    fail(name, function);
}

/// Says why there is no such device: its backend was refused, has none, has others, or is not there.
void Registry::fail(const char* name, const char* function)
{
    const std::string full = name, wanted = full.substr(0, full.find(':'));
    std::string names, why;
    for (Backend& backend : backends_) {
        if (backend.name == wanted && backend.status != WEFT_OK) why = "; the backend was refused: " + backend.sentence;
        if (backend.name == wanted && backend.status == WEFT_OK) {
            for (std::uint32_t i = 0; i < count(backend); ++i) {
                const weft_device_info each = info(backend, i);
                why += (why.empty() ? "; it has " : ", ") + std::string(each.name);
                if (each.status != WEFT_OK) why += " (" + std::string(each.description) + ")";
            }
            if (why.empty()) why = "; the backend has no device here";
        }
        if (backend.status == WEFT_OK) names += (names.empty() ? "" : ", ") + backend.name;
    }
    if (why.empty()) why = "; the backends are " + names;
    throw Error(WEFT_ERROR_DEVICE, function, ": options->device \"", full.substr(0, 64), "\": no such device", why);
}

} // namespace weft
