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

// The number that a file consists of; empty if there is no such file, or it says "max".
std::optional<std::uint64_t> number_in(const char* path) {
    std::ifstream file(path);
    std::uint64_t number = 0;
    if (file >> number) return number;
    return std::nullopt;
}

// The value of a key of /proc/meminfo or /proc/self/status, whose lines are "Key:   123 kB".
std::optional<std::uint64_t> bytes_of(const char* path, const std::string& key) {
    std::ifstream file(path);
    for (std::string word; file >> word;) {
        std::uint64_t kilobytes = 0;
        if (word == key && file >> kilobytes) return 1024 * kilobytes;
    }
    return std::nullopt;
}

std::uint64_t difference(std::uint64_t limit, std::uint64_t used) {
    return limit > used ? limit - used : 0;
}

}  // namespace

std::size_t available_memory() {
    std::uint64_t free = UINT64_MAX;
    if (const auto available = bytes_of("/proc/meminfo", "MemAvailable:")) {
        free = *available;
    } else {  // no /proc
        free = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
               static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    }
    if (const auto limit = number_in("/sys/fs/cgroup/memory.max")) {
        free = std::min(free,
                        difference(*limit, number_in("/sys/fs/cgroup/memory.current").value_or(0)));
    }
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
