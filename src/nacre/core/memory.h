#pragma once

#include <cstddef>

namespace nacre {

/// Memory in bytes that this process may still allocate: what the system calls available, within
/// the limits of its control group and of its address space (ulimit -v).
std::size_t available_memory();

}  // namespace nacre
