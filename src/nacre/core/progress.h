#pragma once

#include <functional>

// The library is silent: long work reports through a callback and asks it whether to go on. The
// command line turns the callback into a bar with an estimate (core/progress_bar.h).

namespace nacre {

/// Called now and then, from one thread at a time, with the fraction done in [0, 1].
/// Returning false asks the work to stop at the next safe point.
using Progress = std::function<bool(double fraction)>;

}  // namespace nacre
