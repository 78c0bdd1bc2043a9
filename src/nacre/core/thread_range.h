#pragma once

#include "nacre/core/error.h"

namespace nacre {

/// Threads that may be asked for, by the command line as by Python; 0: all the machine has.
inline constexpr Range kThreadRange{0, 4096};

}  // namespace nacre
