#pragma once

#include <cstddef>
#include <string>

namespace nacre {

/// Memory in bytes that this process may still allocate: what the system calls available, within
/// the limits of its control group and of its address space (ulimit -v).
std::size_t available_memory();

/// Refuses work before it starts that needs more memory than available_memory().
/// @param what    needs it, as in "solving 31 wavelengths"
/// @param remedy  what to change, as in "solve fewer wavelengths at a time"
/// @throws Error "`what` takes 12.3 GB of memory, and 4.5 GB are free: `remedy`"
void require_memory(double bytes, const std::string& what, const std::string& remedy);

}  // namespace nacre
