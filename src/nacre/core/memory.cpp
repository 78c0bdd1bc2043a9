#include "nacre/core/memory.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>

#include "nacre/core/error.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

// The number that a file consists of; empty if there is no such file, or it says "max".
std::optional<std::uint64_t> number_in(const fs::path& path) {
    std::ifstream file(path);
    std::uint64_t number = 0;
    if (file >> number) return number;
    return std::nullopt;
}

// The number after a key, in a file of such lines.
std::optional<std::uint64_t> number_after(const std::string& key, const fs::path& path) {
    std::ifstream file(path);
    for (std::string word; file >> word;) {
        std::uint64_t number = 0;
        if (word == key && file >> number) return number;
    }
    return std::nullopt;
}

// The value of a key of /proc/meminfo or /proc/self/status, whose lines are "Key:   123 kB".
std::optional<std::uint64_t> bytes_of(const char* path, const std::string& key) {
    const auto kilobytes = number_after(key, path);
    if (!kilobytes) return std::nullopt;
    return 1024 * *kilobytes;
}

std::uint64_t difference(std::uint64_t limit, std::uint64_t used) {
    return limit > used ? limit - used : 0;
}

// The files of a control group that say what it may use and uses, and the key of its memory.stat
// for the pages of files that were not read lately.
struct GroupFiles {
    const char *limit, *used, *unread;
};
constexpr GroupFiles kVersion1{"memory.limit_in_bytes", "memory.usage_in_bytes",
                               "total_inactive_file"};
constexpr GroupFiles kVersion2{"memory.max", "memory.current", "inactive_file"};

// The least that is left in a group and those above it. A container may see its own group as the
// root, or be told a path that it does not see: groups without these files are passed over.
std::uint64_t left_in(fs::path group, const fs::path& mounted, const GroupFiles& files) {
    std::uint64_t left = UINT64_MAX;
    for (bool done = false; !done; group = group.parent_path()) {
        done = group.empty();
        const fs::path folder = mounted / group;
        const auto limit = number_in(folder / files.limit);
        if (!limit) continue;
        const std::uint64_t used = number_in(folder / files.used).value_or(0);
        const std::uint64_t unread = number_after(files.unread, folder / "memory.stat").value_or(0);
        left = std::min(left, difference(*limit, difference(used, unread)));
    }
    return left;
}

}  // namespace

// Lines of the file are "number:controllers:path"; without controllers, version 2.
std::uint64_t detail::control_group_memory(const fs::path& membership, const fs::path& mounted) {
    std::uint64_t left = left_in({}, mounted, kVersion2);
    std::ifstream file(membership);
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) continue;
        const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
        const fs::path group = fs::path(line.substr(second + 1)).relative_path();
        if (controllers == ",,") {
            left = std::min(left, left_in(group, mounted, kVersion2));
        } else if (controllers.find(",memory,") != std::string::npos) {
            left = std::min(left, left_in(group, mounted / "memory", kVersion1));
        }
    }
    return left;
}

std::size_t available_memory() {
    std::uint64_t free = UINT64_MAX;
    if (const auto available = bytes_of("/proc/meminfo", "MemAvailable:")) {
        free = *available;
    } else {  // no /proc
        free = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
               static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    }
    free = std::min(free, detail::control_group_memory("/proc/self/cgroup", "/sys/fs/cgroup"));
    rlimit space{};
    if (getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY) {
        free = std::min(
            free, difference(space.rlim_cur, bytes_of("/proc/self/status", "VmSize:").value_or(0)));
    }
    return static_cast<std::size_t>(std::min<std::uint64_t>(free, SIZE_MAX));
}

void require_memory(double bytes, const std::string& what, const std::string& remedy) {
    constexpr double kGigabyte = 1e9;
    const auto available = static_cast<double>(available_memory());
    if (bytes <= available) return;
    throw Error(fmt::format("{} takes {:.1f} GB of memory, and {:.1f} GB are free: {}", what,
                            bytes / kGigabyte, available / kGigabyte, remedy));
}

}  // namespace nacre
