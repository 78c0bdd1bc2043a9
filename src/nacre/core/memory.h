#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace nacre {

/// Memory in bytes that this process may still allocate: what the system calls available, within
/// the limits of its control groups and of its address space (ulimit -v).
std::size_t available_memory();

/// Refuses work before it starts that needs more memory than available_memory().
/// @param what    needs it, as in "solving 31 wavelengths"
/// @param remedy  what to change, as in "solve fewer wavelengths at a time"
/// @throws Error "`what` takes 12.3 GB of memory, and 4.5 GB are free: `remedy`"
void require_memory(double bytes, const std::string& what, const std::string& remedy);

namespace detail {

/// What the control groups of a process, version 1 or 2, leave it: the least of its own and of
/// those above it, each its limit less what is used. Pages of files that were not read lately do
/// not count, as they are dropped when memory is short. The largest number if none has a limit.
/// @param membership  /proc/self/cgroup
/// @param mounted     /sys/fs/cgroup
std::uint64_t control_group_memory(const std::filesystem::path& membership,
                                   const std::filesystem::path& mounted);

}  // namespace detail

}  // namespace nacre
